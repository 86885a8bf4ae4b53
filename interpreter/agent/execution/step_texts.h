// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texts of plan bodies' formulas for messages about their failure.

#include <string>

#include "interpreter/agent/circumstance/intention.h"
#include "interpreter/logic/action.h"
#include "interpreter/logic/unifier/unifier.h"

namespace jaywalk {

/// A formula without its operator, with the variables' names in place of their values.
[[nodiscard]] std::string text_as_written(Unifier& unifier, const Plan& plan, const Step& step);

/// error(constraint_failed) of the intention's current formula. As in Jason the message has the
/// remaining formulas of the body and the values of the plan's variables, in the order of the text.
[[nodiscard]] ActionError constraint_failure(Unifier& unifier, Intention& intention);

}  // namespace jaywalk
