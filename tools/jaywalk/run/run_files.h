// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `run` and `judge` do with each kind of file.

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

/// One test of a scenario, perhaps drawn as it happens.
[[nodiscard]] ExitCode run_scenario_file(const std::string& path, const Arguments& arguments,
                                         Console& console);

/// `jaywalk judge --trace`: assertions and metrics over a drive from elsewhere.
[[nodiscard]] ExitCode judge_trace(const std::string& path, const Arguments& arguments,
                                   Console& console);

}  // namespace jaywalk
