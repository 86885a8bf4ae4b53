// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compiled logical formulas: goals linked to the goal that follows. Terms in goals are templates
// whose slots are filled from the frame of the plan or rule. Made by formula_compiler.h, run by
// machine.h.

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "interpreter/logic/code/head_code.h"
#include "interpreter/logic/code/operand.h"
#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

struct ActionDefinition;
class RuleTable;

/// One goal of a formula. `next` is what must hold after it; null: the formula (or rule) is done.
struct Goal {
  enum class Kind : std::uint8_t {
#define JAYWALK_GOAL(id, name, meaning) id,
#include "interpreter/logic/code/instructions.def"
  };

  Kind kind = Kind::truth;
  /// For a query: its arguments are constants and slots, each slot once, and not many.
  bool is_plain = false;
  /// For compare: the orders of two numbers for which it holds (known_numbers.h).
  std::uint8_t orders = 0;
  Predicate predicate{};
  Value term;
  const Goal* next = nullptr;
  const Goal* inner = nullptr;
  const Goal* other = nullptr;
  const Goal* origin = nullptr;
  const RuleTable* table = nullptr;
  const ActionDefinition* action = nullptr;
  /// For compare and unify: the two sides.
  Operand left;
  Operand right;
  /// For an internal action: its arguments that are formulas, compiled (null for other arguments).
  std::vector<const Goal*> queries;

  /// The term's arguments.
  [[nodiscard]] std::span<const Value> args() const { return args_; }
  /// Call this when the term has been set, or has moved.
  void note_args() {
    args_ = term.is_structure() ? term.structure()->arg_span() : std::span<const Value>{};
  }

 private:
  std::span<const Value> args_;
};

/// A formula, or several, with one frame layout. Owns its goals.
struct FormulaCode {
  std::deque<Goal> goals;
  const Goal* entry = nullptr;  // null: true
  /// Passes all terms to `visit`: those made at run time live in an agent's heap.
  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (Goal& goal : goals) {
      visit(goal.term);
      goal.note_args();
    }
  }
};

/// A rule: head and body share a frame. `source` is the rule as a term, for programs as data.
struct RuleCode {
  Value head;
  HeadCode head_code;
  FormulaCode body;
  std::uint32_t slot_count = 0;
  std::vector<Symbol> slot_names;
  Value source;

  template <class Visit>
  void visit_terms(Visit&& visit) {
    visit(head);
    visit(source);
    head_code.visit_terms(visit);
    body.visit_terms(visit);
  }
};

/// A function that is a query, `register_function("my.f", Arity, "pred")`.
struct RuleFunction {
  Symbol name{};
  std::uint16_t arity = 0;
  Predicate predicate{};
};

}  // namespace jaywalk
