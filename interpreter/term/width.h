#pragma once

// Handles a structure that would be wider than terms may be (support/width.h).

#include "interpreter/support/width.h"

namespace jaywalk {

/// Thrown when a structure would have more than kMostParts arguments; caught where the agent
/// executes a step.
struct TermTooWide {};

}  // namespace jaywalk
