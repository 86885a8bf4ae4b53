#pragma once

// How roads turn around their failures, as the tool competition's sparseness compares it
// (failing_stretch.h), but in pieces of some metres, since many candidates are compared for each
// test. Read sites.h first.

#include <vector>

#include "search/generators/sites.h"

namespace jaywalk::search {

/// Degrees that the road turns by in each metre, of each piece of kTurnPiece_m within kPieces_m of
/// a place.
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
