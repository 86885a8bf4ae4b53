#pragma once

// The words that the checker takes as known: internal actions, and the percepts and actions of the
// world that a program is for.

#include "env/environments.h"
#include "interpreter/check/check.h"

namespace jaywalk {

/// For a program in that environment; without one, for a program in a world that we do not know.
[[nodiscard]] Vocabulary vocabulary_for(const EnvironmentKind* environment);

/// The environment that a program seems to be written for, since it takes one of its actions; null
/// if there is none.
[[nodiscard]] const EnvironmentKind* environment_of(const SourceTree& program);

}  // namespace jaywalk
