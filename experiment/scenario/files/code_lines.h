#pragma once

// How long a program is: what it costs to write a behaviour (metric M6).

#include <cstdint>

#include "interpreter/syntax/load.h"

namespace jaywalk {

/// Lines that hold more than blanks and comments.
[[nodiscard]] std::uint64_t code_lines(const SourcePtr& program);

/// The same of a program and all that it includes, each file counted once.
[[nodiscard]] std::uint64_t code_lines(const SourceTree& tree);

}  // namespace jaywalk
