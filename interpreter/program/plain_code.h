#pragma once

// What most plans are made of, prepared for strides (agent/stride.cpp, agent/plain.cpp): arguments
// that are constants, variables or plain sums, heads of constants and variables that differ, and
// conditions that compare two of those. Here it is said once, when a plan is compiled, what
// otherwise would have to be found out from the terms in every cycle.
//
// It refers to no cells of a heap but a program's.

#include <cstdint>
#include <optional>
#include <vector>

#include "interpreter/logic/code.h"
#include "interpreter/program/trigger.h"
#include "interpreter/term/heap.h"

namespace jaywalk {

class PlanLibrary;
class PlanList;

/// A constant, the value of a slot, or `N-1`, `X + V`: a sum, difference or product of two
/// slots or numbers.
struct Operand {
  enum class Kind : std::uint8_t { constant, slot, add, subtract, multiply, other };
  static constexpr std::uint32_t kNoSlot = 0xFFFF'FFFFU;

  /// A template; `other` if it is nothing of this kind.
  [[nodiscard]] static Operand of(Value term);

  Kind kind = Kind::other;
  std::uint32_t left_slot = kNoSlot;  // kNoSlot: the number
  std::uint32_t right_slot = kNoSlot;
  Value left;  // a constant itself
  Value right;
};

/// An argument of a plan's trigger: the slot that gets the event's argument, or (kNoSlot) a
/// constant.
struct HeadArgument {
  std::uint32_t slot = Operand::kNoSlot;
  Value constant;
};

/// `N > 0`, `X = A + B`: a comparison, or a unification, of two operands.
struct PlainTest {
  Predicate op{};
  Operand left;
  Operand right;
};
/// A plan, as far as it is plain.
struct PlainPlan {
  /// All arguments of the trigger are in `head`.
  bool has_plain_head = false;
  /// There is no context, or all of it is in `tests`.
  bool has_plain_context = false;
  Predicate predicate{};
  std::vector<HeadArgument> head;
  std::vector<PlainTest> tests;
};

/// A formula of a plan's body: the arguments of its literal, or its tests.
struct PlainStep {
  /// Empty, although the literal has arguments: some argument is another term.
  std::vector<Operand> args;
  std::vector<PlainTest> tests;
  /// The event that the formula makes, if any.
  std::optional<TriggerKey> event;
  /// The plans for it, if this is the library that the agent uses.
  const PlanLibrary* library = nullptr;
  const PlanList* plans = nullptr;
};

/// Of a plan with this trigger (a template) and context (null: none).
[[nodiscard]] PlainPlan plain_plan(Value trigger, const Goal* context);
/// Of the literal of a goal or a change of belief, or (null: none) a condition.
[[nodiscard]] PlainStep plain_step(Value term, const Goal* condition);

}  // namespace jaywalk
