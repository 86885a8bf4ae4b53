#pragma once

// The usual contexts: conjunctions of facts, simple rules, comparisons and assignments. They are
// decided in place, over the frame of the plan: nothing is built, and no machine is started.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "interpreter/agent/operands.h"
#include "interpreter/logic/machine.h"

namespace jaywalk {

/// Solves one formula over one frame. Whatever it does not understand it leaves to the machine.
class Context {
 public:
  Context(Machine& machine, Value* frame)
      : machine_(machine),
        beliefs_(machine.beliefs()),
        frame_(frame),
        trail_(machine.unifier().mark()) {}
  ~Context() {
    if (holds_) return;
    undo(0);
    machine_.unifier().undo(trail_);
  }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// The same as Machine::solve: the first solution, whose bindings stay; or false, with none.
  /// Slots that it sets itself are not on the trail, so the frame must be one in which no step will
  /// want to undo them.
  [[nodiscard]] bool solve(const Goal* entry) {
    holds_ = entry == nullptr || prove(entry) == Decision::holds;
    return holds_;
  }

 private:
  [[nodiscard]] Decision prove(const Goal* goal);
  [[nodiscard]] Decision test(const Goal& goal);
  [[nodiscard]] bool evaluate(Value term, double& number);
  [[nodiscard]] bool find_operand(Value term, Value& value);
  [[nodiscard]] Decision query(const Goal& goal, bool& is_rest_proved);
  [[nodiscard]] Decision negation(const Goal& goal);
  [[nodiscard]] Decision compare(const Goal& goal);
  [[nodiscard]] Decision unify(const Goal& goal);
  [[nodiscard]] Decision short_query(const Goal& goal, const Relation& relation);
  [[nodiscard]] Decision long_query(const Goal& goal, Relation& relation);
  [[nodiscard]] Decision match(const Row& row, const Goal& goal);
  [[nodiscard]] Decision match_and_go_on(const Row& row, const Goal& goal, bool has_more);
  [[nodiscard]] Decision rule_query(const Goal& goal, Relation& relation);
  [[nodiscard]] Decision rule(const Goal& goal, const RuleCode& rule);
  [[nodiscard]] Decision leave_rule();
  [[nodiscard]] static bool is_twice(const Goal& query, Value arg);
  [[nodiscard]] bool solve_by_machine(const Goal& goal);
  void forget(std::size_t mark, std::span<const Value> slots);
  void set(Value* slot, Value value) {
    *slot = value;
    set_[count_++] = slot;
  }
  void undo(std::size_t mark) {
    while (count_ > mark) *set_[--count_] = Value();
  }

  // A rule whose body is being proved.
  struct Call {
    const Goal* query;
    const std::vector<HeadStep>* head;
    Value* frame;  // the caller's
    const Call* outer;
  };

  static constexpr std::size_t kMostSlots = 32;
  static constexpr std::size_t kMostArguments = 8;
  static constexpr std::int64_t kFewRows = 8;
  static constexpr std::uint32_t kMostRows = 10'000;
  static constexpr std::size_t kMostRuleSlots = 8;
  static constexpr std::uint32_t kMostRules = 6;       // within each other
  static constexpr std::uint32_t kMostEntries = 1000;  // into rules

  Machine& machine_;
  BeliefBase& beliefs_;
  Value* frame_;
  std::size_t trail_;  // of the machine, at the start
  bool holds_ = false;
  std::size_t count_ = 0;
  std::uint32_t rows_ = 0;     // that have been looked at
  std::uint32_t choices_ = 0;  // queries in progress that may have another solution; negations
  std::uint32_t rules_ = 0;    // in progress, what follows them included
  std::uint32_t entries_ = 0;  // into rules
  const Call* call_ = nullptr;
  std::array<Value*, kMostSlots> set_;
};

}  // namespace jaywalk
