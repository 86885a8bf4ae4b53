// SPDX-License-Identifier: Apache-2.0
#pragma once

// Texts and triggers that become plans while an agent runs (`.add_plan`); see term_reader.h for
// other terms.

#include <string>

#include "interpreter/logic/action.h"
#include "interpreter/term/heap.h"
#include "interpreter/term/texts_read.h"

namespace jaywalk {

/// The plan that a text denotes, with or without its final stop, as a term with fresh variables;
/// unset, and `problem` set, if it is none. The text is counted among `texts`.
[[nodiscard]] Value read_plan(const std::string& text, Heap& heap, SymbolTable& symbols,
                              const ActionRegistry& actions, TextsRead& texts,
                              std::string& problem);

/// A plan without context and body for a trigger term ({+!g} or {+b}); unset if it is no trigger.
[[nodiscard]] Value plan_of_trigger(Value trigger, Heap& heap, SymbolTable& symbols);

}  // namespace jaywalk
