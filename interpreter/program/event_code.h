#pragma once

// Heads of plans, and arguments of the formulas that make events, decoded when a plan is compiled:
// what otherwise would have to be found out from the terms in every cycle. What is not of a usual
// kind is left to the unifier.

#include <cstdint>
#include <optional>
#include <vector>

#include "interpreter/logic/code/operand.h"
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

/// A plan's trigger.
struct PlanHead {
  /// All its arguments are constants and variables, each of which stands there once, and it has no
  /// annotations. Then the goal of a means can be told from the frame.
  bool is_decoded = false;
  Predicate predicate{};
  std::vector<HeadArgument> args;
  /// Slots below this one get values of the event; the others have none at first.
  std::uint32_t first_to_clear = 0;
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

/// Of a plan with this trigger, a template.
[[nodiscard]] PlanHead decode_head(Value trigger);
/// Of the literal of a goal or a change of belief.
[[nodiscard]] EventCode decode_event(Value term);

}  // namespace jaywalk
