#pragma once

// The usual contexts: conjunctions of facts, comparisons and assignments. They are decided in
// place, over the frame of the plan: nothing is built, and no machine is started.

#include <array>
#include <cstdint>

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
    if (entry != nullptr && prove(entry) != Verdict::holds) return false;
    holds_ = true;
    return true;
  }

 private:
  [[nodiscard]] Verdict prove(const Goal* goal);
  [[nodiscard]] Verdict test(const Goal& goal);
  [[nodiscard]] Verdict query(const Goal& goal);
  [[nodiscard]] Verdict negation(const Goal& goal);
  [[nodiscard]] Verdict compare(const Goal& goal);
  [[nodiscard]] Verdict unify(const Goal& goal);
  [[nodiscard]] Verdict fact(const Goal& goal, const Relation& relation);
  [[nodiscard]] Verdict long_query(const Goal& goal, Relation& relation);
  [[nodiscard]] Verdict match(const Row& row, const Goal& goal, bool has_more);
  void set(std::uint32_t slot, Value value) {
    frame_[slot] = value;
    set_[count_++] = slot;
  }
  void undo(std::size_t mark) {
    while (count_ > mark) frame_[set_[--count_]] = Value();
  }

  static constexpr std::size_t kMostSlots = 32;
  static constexpr std::size_t kMostArguments = 8;
  static constexpr std::int64_t kFewRows = 8;
  static constexpr std::uint32_t kMostRows = 10'000;

  Machine& machine_;
  BeliefBase& beliefs_;
  Value* frame_;
  std::size_t trail_;  // of the machine, at the start
  bool holds_ = false;
  std::size_t count_ = 0;
  std::uint32_t rows_ = 0;     // that have been looked at
  std::uint32_t choices_ = 0;  // queries in progress that may have another solution; negations
  std::array<std::uint32_t, kMostSlots> set_;
};

}  // namespace jaywalk
