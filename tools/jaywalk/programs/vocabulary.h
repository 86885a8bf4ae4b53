// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words that the checker takes as known: internal actions, and the percepts and actions of the
// world that a program is for.

#include <string>
#include <vector>

#include "env/environments.h"
#include "experiment/scenario/scenario.h"
#include "interpreter/check/check.h"
#include "interpreter/check/index/program_index.h"
#include "interpreter/logic/action_registry.h"

namespace jaywalk {

/// For a program in that environment; without one, for a program in a world that we do not know.
[[nodiscard]] Vocabulary vocabulary_for(const EnvironmentKind* environment);

/// Adds the internal actions and functions that are none of the standard ones.
void add_own_actions(const ActionRegistry& actions, Vocabulary& vocabulary);

/// The environment that a program seems to be written for: it takes its actions and no others, and
/// has its percepts or the values of its actions, too. Null if there is none.
[[nodiscard]] const EnvironmentKind* environment_of(const SourceTree& program);
[[nodiscard]] const EnvironmentKind* environment_of(const ProgramWords& words);

/// Marks the percepts that agents never have in the world of a scenario. REQUIRES: the vocabulary
/// is that of the environment `crossing`, the world of all scenarios.
void mark_absent_percepts(const Scenario& scenario, Vocabulary& vocabulary);

/// The values that a scenario gives the initial beliefs of a program.
[[nodiscard]] std::vector<Vocabulary::Setting> settings_of(const Scenario& scenario,
                                                           const std::string& program);

}  // namespace jaywalk
