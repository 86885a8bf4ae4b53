// SPDX-License-Identifier: Apache-2.0
// The literals of formulas that make events, `!g(X+1)`, `+b`: their arguments, and the variables in
// which results come back. The usual ones are operands, decoded when the plan was compiled
// (program/event_code.h); the unifier makes the others.

#include "interpreter/agent/execution/goal_arguments.h"

#include "interpreter/agent/agent.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {

// Variables give way to copies, and the pairs are noted behind the frame. The variable of a slot
// without a value is not made: the slot itself stands in the pair, and gets the value that the copy
// has in the end.
void Agent::rename_in_goal(Intention& intention) {
  NextEvent& next = work().next;
  IntendedMeans& means = intention.top();
  const Plan& plan = *means.plan;
  const std::size_t first = means.frame + plan.slot_count;
  intention.values.cut(first);
  const std::span<Value> args = std::span(next.args).first(next.arity);
  for (Value& arg : args) {
    if (!arg.is_variable() && !arg.is_slot()) continue;
    const Value* pair = intention.values.data() + first;
    const Value* const end = intention.values.end();
    while (pair != end && !pair->same_as(arg)) pair += 2;
    if (pair != end) {
      arg = pair[1];
      continue;
    }
    const Value copy =
        heap_.variable(arg.is_slot() ? plan.slot_names[arg.slot_index()] : arg.variable()->name());
    Value* const added = intention.values.extend(2);
    added[0] = arg;
    added[1] = copy;
    arg = copy;
  }
  means.returns = intention.values.size() - first;
}

// Records the results of a call behind the frame: each variable with its copy.
void Agent::note_returns(Intention& intention) {
  IntendedMeans& means = intention.top();
  intention.values.cut(means.frame + means.plan->slot_count);
  for (const auto& [own, copy] : work().renamed) {
    intention.values.push_back(own);
    intention.values.push_back(copy);
  }
  means.returns = 2 * work().renamed.size();
}

// Any goal's or belief's literal, applied, with source(self) unless it has a source. Where values
// are to come back, its open variables are renamed and recorded behind the frame.
Value Agent::prepare_for_event(Intention& intention, Value term, bool returns) {
  Unifier& unifier = machine().unifier();
  Value* const frame = intention.frame(intention.top());
  work().renamed.clear();
  if (is_form(term, Form::literal)) {
    const Structure& s = *term.structure();
    const Value annots = s.is_annotated() ? s.annots() : source_self();
    if (annots.is_closed() && has_source(annots)) {
      const Value made =
          unifier.instantiate_renamed(s, frame, annots, returns ? &work().renamed : nullptr);
      record_bindings(intention, 0);
      if (!made.is_unset()) {
        if (!work().renamed.empty()) note_returns(intention);
        return made;
      }
    }
  }
  Value literal = as_literal(unifier.instantiate(term, frame));
  record_bindings(intention, 0);
  if (!literal.is_closed()) {
    literal = unifier.rename(literal, returns ? &work().renamed : nullptr);
    if (returns) note_returns(intention);
  }
  if (!is_literal(literal)) return literal;
  const Value annots = literal_parts(literal).annots;
  if (has_source(annots)) return literal;
  const Value with_self =
      annots.is_empty_list() ? source_self() : union_of(heap_, annots, source_self(), symbols_);
  return with_annotations(heap_, literal, with_self);
}

}  // namespace jaywalk
