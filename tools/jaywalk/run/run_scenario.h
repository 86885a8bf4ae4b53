#pragma once

// Running one test of a scenario, perhaps drawn as it happens.

#include <string>

#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

[[nodiscard]] ExitCode run_scenario_file(const std::string& path, const Arguments& arguments,
                                         Console& console);

}  // namespace jaywalk
