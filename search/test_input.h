// SPDX-License-Identifier: Apache-2.0
#pragma once

// Test inputs of a system under test (SUT), and the space that they come from.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/networks/random.h"

namespace jaywalk::search {

using networks::mix_name;
using networks::Random;

/// How the numbers of a test input are meant.
enum class Form {
  /// A point of the search space: a number from -1 to 1 for each of its dimensions.
  vector,
  /// As many numbers as one likes, nominally from -1 to 1: what Frenetic calls a chromosome.
  sequence,
  /// The form into which both are converted: x and y of one road point after the other.
  points,
};

[[nodiscard]] std::string_view name(Form form);
[[nodiscard]] std::optional<Form> parse_form(std::string_view text);

struct TestInput {
  Form form = Form::vector;
  std::vector<double> values;

  friend bool operator==(const TestInput&, const TestInput&) = default;
};

/// Why an input cannot be executed; valid if there is no reason.
struct Validity {
  std::string message;

  [[nodiscard]] bool valid() const { return message.empty(); }
};

/// Which sequences make sense.
struct SequenceBounds {
  std::size_t least = 0;
  std::size_t usual = 0;
  /// Half the width of the range from which the usual length is drawn.
  std::size_t spread = 0;
  /// Metres that one element stands for, where it does.
  double element_m = 1;
};

/// Immutable; used by several searches at once.
class SearchSpace {
 public:
  SearchSpace() = default;
  SearchSpace(const SearchSpace&) = delete;
  SearchSpace& operator=(const SearchSpace&) = delete;
  virtual ~SearchSpace() = default;

  /// The dimension of its vectors.
  [[nodiscard]] virtual std::size_t dimension() const = 0;
  /// None if the space has vectors alone.
  [[nodiscard]] virtual std::optional<SequenceBounds> sequences() const = 0;
  /// How many values each dimension of a vector distinguishes, in equal parts of its range; 0: any
  /// two numbers may differ.
  [[nodiscard]] virtual std::vector<std::size_t> distinct_values() const {
    return std::vector<std::size_t>(dimension());
  }
  [[nodiscard]] virtual Validity check(const TestInput& input) const = 0;
  /// Whether check() has no objection.
  [[nodiscard]] virtual bool contains(const TestInput& input) const { return check(input).valid(); }
  /// A vector for the first tests of generators that learn; it need not be valid.
  [[nodiscard]] virtual TestInput draw_initial(Random& random) const = 0;
  /// The points of a road, the numbers of a scenario…: what people and other programs are shown.
  [[nodiscard]] virtual TestInput as_points(const TestInput& input) const = 0;
  /// The input in a line for people.
  [[nodiscard]] virtual std::string describe(const TestInput& input) const;
  /// Numbers whose Euclidean distance says how different two inputs are. REQUIRES: a valid input.
  [[nodiscard]] virtual std::vector<double> signature(const TestInput& input) const = 0;
  /// The same where angles do not jump by a full turn.
  [[nodiscard]] virtual std::vector<double> unwrapped_signature(const TestInput& input) const {
    return signature(input);
  }
};

// Random sequences: what `random-sequences` proposes, and what `graft` puts around its stretches.

/// By how much neighbours of a random sequence differ at most: 0.05 1/m of 0.07 (Frenetic's bound).
inline constexpr double kMostDifference = 0.05 / 0.07;

/// Appends `count` numbers from -1 to 1, each uniform among those that differ from the one before
/// it by kMostDifference at most; the very first one follows 0.
void append_random(std::vector<double>& values, int count, Random& random);

/// Its length is uniform among those that the bounds call usual.
[[nodiscard]] TestInput draw_sequence(const SequenceBounds& bounds, Random& random);

}  // namespace jaywalk::search
