// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texts that become terms while an agent runs: `.term2string`, `.puts`, `.wait("+b(X)")`.

#include <optional>
#include <string_view>

#include "interpreter/logic/action.h"
#include "interpreter/program/plan_compiler.h"

namespace jaywalk {

/// The term that the text is, or nothing. A variable that the caller's plan or rule has, too, is
/// that one; others are new.
[[nodiscard]] std::optional<Value> read_term(std::string_view text, ActionCall& call);

/// As trigger_parts, but the term may be a text as well: `"+!g(X)"`, whose variables are as above.
[[nodiscard]] bool read_trigger(Value term, ActionCall& call, TriggerParts& parts);

}  // namespace jaywalk
