// SPDX-License-Identifier: Apache-2.0
#pragma once

// The stretch of its road on which a test failed. Generators that vary earlier failures find many
// failing tests that are copies of one failure; comparing stretches counts failures that differ.
// Read run_summary.h first.

#include <optional>
#include <span>
#include <vector>

#include "env/lane/road.h"
#include "search/sut.h"

namespace jaywalk::search {

struct ExecutedTest;

/// One piece of a road's middle line and the turn from the piece before it.
struct RoadPiece {
  double turn_deg = 0;
  double length_m = 0;
};

/// How far a stretch reaches before the worst point and after it, and its pieces to either side.
inline constexpr double kStretchBefore_m = 40;
inline constexpr double kStretchAfter_m = 10;
inline constexpr double kPieces_m = 30;

/// The road around the point where the largest share of the car was out of its lane.
struct FailingStretch {
  /// From 40 m before that point to 10 m after it, a point every 2.5 m, moved and turned so that
  /// the worst point is the origin and the road heads along x there. Beyond its ends the road is
  /// taken to go straight on.
  lane::Polyline line;
  /// The road itself within 30 m of that point, about a metre each.
  std::vector<RoadPiece> pieces;
};

/// Whether the SUT drives on roads and measures `worst_arc_m`, so that its failing tests have
/// stretches.
[[nodiscard]] bool measures_stretches(const SutModel& model);

/// None if the SUT has none, or no road goes through the test's points.
[[nodiscard]] std::optional<FailingStretch> failing_stretch(const ExecutedTest& test,
                                                            const SutModel& model);

/// The point of the road's middle line beside which the car was farthest out of its lane; none if
/// that is not measured.
[[nodiscard]] std::optional<Point> worst_place(const ExecutedTest& test, const SutModel& model);

/// The largest distance between two points of the same number of two stretches' lines, in metres.
[[nodiscard]] double separation_m(const lane::Polyline& a, const lane::Polyline& b);
[[nodiscard]] inline double separation_m(const FailingStretch& a, const FailingStretch& b) {
  return separation_m(a.line, b.line);
}

/// How many clusters the stretches make (run_summary.h) if two are the same up to `reach_m`.
[[nodiscard]] std::size_t distinct(std::span<const FailingStretch> stretches, double reach_m);

/// The share of stretches, 0 to 1, that are within `reach_m` of another one; 0 for none.
[[nodiscard]] double twin_share(std::span<const FailingStretch> stretches, double reach_m);

/// The Levenshtein distance between the sequences of pieces, as the SBST tool competition of 2021
/// weighted it: to insert or delete a piece costs 1; to replace one costs nothing if the turns
/// differ by less than 0.3 degrees and the lengths by less than 0.2 m, else the mean of a / (1 + a)
/// and l / (1 + l), a and l those differences in degrees and metres.
[[nodiscard]] double edit_distance(std::span<const RoadPiece> a, std::span<const RoadPiece> b);

/// The competition's measure of diversity: the mean over the stretches of the largest edit distance
/// to another one; 0 for fewer than two. Of more than kMostCompared, as many are taken at equal
/// intervals.
[[nodiscard]] double sparseness(std::span<const FailingStretch> stretches);
inline constexpr std::size_t kMostCompared = 1000;

}  // namespace jaywalk::search
