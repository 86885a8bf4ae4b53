#pragma once

// The search space of the pedestrians' world: numbers and words of a scenario that a search may
// choose, and the cells where the pedestrians start. Read experiment/scenario.h before.

#include <string>
#include <vector>

#include "env/crossing/parameters.h"
#include "search/test_input.h"

namespace jaywalk::search {

/// A key of the scenario and what it may be: a range or some words.
struct CrossingDimension {
  /// Its dotted path, `world.av.speed`.
  std::string key;
  double from = 0;
  double to = 0;
  enum class Kind { number, whole, word } kind = Kind::number;
  std::vector<std::string> words;
};

/// Vectors: each dimension, then row and cell of each pedestrian whose start is searched.
class CrossingSpace : public SearchSpace {
 public:
  /// `rows`: those on which pedestrians may start. `cells`: the length of the road.
  CrossingSpace(std::vector<CrossingDimension> dimensions, std::vector<int> rows, int cells,
                std::uint32_t searched_starts)
      : dimensions_(std::move(dimensions)),
        rows_(std::move(rows)),
        cells_(cells),
        searched_starts_(searched_starts) {}

  [[nodiscard]] std::size_t dimension() const override {
    return std::max<std::size_t>(1, dimensions_.size() + 2 * searched_starts_);
  }
  [[nodiscard]] std::optional<SequenceBounds> sequences() const override { return std::nullopt; }
  /// Every vector within the ranges can be executed.
  [[nodiscard]] Validity check(const TestInput& input) const override;
  [[nodiscard]] TestInput draw_initial(Random& random) const override;
  [[nodiscard]] TestInput as_points(const TestInput& input) const override { return input; }
  [[nodiscard]] std::vector<double> signature(const TestInput& input) const override {
    return input.values;
  }

  /// `key=value` of each dimension, as for --set.
  [[nodiscard]] std::vector<std::string> settings(const TestInput& input) const;
  /// Where the pedestrians start; empty if chance decides.
  [[nodiscard]] std::vector<Position> starts(const TestInput& input) const;

 private:
  std::vector<CrossingDimension> dimensions_;
  std::vector<int> rows_;
  int cells_;
  std::uint32_t searched_starts_;
};

}  // namespace jaywalk::search
