// SPDX-License-Identifier: Apache-2.0
#pragma once

// The search space of named inputs: values, and signals that consist of pieces. Read dimension.h
// first.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "search/suts/dimension.h"
#include "search/test_input.h"

namespace jaywalk::search {

/// How a signal goes on between the values that are searched.
enum class Interpolation {
  /// Each value lasts for its piece, all pieces equally long.
  constant,
  /// The values are those of points equally far apart, from the beginning to the end.
  linear,
};

struct NamedInput {
  Dimension dimension;
  /// Values of a signal; 0: no signal, but one value.
  std::size_t pieces = 0;
  Interpolation interpolation = Interpolation::constant;

  [[nodiscard]] std::size_t size() const { return pieces == 0 ? 1 : pieces; }
};

struct InputSpaceSettings {
  std::vector<NamedInput> inputs;
  /// How long signals last; 0: the program knows.
  double duration_s = 0;
  /// Seconds between the samples of signals; 0: the program gets the pieces.
  double sample_s = 0;
};

/// Vectors: the values of one input after the other.
class InputSpace : public SearchSpace {
 public:
  /// REQUIRES: at least one input.
  explicit InputSpace(InputSpaceSettings settings);

  [[nodiscard]] std::size_t dimension() const override { return distinct_.size(); }
  [[nodiscard]] std::optional<SequenceBounds> sequences() const override { return std::nullopt; }
  [[nodiscard]] std::vector<std::size_t> distinct_values() const override { return distinct_; }
  [[nodiscard]] Validity check(const TestInput& input) const override;
  [[nodiscard]] TestInput draw_initial(Random& random) const override;
  [[nodiscard]] TestInput as_points(const TestInput& input) const override { return input; }
  [[nodiscard]] std::vector<double> signature(const TestInput& input) const override {
    return input.values;
  }
  [[nodiscard]] std::string describe(const TestInput& input) const override;

  /// The test as the program gets it (docs/reference/system_protocol.md), without its number.
  [[nodiscard]] nlohmann::json request(const TestInput& input) const;
  /// The inputs in words.
  [[nodiscard]] std::string text() const;

 private:
  /// The values of an input, which begin with `values`.
  [[nodiscard]] nlohmann::json json_of(const NamedInput& input, const double* values) const;
  [[nodiscard]] std::size_t samples() const;

  InputSpaceSettings settings_;
  std::vector<std::size_t> distinct_;
};

/// The key `inputs` of a SUT.
void read_inputs(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                 InputSpaceSettings& space);

/// Reports what is wrong with all of them together. `node`: the SUT's keys.
void check_inputs(const ConfigNode& node, const ConfigReader& reader,
                  const InputSpaceSettings& space);

}  // namespace jaywalk::search
