// SPDX-License-Identifier: Apache-2.0
#pragma once

// The goals and formulas of an intention as text, for people.

#include <functional>
#include <span>
#include <string>

#include "interpreter/agent/circumstance/intention.h"
#include "interpreter/term/print.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

class Agent;

/// A term as text; of a literal without its annotations. With `most`, here and below: at most so
/// many bytes, and "..." if that is not all.
[[nodiscard]] std::string plain_text(Value term, const SymbolTable& symbols,
                                     std::size_t most = kMaxTextBytes);

/// The text of a literal, from its parts.
[[nodiscard]] std::string literal_text(Predicate predicate, std::span<const Value> args,
                                       const SymbolTable& symbols,
                                       std::size_t most = kMaxTextBytes);

/// The goal of a means: `cross(left)`; `-g` for its failure, `+b` of a belief's event.
[[nodiscard]] std::string goal_text(const Intention& intention, const IntendedMeans& means,
                                    const SymbolTable& symbols, std::size_t most = kMaxTextBytes);

/// The outermost first, each with the line that it has come to: `go (x.asl:2) > cross (x.asl:5)`.
/// The goals in the middle of a deep stack are left out.
[[nodiscard]] std::string goal_stack_text(const Intention& intention, const SymbolTable& symbols);

/// The place of the intention's current formula, `x.asl:2:21`; empty if it was made at run time.
[[nodiscard]] std::string formula_place(const Intention& intention);

/// Calls `show` with a term of the intention's current formula, in which variables have the values
/// of now; not if there is no such term (it divides by zero, there is no memory for it). The agent
/// draws the same random numbers afterwards, so that it does the same whether it is observed or
/// not.
void show_with_values(Agent& agent, const Intention& intention, Value term,
                      const std::function<void(Value)>& show);

/// A formula that an intention is about to execute, with the values of now, or without any where
/// show_with_values() shows nothing. Empty if it was not written in a program.
[[nodiscard]] std::string formula_with_values(Agent& agent, const Intention& intention,
                                              const Step& step);

}  // namespace jaywalk
