#pragma once

// What `check` says of one program, for those who have it already: `jaywalk check` and the language
// server.

#include <functional>
#include <string>

#include "env/environments.h"
#include "interpreter/check/check.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// Compiles and checks a program that was loaded with the diagnostics `found`, which are added to;
/// what is wrong already is not looked at further. `complete` turns what is known of the
/// environment (null: nothing) into what is known of the agent.
void check_loaded(const SourceTree& program, const EnvironmentKind* environment,
                  const std::function<void(Vocabulary&)>& complete, Diagnostics& found);

/// The same for a program by itself, for the environment that it seems to be written for.
void check_alone(const SourceTree& program, const std::string& path, Diagnostics& found);

}  // namespace jaywalk
