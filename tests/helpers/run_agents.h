// SPDX-License-Identifier: Apache-2.0
#pragma once

// Runs of small programs, for the tests of agents.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"

namespace jaywalk::test {

struct NamedProgram {
  std::string name;
  std::string text;
  ReasoningSettings settings = {};
};

struct AgentRun {
  /// The printed lines, as `[agent] text`, and the logged ones.
  std::vector<std::string> printed;
  std::vector<std::string> logged;
  RunOutcome outcome;
  /// `line:column: message` of the errors for which a program was refused; then nothing ran.
  std::vector<std::string> errors;

  /// The lines that one agent printed.
  [[nodiscard]] std::vector<std::string> printed_by(std::string_view agent) const;
};

/// Runs the programs together until nothing more happens, or for 100,000 cycles of one agent if
/// the options have no limit. `make_environment` may add names to the table of the programs.
using EnvironmentMaker = std::function<std::unique_ptr<Environment>(SymbolTable&)>;
/// How far a system goes before it is asked to go on: as far as is best, or (without an
/// environment) one cycle of each agent.
enum class Steps : std::uint8_t { many, one };
[[nodiscard]] AgentRun run_agents(const std::vector<NamedProgram>& programs,
                                  MasOptions options = {},
                                  const EnvironmentMaker& make_environment = {},
                                  Steps steps = Steps::many, const IncludePath& includes = {});

/// Runs one agent, called `agent`; what it printed, without its name.
[[nodiscard]] std::vector<std::string> printed_by(std::string_view program,
                                                  MasOptions options = {});

}  // namespace jaywalk::test
