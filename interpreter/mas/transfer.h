#pragma once

// Terms on their way from one agent to another.

#include "interpreter/term/heap.h"

namespace jaywalk {

/// A copy of a term in another heap; constants of programs are shared, unbound variables become
/// fresh ones. REQUIRES: the programs outlive the heap.
[[nodiscard]] Value transfer(Value term, Heap& to);

}  // namespace jaywalk
