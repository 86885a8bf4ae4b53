#pragma once

#include <string>
#include <vector>

namespace jaywalk {

/// Runs another program to its end: its exit status; 127 if there is none of that name.
[[nodiscard]] int run_program(std::vector<std::string> words);

}  // namespace jaywalk
