// SPDX-License-Identifier: Apache-2.0
#pragma once

// Finds beliefs and plans that almost match a query or an event, a frequent error of programmers.

#include <string>

#include "interpreter/agent/agent.h"

namespace jaywalk {

/// Why a query about this predicate may have no answer, with the values that it had; empty if there
/// is nothing to say.
[[nodiscard]] std::string missing_belief_hint(const Agent& agent, Predicate asked);

/// A plan that an event without a plan may have been meant for; empty if there is none.
[[nodiscard]] std::string missing_plan_hint(const Agent& agent, const Event& event);

}  // namespace jaywalk
