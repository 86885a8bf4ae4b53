#pragma once

// The head of a rule, compiled to steps. Matching a head with the arguments of a query is what a
// program of rules does most, and what each place of the head asks for is known beforehand:
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
    any,         // `_`
    first,       // the first place of a variable
    again,       // a later place of a variable
    constant,    // an atom, a number or the empty list: term
    new_pair,    // a list; the steps of its head and its tail follow, both `first`
    known_pair,  // ... `again` and `first`
    pair,        // ... any two
    term,        // a template: term
  };
  [[nodiscard]] bool is_pair() const { return kind >= Kind::new_pair && kind <= Kind::pair; }

  Kind kind = Kind::any;
  std::uint16_t argument = 0;  // of the query; parts of a list have none
  std::uint32_t slot = 0;      // of a variable
  Value term;
};

class HeadCode {
 public:
  HeadCode() = default;
  /// `body_terms`: what else of the rule mentions its slots.
  HeadCode(Value head, const std::vector<Value>& body_terms, std::span<const Symbol> slot_names);

  [[nodiscard]] const std::vector<HeadStep>& steps() const { return steps_; }
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
};

}  // namespace jaywalk
