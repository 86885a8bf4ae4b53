// SPDX-License-Identifier: Apache-2.0
#pragma once

// Programs whose agents keep to themselves. Since it cannot be observed in which order such agents
// reason, each may do so for several steps in a row, while its memory is at hand
// (mas/system.cpp).

#include "interpreter/program/program.h"

namespace jaywalk {

/// Whether agents that run the program never do anything that others could notice: there is no
/// action, no internal action, no formula that becomes known at run time only, and no plan for
/// messages or for what the system reports to its agents. (Warnings are logged all the same.)
[[nodiscard]] bool keeps_to_itself(const Program& program);

}  // namespace jaywalk
