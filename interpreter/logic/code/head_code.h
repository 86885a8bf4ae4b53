// SPDX-License-Identifier: Apache-2.0
#pragma once

// The head of a rule or a plan, compiled to steps. Matching a head with the arguments of a query or
// an event is what a program does most, and what each place of the head asks for is known
// beforehand:
//
//   append([H|T], L, [H|R])      pair  0         argument 0 is a list; its two parts follow
//                                  first H       the first place of H: the slot takes the value
//                                  first T
//                                first 1 L
//                                pair  2         if argument 2 is a variable, the list is made:
//                                  again H       a later place of H: unify, or copy when making
//                                  first R       ... a fresh variable when making
//
// Two kinds of lists are met so often that they are steps of their own, `new_pair` and
// `known_pair`: both parts, or the tail alone, are first places of variables. The steps of the
// parts follow all the same.
//
// A slot whose first place is a step of its own need not be cleared beforehand. What lies deeper
// than the parts of a list, and what is neither list, constant nor variable, stays a template that
// Unifier::match walks through (`term`): rare, and then most of the work is elsewhere.
//
// Which rules can match at all is asked before any of them is entered: the steps that tell kinds of
// values apart are kept once more as `tests`. They bind nothing, so that a query which only one
// rule is left for needs no choice point, whichever argument distinguishes the rules.

#include <cstdint>
#include <span>
#include <vector>

#include "interpreter/term/heap.h"

namespace jaywalk {

struct HeadStep {
  enum class Kind : std::uint8_t {
#define JAYWALK_HEAD_STEP(id, name, meaning) id,
#include "interpreter/logic/code/instructions.def"
  };
  [[nodiscard]] bool is_pair() const { return kind >= Kind::new_pair && kind <= Kind::pair; }

  Kind kind = Kind::any;
  std::uint16_t argument = 0;  // of the query; parts of a list have none
  std::uint32_t slot = 0;      // of a variable
  Value term;
};

class HeadCode {
 public:
  HeadCode() : steps_(1, HeadStep{.kind = HeadStep::Kind::end}) {}
  /// `body_terms`: what else of the rule mentions its slots.
  HeadCode(Value head, const std::vector<Value>& body_terms, std::span<const Symbol> slot_names);

  /// The head of a plan: each of its variables gets a value, and those in `inherits` have one
  /// before.
  [[nodiscard]] static HeadCode of_plan(Value head, std::span<const Symbol> slot_names,
                                        std::span<const std::uint32_t> inherits);

  /// The first step; the last is `end`.
  [[nodiscard]] const HeadStep* begin() const { return steps_.data(); }
  /// Without the last.
  [[nodiscard]] std::span<const HeadStep> steps() const {
    return std::span(steps_).first(steps_.size() - 1);
  }
  /// Whether the annotations of the head must be among those of the value that it is matched with;
  /// of a rule it is the reverse.
  [[nodiscard]] bool is_of_plan() const { return is_of_plan_; }
  /// Slots below this one are set by the steps `first`; the others have to be cleared before.
  [[nodiscard]] std::uint32_t first_to_clear() const { return first_to_clear_; }

  /// Whether the head cannot match the arguments of a query, the first of them aside (the rows of
  /// a relation have a key for that). False: it may.
  [[nodiscard]] [[gnu::always_inline]] bool rejects(const Value* args) const {
    for (const HeadStep& test : tests_) {
      if (rejects(test, deref(args[test.argument]))) return true;
    }
    return false;
  }

  /// Whether there is anything to reject.
  [[nodiscard]] bool has_tests() const { return !tests_.empty(); }

  template <class Visit>
  void visit_terms(Visit&& visit) {
    for (HeadStep& step : steps_) visit(step.term);
    for (HeadStep& step : tests_) visit(step.term);
  }

 private:
  class Compiler;

  // Structures are left alone: they may be expressions, or atoms with annotations.
  [[nodiscard]] static bool rejects(const HeadStep& test, Value value) {
    if (value.is_variable() || value.is_structure() || value.is_object()) return false;
    if (test.is_pair()) return !value.is_pair();
    if (value.same_as(test.term)) return false;
    return !value.is_number() || !test.term.is_number() ||
           value.as_number() != test.term.as_number();
  }

  std::vector<HeadStep> steps_;
  std::vector<HeadStep> tests_;
  std::uint32_t first_to_clear_ = 0;
  bool is_of_plan_ = false;
};

}  // namespace jaywalk
