#pragma once

// Running agents that live in no world: one program, or the agents of a Jason project.

#include <string>

#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

/// One agent, named after the file.
[[nodiscard]] ExitCode run_agent_file(const std::string& path, const Arguments& arguments,
                                      Console& console);
/// The agents of a `.mas2j` file.
[[nodiscard]] ExitCode run_project_file(const std::string& path, const Arguments& arguments,
                                        Console& console);

}  // namespace jaywalk
