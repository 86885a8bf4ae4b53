// SPDX-License-Identifier: Apache-2.0
#pragma once

// A quantity of a system under test whose values a search chooses: a number, a whole number or a
// word. A dimension of a search space has a number from -1 to 1 for it.

#include <optional>
#include <string>
#include <vector>

#include "env/config/reader.h"

namespace jaywalk::search {

struct Dimension {
  /// Its name: of a scenario the dotted path of the key, `world.av.speed`.
  std::string key;
  double from = 0;
  double to = 0;
  /// From one whole number to the next.
  int step = 1;
  enum class Kind { number, whole, word } kind = Kind::number;
  std::vector<std::string> words;

  /// How many values it has; 0: any two numbers may differ.
  [[nodiscard]] std::size_t distinct_values() const;
  /// The number that a value from -1 to 1 stands for. REQUIRES: not words.
  [[nodiscard]] double number(double value) const;
  /// number() or the word as text; numbers have six digits.
  [[nodiscard]] std::string text(double value) const;
};

/// The choice, of `count` equally wide ones, in which a value from -1 to 1 lies.
[[nodiscard]] std::size_t choice(double value, std::size_t count);

/// Without its key: `[from, to]`, `{whole: [from, to], step: 2}`, `[forward, back]`, `[1, 2, 4]` or
/// `[2]`. Nothing after reporting an error.
[[nodiscard]] std::optional<Dimension> read_dimension(const ConfigNode& node,
                                                      const ConfigReader& reader);

/// The keys of `{whole: [from, to], step: 2}`.
[[nodiscard]] std::vector<ConfigKey> whole_keys(Dimension& dimension, const ConfigReader& reader);
/// Reads `[from, to]` into the dimension; false after reporting an error.
bool read_bounds(const ConfigNode& node, const ConfigReader& reader, Dimension& dimension);

}  // namespace jaywalk::search
