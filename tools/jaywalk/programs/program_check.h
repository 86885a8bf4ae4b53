// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checks one program that is loaded already, for `jaywalk check` and the language server.

#include <functional>
#include <optional>
#include <set>
#include <string>

#include "env/environments.h"
#include "experiment/scenario/scenario.h"
#include "interpreter/check/check.h"
#include "interpreter/logic/action_registry.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// Compiles and checks a program that was loaded with the diagnostics `found`, and adds to them; a
/// program with errors is not checked further. `complete` adds what is known of the agent to the
/// environment's vocabulary (null: none is known).
void check_loaded(const SourceTree& program, const EnvironmentKind* environment,
                  const std::function<void(Vocabulary&)>& complete, Diagnostics& found);

/// The programs checked and the diagnostics reported so far, so that nothing is reported twice.
struct Checked {
  /// Programs, by their normal paths.
  std::set<std::string> programs;
  /// Diagnostics, as text.
  std::set<std::string> said;
};

/// Adds to `found` the diagnostics that were not reported before.
void add_news(const Diagnostics& news, Checked& checked, Diagnostics& found);

/// Checks the programs that a scenario names: its behaviours', with their teams, and its actors'.
/// Diagnostics that another scenario with the same program had already are left out. A missing
/// include is an error.
void check_programs(const Scenario& scenario, Checked& checked, Diagnostics& found);

/// Whether a program was started by itself or as one of a project.
enum class StartedAs { alone, part };

/// The words of the agents' world: null if they are not known. Nothing: those of the environment
/// that the program seems to be written for.
using KnownWorld = std::optional<const EnvironmentKind*>;

/// Runs the checker alone on a program that compiles. `actions`: the internal actions and functions
/// that it was compiled with; null: the standard ones.
void check_compiled(const SourceTree& program, const std::string& path, StartedAs started,
                    KnownWorld world, const ActionRegistry* actions, Diagnostics& found);

/// Compiles and checks a program by itself, for the environment that it seems to be written for.
void check_alone(const SourceTree& program, const std::string& path, Diagnostics& found);

}  // namespace jaywalk
