// SPDX-License-Identifier: Apache-2.0
#pragma once

// Whether an agent can reason in parallel: only if what it does in a round cannot depend on what
// others do in the same round, nor theirs on it. Messages, timers and lines to write can wait for
// the end of the round. But an agent that creates or ends agents, uses the yellow pages or files,
// or gets new plans, must take its turn after all agents before it and before all behind it.
//
// Programs are judged by their text: does an internal action with such a reach stand anywhere in
// it? A program that executes terms (a variable as formula, as goal or as waiting condition) can be
// informed about such an action by another, so it counts as one if any program of the system has a
// far reach or makes terms from texts. Where plans are sent (tellHow, askHow), agents reason one
// after another.

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "interpreter/program/program.h"

namespace jaywalk {

/// Properties of a program's text.
struct Reach {
  bool is_far = false;
  bool runs_terms = false;
  bool makes_terms = false;
  bool sends_plans = false;
};
[[nodiscard]] Reach reach_of(const Program& program, const SymbolTable& symbols);

/// The programs of one system.
class Reaches {
 public:
  /// Does nothing if it is known. REQUIRES: it lives as long as the system.
  void add(const Program& program, const SymbolTable& symbols);
  /// Changes when answers may have changed.
  [[nodiscard]] std::size_t version() const { return version_; }
  /// Agents with this program can reason in parallel. REQUIRES: it was added.
  [[nodiscard]] bool is_near(const Program& program) const;

 private:
  std::unordered_map<const Program*, Reach> programs_;
  Reach all_;  // what stands in any of them
  std::size_t version_ = 1;
};

}  // namespace jaywalk
