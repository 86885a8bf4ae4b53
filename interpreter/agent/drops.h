// SPDX-License-Identifier: Apache-2.0
#pragma once

// Why an agent has dropped intentions: a formula failed, or a goal had no plan, and no plan was for
// that failure. Each agent counts its own; a program that drops its intentions by itself
// (`.drop_intention`) is not counted.

#include <cstdint>
#include <string>

namespace jaywalk {

struct DropCause {
  /// "action_failed", "no_relevant", ... (docs/reference/language/reasoning.md lists them).
  std::string error;
  /// The program's file and where in it the formula stands, from 1; empty and 0: nowhere.
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  /// The formula or goal, "move(rigth)", and its error, when it first failed; both may be empty,
  /// and long ones are cut.
  std::string formula;
  std::string message;
  /// The goals that were under way the first time, the outermost first, each with the line that it
  /// had come to: "go (x.asl:2) > cross (x.asl:5)".
  std::string goals;
  /// How often the same error has come from the same place.
  std::uint64_t times = 0;
};

/// "action_failed, x.asl:2:21, move(rigth): no such way".
[[nodiscard]] std::string describe(const DropCause& cause);

}  // namespace jaywalk
