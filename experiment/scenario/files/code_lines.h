#pragma once

// The length of a program, a measure of the effort to write a behaviour (metric M6).

#include <cstdint>

#include "interpreter/syntax/load.h"

namespace jaywalk {

/// Lines that hold more than blanks and comments.
[[nodiscard]] std::uint64_t code_lines(const SourcePtr& program);

/// Code lines of a program and all that it includes, each file counted once.
[[nodiscard]] std::uint64_t code_lines(const SourceTree& tree);

}  // namespace jaywalk
