// SPDX-License-Identifier: Apache-2.0
#pragma once

// Completion at the prompt of `jaywalk repl`: commands after a colon, goals after an exclamation
// mark, internal actions after a full stop, elsewhere beliefs, goals and functions.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// The names that an agent knows.
struct ReplNames {
  std::vector<std::string> commands;    // without the colon
  std::vector<std::string> predicates;  // of beliefs and rules
  std::vector<std::string> goals;       // that there are plans for
  std::vector<std::string> actions;     // internal ones and functions, `.print`, `math.max`
};

struct Completion {
  /// The letters before the cursor that a candidate replaces.
  std::size_t replaced = 0;
  /// Sorted, without duplicates.
  std::vector<std::string> candidates;
  /// The longest common beginning of all candidates.
  [[nodiscard]] std::string common() const;
};

/// `before` is the line up to the cursor.
[[nodiscard]] Completion complete_input(std::string_view before, const ReplNames& names);

}  // namespace jaywalk
