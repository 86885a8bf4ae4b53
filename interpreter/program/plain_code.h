#pragma once

// What most plans are made of, prepared for strides (agent/stride.cpp, agent/plain.cpp): heads of
// constants and variables that differ, and arguments of goals and beliefs that are operands. Here
// it is said once, when a plan is compiled, what otherwise would have to be found out from the
// terms in every cycle.

#include <cstdint>
#include <optional>
#include <vector>

#include "interpreter/logic/operand.h"
#include "interpreter/program/trigger.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

class PlanLibrary;
class PlanList;

/// An argument of a plan's trigger: the slot that gets the event's argument, or (kNoSlot) a
/// constant.
struct HeadArgument {
  std::uint32_t slot = Operand::kNoSlot;
  Value constant;
};

/// A plan, as far as it is plain.
struct PlainPlan {
  /// All arguments of the trigger are in `head`.
  bool has_plain_head = false;
  Predicate predicate{};
  std::vector<HeadArgument> head;
};

/// A formula of a plan's body that makes an event: the arguments of its literal.
struct PlainStep {
  /// Empty, although the literal has arguments: some argument is another term.
  std::vector<Operand> args;
  /// The event that the formula makes, if any.
  std::optional<TriggerKey> event;
  /// The plans for it, if this is the library that the agent uses.
  const PlanLibrary* library = nullptr;
  const PlanList* plans = nullptr;
};

/// Of a plan with this trigger, a template.
[[nodiscard]] PlainPlan plain_plan(Value trigger);
/// Of the literal of a goal or a change of belief.
[[nodiscard]] PlainStep plain_step(Value term);

}  // namespace jaywalk
