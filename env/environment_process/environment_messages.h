// SPDX-License-Identifier: Apache-2.0
#pragma once

// The messages of the environment protocol, as JSON: what Jaywalk asks, and how a world introduces
// itself. The number of a question is added when it is sent.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "interpreter/term/symbol.h"
#include <jaywalk/environment.h>

namespace jaywalk {

/// The version that is spoken.
inline constexpr int kEnvironmentProtocol = 1;

/// A world's answer to `hello`.
struct EnvironmentIdentity {
  /// A percept or an action: `at(X,Y)`.
  struct Word {
    std::string form;
    std::string meaning;
  };

  std::string name;
  std::string version;
  double tick_ms = 1000;
  /// It lives by the wall clock; ticks are as long as they are.
  bool free_running = false;
  /// Equal seeds and actions have equal consequences.
  bool deterministic = false;
  /// All the percepts and actions that there are; nothing if it does not declare them.
  std::optional<std::vector<Word>> percepts;
  std::optional<std::vector<Word>> actions;
};

/// `arguments`: terms as text.
[[nodiscard]] nlohmann::json environment_hello(std::span<const std::string> arguments);

/// Returns a message about the first error in the answer, or an empty text.
[[nodiscard]] std::string read_environment_hello(const nlohmann::json& answer,
                                                 EnvironmentIdentity& identity);

/// An action of a tick.
[[nodiscard]] nlohmann::json action_json(std::string_view agent, const ActionRequest& action,
                                         const SymbolTable& symbols);

/// A literal as it is written in a program.
[[nodiscard]] std::string literal_text(Predicate predicate, std::span<const Value> args,
                                       const SymbolTable& symbols);

}  // namespace jaywalk
