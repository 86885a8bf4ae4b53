// SPDX-License-Identifier: Apache-2.0
#pragma once

// Finds the rules of a program whose answers cannot change during a run
// (logic/beliefs/folded_rules.h), and asks them once.

#include <memory>
#include <vector>

#include "interpreter/logic/beliefs/constant_percepts.h"
#include "interpreter/logic/beliefs/folded_rules.h"
#include "interpreter/program/program.h"

namespace jaywalk {

/// The rules of all predicates that have rules alone, each of which asks, of constant percepts,
/// facts that the program begins with and other such rules, in an order in which every variable of
/// the head gets a value and no comparison or sum meets a variable without one. What is recursive,
/// takes long, or has many answers is left out. The program and the percepts outlive the result.
[[nodiscard]] std::vector<std::unique_ptr<const FoldedRules>> fold_rules(
    const Program& program, const ConstantPercepts& constants, SymbolTable& symbols);

}  // namespace jaywalk
