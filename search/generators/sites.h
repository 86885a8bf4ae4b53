// SPDX-License-Identifier: Apache-2.0
#pragma once

// Places on roads (or points of vector spaces) as `prospect` compares them: the samples of its
// model, the road's shape there, the known failures. Read search/test_input.h first.

#include <vector>

#include "env/lane/road.h"
#include "search/learn/severity_model.h"
#include "search/test_input.h"

namespace jaywalk::search {

/// A test and the place where it failed or is expected to.
struct Site {
  TestInput input;
  /// In values from the beginning; 0 in a vector, which fails as a whole.
  double place = 0;

  /// The value at the place. REQUIRES: a place within the input.
  [[nodiscard]] int at() const { return static_cast<int>(place); }
};

/// The properties of a site that are known without executing it.
class SiteView {
 public:
  explicit SiteView(const SearchSpace& space) : space_(space), sequences_(space.sequences()) {}

  /// For a sequence: the values from eight before the place to one after it, 0 where there are
  /// none, and the distances to its end and to its beginning. For a vector: its values.
  [[nodiscard]] std::vector<double> features(const Site& site) const;
  /// The length scales of the features: those that lie farther back matter less.
  [[nodiscard]] std::vector<learn::FeatureLength> lengths() const;

  /// The road's points from 40 m before the place to 10 m after it, every 5 m, seen from there;
  /// straight on beyond its ends. `shift_m`: a place so much farther along. Of a vector: its values
  /// times kVectorMetres. REQUIRES: `points` are those of the site's input (as_points()), not none.
  [[nodiscard]] lane::Polyline shape(const Site& site, const TestInput& points,
                                     double shift_m = 0) const;
  static constexpr double kVectorMetres = 5;

  /// How much road there is within 30 m of the place; 0 for a vector.
  [[nodiscard]] double surroundings_m(const Site& site) const;

 private:
  const SearchSpace& space_;
  std::optional<SequenceBounds> sequences_;
};

/// The failures that are known, by their shapes: those that differ from every earlier one by more
/// than half the reach, and those that differ by more than the reach.
class KnownFailures {
 public:
  explicit KnownFailures(double reach_m) : reach_m_(reach_m) {}

  void add(const lane::Polyline& shape, double surroundings_m);
  /// 0 for a shape that would count for a copy of a known one, to 1 for one that would not even at
  /// the whole reach.
  [[nodiscard]] double novelty(const lane::Polyline& shape) const;
  /// By how much a failure with so much road around it would differ in that from every known one,
  /// in metres; at most kMostDifference_m.
  [[nodiscard]] double surroundings_novelty_m(double surroundings_m) const;
  static constexpr double kMostDifference_m = 10;

 private:
  double reach_m_;
  std::vector<lane::Polyline> fine_;
  std::vector<lane::Polyline> coarse_;
  std::vector<double> surroundings_;
};

/// How a road turns around a failure, as the tool competition's sparseness compares it
/// (failing_stretch.h), but in pieces of some metres, since many candidates are compared for each
/// test: degrees that the road turns by in each metre, of each piece of kTurnPiece_m within
/// kPieces_m of a place.
using Turns = std::vector<double>;
inline constexpr double kTurnPiece_m = 5;

/// REQUIRES: `points` are those of the site's input, points_m apart from each other.
[[nodiscard]] Turns turns_near(const Site& site, const TestInput& points, double point_m);

/// As edit_distance() of roads, in its unit.
[[nodiscard]] double turns_distance(const Turns& a, const Turns& b);

/// The failures that are known, and to which other each is most unlike.
class KnownTurns {
 public:
  void add(const Turns& turns);
  /// By how much such a failure raises the sum over all failures of the distance to the most
  /// different one, less its mean: this times the number of failures is the growth of sparseness.
  /// Estimated from some of them; 0 if none is known.
  [[nodiscard]] double gain(const Turns& turns) const;

 private:
  std::vector<Turns> known_;
  std::vector<double> farthest_;
  double sum_ = 0;
};

}  // namespace jaywalk::search
