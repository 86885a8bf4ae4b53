#pragma once

// `jaywalk judge --trace`: assertions and metrics over a drive from elsewhere.

#include <string>

#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

[[nodiscard]] ExitCode judge_trace(const std::string& path, const Arguments& arguments,
                                   Console& console);

}  // namespace jaywalk
