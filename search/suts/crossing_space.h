// SPDX-License-Identifier: Apache-2.0
#pragma once

// The search space of the pedestrians' world: numbers and words of a scenario that a search may
// choose, and the cells where the pedestrians start. Read experiment/scenario/scenario.h first.

#include <string>
#include <vector>

#include "env/config/reader.h"
#include "env/crossing/parameters.h"
#include "experiment/scenario/scenario.h"
#include "search/suts/dimension.h"
#include "search/test_input.h"

namespace jaywalk::search {

/// The starts of pedestrians: each by itself in one of the rows and its cells, or all as in one of
/// the given choices; if there is neither, starts are random.
struct CrossingStarts {
  /// How many pedestrians' starts are searched.
  std::uint32_t searched = 0;
  std::vector<int> rows;
  /// The start cells of each of the rows; none is empty.
  std::vector<std::vector<int>> cells;
  std::vector<std::vector<Position>> given;
  /// The pedestrian's moves for each of these, in the form that `scripted` takes; none: not given.
  std::vector<std::string> moves;
};

/// Vectors: each dimension, then row and cell of each pedestrian whose start is searched, or which
/// of the given starts it is.
class CrossingSpace : public SearchSpace {
 public:
  /// `behaviour`: the behaviour with the moves; its parameters can be set without another scenario.
  CrossingSpace(std::vector<Dimension> dimensions, std::string behaviour, CrossingStarts starts);

  [[nodiscard]] std::size_t dimension() const override {
    return std::max<std::size_t>(1, distinct_.size());
  }
  [[nodiscard]] std::optional<SequenceBounds> sequences() const override { return std::nullopt; }
  [[nodiscard]] std::vector<std::size_t> distinct_values() const override;
  /// Every vector within the ranges can be executed.
  [[nodiscard]] Validity check(const TestInput& input) const override;
  [[nodiscard]] TestInput draw_initial(Random& random) const override;
  [[nodiscard]] TestInput as_points(const TestInput& input) const override { return input; }
  [[nodiscard]] std::vector<double> signature(const TestInput& input) const override {
    return input.values;
  }

  [[nodiscard]] std::string describe(const TestInput& input) const override;

  /// `key=value` of each dimension, as for --set.
  [[nodiscard]] std::vector<std::string> settings(const TestInput& input) const;
  /// Settings of the input that are not parameters of the behaviour, and those that are.
  [[nodiscard]] std::vector<std::string> world_settings(const TestInput& input) const;
  [[nodiscard]] std::vector<ParameterSetting> parameters(const TestInput& input) const;
  /// The start cells of the pedestrians; empty if they are random.
  [[nodiscard]] std::vector<Position> starts(const TestInput& input) const;

 private:
  /// Which of the given starts. REQUIRES: there are some.
  [[nodiscard]] std::size_t given_start(const TestInput& input) const;

  std::vector<Dimension> dimensions_;
  std::string behaviour_;
  /// The parameter's name, for each dimension; empty: it is none.
  std::vector<std::string> names_;
  CrossingStarts starts_;
  std::vector<std::size_t> distinct_;
};

/// Adds the dimensions of the map `parameters` of a SUT, which gives keys of a scenario that a
/// search chooses values of with their ranges, dotted or as maps within maps; replaces the range of
/// a key that is there already. `above`: what stands before each key. Errors go to the reader's
/// diagnostics.
void read_dimensions(const ConfigNode& node, const ConfigReader& reader,
                     std::vector<Dimension>& dimensions, const std::string& above = {});

}  // namespace jaywalk::search
