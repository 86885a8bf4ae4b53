// SPDX-License-Identifier: Apache-2.0
#pragma once

// The standard internal actions, declared from their table.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/logic/action.h"
#include "interpreter/logic/solutions.h"

namespace jaywalk::actions {

#define JAYWALK_ACTION(function, least, most, kind, traits, signature, summary) \
  Outcome function(ActionCall&);
#include "interpreter/actions/table/actions.def"
#undef JAYWALK_ACTION

[[nodiscard]] inline Outcome when(bool holds) {
  return holds ? Outcome::succeeded : Outcome::failed;
}

/// The elements of a list, dereferenced; none if the value is not a list.
[[nodiscard]] std::vector<Value> elements(Value list);

/// Whether Java's cast to a Literal succeeds: in Jason structures, lists, bodies, triggers,
/// expressions and variables are literals; numbers, strings, sets, maps and queues are none.
[[nodiscard]] inline bool is_java_literal(Value value) {
  return !value.is_number() && !value.is_text() && !value.is_object();
}

/// Whether Jason takes it for a literal where it asks first: not lists, expressions and variables.
[[nodiscard]] inline bool is_jason_literal(Value value) {
  if (is_literal(value)) return true;
  return value.is_structure() && value.structure()->form() != Form::expression &&
         value.structure()->form() != Form::function;
}
/// An atom without strong negation, which in Jason makes it a literal.
[[nodiscard]] inline bool is_unsigned_atom(Value value) {
  return value.is_atom() && !is_negated(value.atom_id());
}

/// The list or set in an argument as values; false if it is neither.
[[nodiscard]] bool collection_in(Value value, std::vector<Value>& all);
/// For what may take long: throws QueryLimit if the run is to end.
void check_interruption(ActionCall& call);
/// Sorted by the order of terms, without duplicates.
void sort_as_set(std::vector<Value>& all, ActionCall& call);

/// The text of an argument: a string's content, anything else as it prints.
[[nodiscard]] std::string text_of(Value value, const SymbolTable& symbols);

/// A literal without its annotations source(_). REQUIRES: is_literal(literal).
[[nodiscard]] Value without_sources(Heap& heap, Value literal);

/// A rule as a term with variables of its own.
[[nodiscard]] Value rule_term(Unifier& unifier, const RuleCode& rule);

/// The solutions of an action that are known beforehand: each is unified with one argument.
class ValueSolutions : public Solutions {
 public:
  ValueSolutions(std::size_t argument, std::vector<Value> values)
      : argument_(argument), values_(std::move(values)) {}
  bool next(ActionCall& call) override {
    while (next_ < values_.size()) {
      if (call.unify(argument_, values_[next_++])) return true;
    }
    return false;
  }

 private:
  std::size_t argument_;
  std::vector<Value> values_;
  std::size_t next_ = 0;
};

}  // namespace jaywalk::actions
