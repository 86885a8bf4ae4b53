#pragma once

// How wide terms may be: what counts arguments and variables has 16 bits.

#include <cstddef>

namespace jaywalk {

/// Arguments of a structure, and variables of a clause.
inline constexpr std::size_t kMostArguments = 65'535;

/// Thrown when a structure would have more arguments; caught where the agent executes a step.
struct TermTooWide {};

}  // namespace jaywalk
