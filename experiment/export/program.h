#pragma once

#include <string>
#include <vector>

namespace jaywalk {

/// Runs another program to its end: its exit status; 127 if there is none of that name. What it
/// writes to standard output is added to `output`, if there is one.
[[nodiscard]] int run_program(std::vector<std::string> words, std::string* output = nullptr);

}  // namespace jaywalk
