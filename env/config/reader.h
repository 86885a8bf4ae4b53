// SPDX-License-Identifier: Apache-2.0
#pragma once

// The parsed values of a scenario or another YAML file of settings, each with the place where it
// was written (experiment/scenario/scenario_yaml.h makes them), and typed values out of them: each
// function reports what it found and what it expected.

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "env/grid/grid.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// Where a value was given: a place in a file, or an option (`--set world.length=80`).
struct ValueOrigin {
  SourceSpan where;
  std::string option;
};

struct ConfigEntry;

/// A scalar, a list or a map as it was written; aliases are resolved.
struct ConfigNode {
  enum class Kind { null, scalar, list, map };

  Kind kind = Kind::null;
  std::string text;  // of a scalar
  ValueOrigin origin;
  std::vector<ConfigNode> items;     // of a list
  std::vector<ConfigEntry> entries;  // of a map, in the order of the file

  /// The value of a key of a map, or null.
  [[nodiscard]] const ConfigNode* find(std::string_view key) const;
};

struct ConfigEntry {
  std::string key;
  ValueOrigin origin;
  ConfigNode value;
};

void report(Diagnostics& diagnostics, const ValueOrigin& origin, std::string message,
            std::string hint = {});

struct NumberRange {
  double least = 0;
  double most = 0;
};

struct IntegerRange {
  std::int64_t least = 0;
  std::int64_t most = 0;
};

/// A word and its value.
template <class T>
struct Choice {
  std::string_view word;
  T value;
};

/// A key of a map and what to do with its value; `path` is the key's, with dots.
struct ConfigKey {
  std::string_view name;
  std::function<void(const ConfigNode& value, const std::string& path)> read;
};

/// Whether the first number of a pair may be the greater one.
enum class PairOrder { rising, any };

class ConfigReader {
 public:
  explicit ConfigReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Reads the keys of a map in the order of `keys`, so that the order of the file does not matter;
  /// others are errors.
  void read_map(const ConfigNode& node, const std::string& path,
                std::span<const ConfigKey> keys) const;

  [[nodiscard]] std::optional<double> number(const ConfigNode& node, NumberRange range) const;
  /// A speed. If it is written with a unit, the hint says what to write for the key `mps_key`,
  /// which is in m/s.
  [[nodiscard]] std::optional<double> speed(const ConfigNode& node, NumberRange range,
                                            std::string_view mps_key) const;
  [[nodiscard]] std::optional<std::int64_t> integer(const ConfigNode& node,
                                                    IntegerRange range) const;
  [[nodiscard]] std::optional<std::string> text(const ConfigNode& node,
                                                std::string_view expected) const;
  /// Two whole numbers, `[first, last]`, the first not the greater one.
  [[nodiscard]] std::optional<Interval> interval(const ConfigNode& node, IntegerRange range) const;
  [[nodiscard]] std::optional<std::array<double, 2>> number_pair(
      const ConfigNode& node, NumberRange range, PairOrder order = PairOrder::rising) const;
  /// One of some words.
  template <class T>
  [[nodiscard]] std::optional<T> choice(const ConfigNode& node,
                                        std::span<const Choice<T>> choices) const {
    std::vector<std::string> words;
    for (const Choice<T>& each : choices) {
      if (node.kind == ConfigNode::Kind::scalar && node.text == each.word) return each.value;
      words.emplace_back(each.word);
    }
    report_choice(node, words);
    return std::nullopt;
  }

  void error(const ValueOrigin& origin, std::string message, std::string hint = {}) const;
  /// Reports errors of another file, which the value at `origin` names: at their places in that
  /// file if they have any, otherwise at `origin`.
  void error_in(const ValueOrigin& origin, const Diagnostics& found) const;
  /// `expected X, found Y`.
  void unexpected(const ConfigNode& node, std::string_view expected, std::string hint = {}) const;

 private:
  void report_choice(const ConfigNode& node, std::span<const std::string> words) const;

  Diagnostics& diagnostics_;
};

/// A number if the whole text is one.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

// Ranges of numbers that several keys of a scenario share: generous, but small enough that products
// of them do not overflow.
inline constexpr IntegerRange kCells{1, 100'000};
inline constexpr IntegerRange kCellsFromAnywhere{-100'000, 100'000};
inline constexpr IntegerRange kRows{0, 999};
/// In the unit of its key, cells or metres a second.
inline constexpr NumberRange kSpeed{0.01, 10'000};
/// In seconds.
inline constexpr NumberRange kWindow{0, 3600};

/// An error in a section of a scenario: values that do not fit together.
struct ParameterProblem {
  /// The parameter as scenarios spell it, `world.av.rows`.
  std::string path;
  std::string message;
};

}  // namespace jaywalk
