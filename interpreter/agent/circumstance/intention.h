// SPDX-License-Identifier: Apache-2.0
#pragma once

// Intentions: stacks of intended means. All frames of an intention stand in one vector:
//
//   values: [ frame of means 0 | its open call's returns | frame of means 1 | ... | top frame ]
//
// A frame is the unifier of its means: the slots of its plan. While a sub-goal runs, behind the
// caller's frame stand pairs of a variable of the caller and the variable that the sub-goal got in
// its place; when it returns, the values are copied back, as Jason does.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/logic/counted_numbers.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/program/plan.h"
#include "interpreter/support/containers/flat_stack.h"
#include "interpreter/support/containers/lazy.h"

namespace jaywalk {

/// The sub-plans that goals and events below a means are looked up in first, and the values of the
/// enclosing plan's variables when its means was created (AgentSpeak(ER)).
struct Scope {
  const PlanLibrary* library = nullptr;
  std::vector<Value> frame;
  std::shared_ptr<Scope> outer;
};
using ScopePtr = std::shared_ptr<Scope>;

/// A loop in progress. Bindings made in a round are undone before the next and at the end.
struct Loop {
  const Step* step = nullptr;
  /// The bindings of the round: variables, and slots of the frame.
  std::vector<Value> bound;
  /// The solutions of a conjunct of a `for`'s condition together with a solution of those before.
  struct Level {
    /// Every solution as pairs (variable or slot, value), one after another.
    std::vector<Value> solutions;
    std::vector<std::size_t> ends;
    std::size_t next = 0;
    bool has_more = false;  // there may be others that have not been asked for
    /// Later solutions repeat the last one with each of these numbers as its last value. They are
    /// not stored: nothing that a round does can change them.
    CountedNumbers numbers{.next = 1, .last = 0};

    /// Goes on to the next solution. False: there is none among those that have been asked for.
    [[nodiscard]] bool advance() {
      if (next < ends.size()) {
        ++next;
        return true;
      }
      if (numbers.is_done()) return false;
      solutions.back() = Value::number(numbers.take());
      return true;
    }
  };
  std::vector<Level> levels;
};

/// Rarely used parts of intended means, beside their frame.
struct MeansExtras {
  /// Bodies made at run time that the means has not left, each within the one before.
  std::vector<std::shared_ptr<BodyCode>> codes;
  std::vector<Loop> loops;
  ScopePtr scope;  // null: the agent's library alone
};

struct IntendedMeans {
  const Plan* plan = nullptr;
  const Step* current = nullptr;  // the formula that it has come to; null: it is done
  TriggerOperator op = TriggerOperator::add;
  TriggerKind kind = TriggerKind::belief;
  /// The event's literal. Unset: it is the plan's trigger with the frame's values in its slots
  /// (Agent::goal_of), which is made on demand.
  Value trigger;
  std::size_t frame = 0;    // index into the intention's values
  std::size_t returns = 0;  // values behind the frame: pairs of the open call
  /// In a means for a failure, `-!g`: how many means below stay when it is done. Those above them
  /// are of the goal that failed.
  std::size_t keeps = 0;
  LazyValue<MeansExtras> extras;

  [[nodiscard]] bool has_loops() const { return extras && !extras->loops.empty(); }
  [[nodiscard]] ScopePtr scope() const { return extras ? extras->scope : nullptr; }
  [[nodiscard]] bool is_finished() const { return current == nullptr; }
  /// REQUIRES: it is not finished.
  [[nodiscard]] const Step& step() const { return *current; }
  [[nodiscard]] bool is_goal() const { return kind != TriggerKind::belief; }
  [[nodiscard]] bool is_goal_addition() const { return is_goal() && op == TriggerOperator::add; }
  /// The predicate of the event's literal, if it is one.
  [[nodiscard]] std::optional<Predicate> predicate() const {
    if (trigger.is_unset()) return plan->head.predicate;
    return is_literal(trigger) ? std::optional(predicate_of(trigger)) : std::nullopt;
  }
};

/// Several branches of one fork, `|&|` or `|||`.
struct Fork {
  bool is_or = false;
  std::size_t depth = 0;                // how many means the branches share
  std::size_t open = 0;                 // branches that have not joined
  std::vector<std::uint32_t> branches;  // ids of the intentions
  std::shared_ptr<Fork> outer;          // the fork of which this one's intention was a branch
};

/// The frames of an intention.
using ValueStack = FlatStack<Value>;

class Intention {
 public:
  enum class State : std::uint8_t {
    running,    // in the queue, or executing
    in_event,   // an internal event of it waits in the event queue
    acting,     // an action for the environment is pending
    waiting,    // .wait, an ask: resumed by the agent itself
    suspended,  // .suspend: resumed by .resume
    finished,
  };

  explicit Intention(std::uint32_t number) : id(number) {}
  /// A finished intention becomes a new one, so that its memory is used again.
  void start_again(std::uint32_t number) {
    id = number;
    state = State::running;
  }
  /// Lets go of everything.
  void finish();

  [[nodiscard]] bool is_finished() const { return stack.empty(); }
  /// Whether something suspended it, whatever else it waits for.
  [[nodiscard]] bool is_suspended() const { return also_suspended || state == State::suspended; }
  [[nodiscard]] IntendedMeans& top() { return stack.back(); }
  [[nodiscard]] const IntendedMeans& top() const { return stack.back(); }
  [[nodiscard]] Value* frame(const IntendedMeans& means) { return values.data() + means.frame; }
  [[nodiscard]] bool is_atomic() const { return atomic_means > 0; }
  [[nodiscard]] bool is_branch_done() const { return shared > 0 && stack.size() == shared; }

  /// The arguments of the goal of a means, from the frame; lists are made in `heap`. REQUIRES: the
  /// head of its plan tells the goal.
  [[nodiscard]] std::vector<Value> goal_arguments(const IntendedMeans& means, Heap& heap) const;
  /// Puts a means on top, at the beginning of its plan's body, with a frame of these values.
  [[gnu::always_inline]] void push(const Plan& plan, std::span<const Value> slots) {
    IntendedMeans& means = stack.emplace_back();
    means.plan = &plan;
    means.current = plan.code.entry->begin(nullptr);
    means.frame = values.size();
    Value* slot = values.extend(slots.size());
    for (const Value value : slots) *slot++ = value;
    if (plan.atomic) ++atomic_means;
  }
  /// Like push(), but replaces the top means.
  [[gnu::always_inline]] void replace(const Plan& plan, std::span<const Value> slots) {
    IntendedMeans& means = stack.back();
    if (means.plan->atomic) --atomic_means;
    if (plan.atomic) ++atomic_means;
    values.cut(means.frame);
    means.plan = &plan;
    means.current = plan.code.entry->begin(nullptr);
    means.returns = 0;
    if (means.extras) means.extras.reset();
    Value* slot = values.extend(slots.size());
    for (const Value value : slots) *slot++ = value;
  }
  /// Removes the top means and its frame.
  void pop() {
    if (stack.back().plan->atomic) --atomic_means;
    values.cut(stack.back().frame);
    stack.pop_back();
  }
  /// Removes `count` means from the bottom, with their frames. REQUIRES: it has more.
  void forget_bottom(std::size_t count);
  /// Goes on behind the current step of the top means.
  void advance() { go_on_at(stack.back().current->next); }
  /// Goes on at a step of the top means' body; null: it is done.
  void go_on_at(const Step* step) {
    IntendedMeans& means = stack.back();
    values.cut(means.frame + means.plan->slot_count);  // an open call's returns are done with
    means.returns = 0;
    means.current = step;
  }

  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (Value& value : values) visit(value);
    for (IntendedMeans& means : stack) {
      visit(means.trigger);
      if (!means.extras) continue;
      for (Loop& loop : means.extras->loops) {
        for (Value& value : loop.bound) visit(value);
        for (Loop::Level& level : loop.levels) {
          for (Value& value : level.solutions) visit(value);
        }
      }
    }
  }

  /// Intentions that are made later have greater ones.
  std::uint32_t id;
  State state = State::running;
  /// The reason for waiting, as `.suspended` reports it.
  std::string reason;
  /// It was suspended by name while it was waiting.
  bool also_suspended = false;
  /// It suspended itself: resumed, it goes on behind its formula.
  bool suspended_itself = false;
  /// For a branch, which handles an external event by a sub-plan of another intention: the number
  /// of that intention, and how many means are copies of its means. When only the copies remain,
  /// the branch is done. 0: it is not a branch.
  std::uint32_t origin = 0;
  std::size_t shared = 0;
  /// An event of it may be in the event queue.
  bool has_event = false;
  std::vector<IntendedMeans> stack;
  ValueStack values;
  std::uint32_t atomic_means = 0;
  std::shared_ptr<Fork> fork;

  /// Its memory, without terms (memory.cpp).
  [[nodiscard]] std::size_t bytes() const;
  /// Gives back memory that a stack much deeper than this one has needed.
  void shrink();
};

/// Memory of the solutions that a loop has found, without terms.
[[nodiscard]] std::size_t bytes_of(const Loop::Level& level);

}  // namespace jaywalk
