// SPDX-License-Identifier: Apache-2.0
#pragma once

// Heads of plans, and arguments of the formulas that make events, decoded when a plan is compiled:
// what otherwise would have to be found out from the terms in every cycle. What is not of a usual
// kind is left to the unifier. Heads are matched as those of rules are (logic/code/head_code.h).

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "interpreter/logic/code/head_code.h"
#include "interpreter/logic/code/operand.h"
#include "interpreter/program/trigger.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

class PlanLibrary;
class PlanList;

/// A plan's trigger.
struct PlanHead {
  /// It is a literal without annotations, whose arguments are matched step by step; else the
  /// unifier matches it as a whole.
  bool is_decoded = false;
  /// The goal of a means can be rebuilt from the trigger and the frame: all arguments are
  /// variables, numbers, atoms, and lists of a variable and a variable.
  bool tells_goal = false;
  Predicate predicate{};
  HeadCode code;
};

/// A formula of a plan's body that makes an event, `!g(X+1)`, `+b`.
struct EventCode {
  static constexpr std::size_t kMostArguments = 8;
  /// All arguments of its literal are operands, not too many, and it has no annotations.
  bool is_decoded = false;
  Predicate predicate{};
  std::vector<Operand> args;
  /// The event that the formula makes, if that is known.
  std::optional<TriggerKey> event;
  /// Whether the means of the formula gives way to the one of its goal, as far as that is known: it
  /// is its plan's last formula and has the plan's own goal.
  enum class LastCall : std::uint8_t { no, yes, unknown };
  LastCall last_call = LastCall::unknown;
  /// The plans for it, if this is the library that the agent uses.
  const PlanLibrary* library = nullptr;
  const PlanList* plans = nullptr;
};

/// Decodes a plan's trigger, a template; `inherits` are the slots that have a value before.
[[nodiscard]] PlanHead decode_head(Value trigger, std::span<const Symbol> slot_names,
                                   std::span<const std::uint32_t> inherits = {});
/// Decodes the literal of a goal or a change of belief.
[[nodiscard]] EventCode decode_event(Value term);

}  // namespace jaywalk
