// Messages as far as they are not handled by plans, and texts about events and plans.

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

bool Agent::has_own_message_plans() const {
  const auto& plans = library_->candidates(
      {TriggerOperator::add, TriggerKind::achieve, predicates::kqml_received});
  return !plans.empty() && !plans.front()->is_standard;
}

bool Agent::answer_arrived(const Message& message) {
  (void)message;
  return false;
}

Value Agent::add_source(Value literal, Value sender) {
  if (!is_literal(literal)) return literal;
  std::vector<Value> sources;
  std::vector<Value> kept;
  for (Value a = deref(literal_parts(literal).annots); a.is_pair(); a = deref(a.pair()->tail)) {
    const Value annot = deref(a.pair()->head);
    const bool is_source =
        annot.is_structure() && annot.structure()->predicate() == predicates::source;
    (is_source ? sources : kept).push_back(annot);
  }
  const Value nested = sorted_set(heap_, heap_.list(sources), symbols_);
  kept.push_back(heap_.structure(predicates::source, std::span(&sender, 1), nested));
  return with_annotations(heap_, literal, sorted_set(heap_, heap_.list(kept), symbols_));
}

std::string Agent::trigger_text(const Event& event) const {
  std::string text = event.op == TriggerOperator::add      ? "+"
                     : event.op == TriggerOperator::remove ? "-"
                                                           : "^";
  if (event.kind == TriggerKind::achieve) text += '!';
  if (event.kind == TriggerKind::test) text += '?';
  append_term(text, event.literal, symbols_);
  return text;
}

std::string Agent::plan_name(const Plan& plan) const {
  if (is_literal(plan.label) && !symbols_.functor(literal_parts(plan.label).predicate).empty()) {
    return "plan @" + std::string(symbols_.functor(literal_parts(plan.label).predicate));
  }
  return fmt::format("the plan at {}:{}", plan.file, plan.line);
}

// {plan} and {head :- body} with an operator: `+` and `-` change the plan library or the rules.
bool Agent::execute_plan_or_rule(Intention& intention, Value term, Step::Kind kind) {
  const bool is_rule = term.is_structure() && term.structure()->form() == Form::rule;
  if (!is_rule) return false;
  const Value rule =
      machine_.unifier().instantiate(term, intention.frame(intention.top()));
  record_bindings(intention, 0);
  add_rule(rule, kind == Step::Kind::add_end ? Place::back : Place::front);
  go_on(intention);
  return true;
}

// A rule that was data: its variables become slots.
void Agent::add_rule(Value rule, Place place) {
  Unifier& unifier = machine_.unifier();
  renamed_.clear();
  const std::size_t trail = unifier.mark();
  const Value copy = unifier.rename(rule, &renamed_);
  std::vector<Symbol> names;
  for (std::size_t i = 0; i < renamed_.size(); ++i) {
    const Value variable = renamed_[i].second;
    names.push_back(variable.variable()->name());
    unifier.bind(variable.variable(), Value::slot(static_cast<std::uint32_t>(i)));
  }
  const Value with_slots = unifier.apply_slots(copy);
  unifier.undo(trail);
  Value head = with_slots.structure()->arg(0);
  if (!is_literal(head)) return;
  if (!has_source(literal_parts(head).annots)) {
    head = with_annotations(heap_, head,
                            union_of(heap_, literal_parts(head).annots, source_self(), symbols_));
  }
  beliefs_.add_rule(make_rule(head, with_slots.structure()->arg(1), std::move(names), heap_,
                              machine_.actions(), symbols_),
                    place);
  heap_.protect();
}

}  // namespace jaywalk
