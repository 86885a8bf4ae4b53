// SPDX-License-Identifier: Apache-2.0
// Plans and rules as data: an agent's plans as terms, and terms as plans.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/own_parts.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/support/width.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/heap.h"
#include "interpreter/term/print.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

// Labels of plans that have none are an agent's own: another's plan may bring the same.
bool has_made_label(const Plan& plan, const SymbolTable& symbols) {
  return is_literal(plan.label) &&
         symbols.functor(literal_parts(plan.label).predicate).starts_with("p__");
}

}  // namespace

// A template's slots as variables of the plan's names.
Value Agent::plan_term(const Plan& plan) {
  Unifier& unifier = machine().unifier();
  ScratchSlots slots(unifier, plan.slot_count);
  const std::size_t trail = unifier.mark();
  unifier.set_slot_names(plan.slot_names);
  const PlanParts parts = plan_parts(plan.source);
  std::array<Value, 6> made{label_of(plan), parts.trigger,        parts.context,
                            parts.body,     parts.goal_condition, Value()};
  for (Value& part : made) part = unifier.instantiate(part, slots.data());
  unifier.commit(trail);
  return heap_.structure(plan.source.structure()->predicate(), made, Value::empty_list(),
                         Form::plan);
}

Value Agent::label_term(const Plan& plan) {
  Unifier& unifier = machine().unifier();
  ScratchSlots slots(unifier, plan.slot_count);
  const std::size_t trail = unifier.mark();
  unifier.set_slot_names(plan.slot_names);
  const Value label = label_of(plan);
  const Value made = label.is_unset() ? label : unifier.instantiate(label, slots.data());
  unifier.commit(trail);
  return made;
}

// The variables of a term become slots 0, 1, ...; their names are collected.
Value Agent::as_template(Value term, std::vector<Symbol>& slot_names) {
  Unifier& unifier = machine().unifier();
  work().renamed.clear();
  const std::size_t trail = unifier.mark();
  const Value copy = unifier.rename(term, &work().renamed);
  for (std::size_t i = 0; i < work().renamed.size(); ++i) {
    Variable* const variable = work().renamed[i].second.variable();
    slot_names.push_back(variable->name());
    unifier.bind(variable, Value::slot(static_cast<std::uint32_t>(i)));
  }
  const Value made = unifier.apply_slots(copy);
  unifier.undo(trail);
  return made;
}

bool Agent::add_plan_term(Value term, Value source, Place place, std::string& problem) {
  if (!term.is_structure() || term.structure()->form() != Form::plan) {
    problem = brief_text(term, symbols_) + " is not a plan";
    return false;
  }
  heap_.require_room();
  heap_.note_other_bytes(kPlanBytes);
  std::vector<Symbol> names;
  const Value made = as_template(term, names);
  if (names.size() > kMostParts) {
    problem = fmt::format("a plan with more than {} variables", kMostParts);
    return false;
  }
  const std::shared_ptr<Plan> plan =
      compile_plan(made, std::move(names), machine().actions(), symbols_);
  if (plan == nullptr) {
    problem = brief_text(term, symbols_) + " has no trigger";
    return false;
  }
  plan->file = program_->name();
  if (const Plan* const known = equal_plan(*plan)) {
    add_plan_source(*known, source);
    return true;
  }
  const bool is_unnamed = has_made_label(*plan, symbols_);
  if (!is_unnamed && plan_with_label(plan->label) != nullptr) {
    problem = "another plan has the label " + plan_name(*plan);
    return false;
  }
  if (is_unnamed && plan_with_label(plan->label) != nullptr) plan->label = Value();
  if (!is_literal(plan->label)) {
    plan->label = Value::atom(symbols_.predicate("p__" + std::to_string(++own().next_label), 0));
    while (plan_with_label(plan->label) != nullptr) {
      plan->label = Value::atom(symbols_.predicate("p__" + std::to_string(++own().next_label), 0));
    }
  }
  add_plan(plan, place);
  add_plan_source(*plan, source);
  return true;
}

// Equal plans may have different labels.
const Plan* Agent::equal_plan(const Plan& plan) const {
  const auto& candidates = library_->candidates(plan.key);
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Plan* known) {
    return known->any_predicate == plan.any_predicate && equal_plans(*known, plan);
  });
  return found == candidates.end() ? nullptr : *found;
}

Value Agent::label_of(const Plan& plan) const {
  if (own_ == nullptr) return plan.label;
  const auto changed = own_->labels.find(&plan);
  return changed == own_->labels.end() ? plan.label : changed->second;
}

// A plan may be the program's, which others share: what changes is kept apart.
void Agent::add_plan_source(const Plan& plan, Value source) {
  const Value label = label_of(plan);
  const Value annot = heap_.structure(predicates::source, std::span(&source, 1));
  own().labels[&plan] =
      with_annotations(heap_, label,
                       union_of(heap_, literal_parts(label).annots,
                                heap_.pair(annot, Value::empty_list()), symbols_));
  heap_.protect();
}

void Agent::remove_plan_source(const Plan& plan, Value source) {
  const Value label = label_of(plan);
  std::vector<Value> kept;
  bool was_there = false;
  Value rest = literal_parts(label).annots;
  for (; rest.is_pair(); rest = deref(rest.pair()->tail)) {
    const Value annot = deref(rest.pair()->head);
    const bool named = annot.is_structure() &&
                       annot.structure()->predicate() == predicates::source &&
                       equal_terms(annot.structure()->arg(0), source);
    was_there = was_there || named;
    if (!named) kept.push_back(annot);
  }
  if (!was_there) return;
  const Value annots = heap_.list(kept, rest);
  if (!has_source(annots)) {
    remove_plan(plan);
    return;
  }
  own().labels[&plan] = with_annotations(heap_, label, annots);
  heap_.protect();
}

const Plan* Agent::plan_with_label(Value label) const {
  label = deref(label);
  if (!is_literal(label)) return nullptr;
  const LiteralParts wanted = literal_parts(label);
  for (const auto& plan : library_->plans()) {
    if (!is_literal(plan->label)) continue;
    const LiteralParts known = literal_parts(plan->label);
    if (known.predicate != wanted.predicate) continue;
    bool equal = true;
    for (std::size_t i = 0; i < wanted.args.size(); ++i) {
      equal = equal && equal_terms(wanted.args[i], known.args[i]);
    }
    if (equal) return plan.get();
  }
  return nullptr;
}

std::vector<const Plan*> Agent::relevant_plans(TriggerOperator op, TriggerKind kind,
                                               Value literal) {
  std::vector<const Plan*> found;
  Unifier& unifier = machine().unifier();
  const Event event{op, kind, literal, nullptr, 0};
  std::vector<const Plan*> candidates;
  if (is_literal(literal)) {
    candidates = library_->candidates(key_of(event));
  } else {
    // A variable, {+!_}: any plan for an event of this kind.
    for (const auto& plan : library_->plans()) {
      if (plan->key.op == op && plan->key.kind == kind) candidates.push_back(plan.get());
    }
  }
  for (const Plan* const plan : candidates) {
    const std::size_t trail = unifier.mark();
    ScratchSlots slots(unifier, plan->slot_count);
    unifier.set_slot_names(plan->slot_names);
    if (unifier.match(plan->trigger, slots.data(), literal, Unifier::Direction::template_first)) {
      found.push_back(plan);
    }
    unifier.undo(trail);
  }
  return found;
}

// {plan} and {head :- body} with an operator: `+` and `-` change the plan library or the rules.
bool Agent::execute_plan_or_rule(Intention& intention, Value term, Step::Kind kind) {
  const bool is_rule = term.is_structure() && term.structure()->form() == Form::rule;
  const bool is_plan = term.is_structure() && term.structure()->form() == Form::plan;
  if (!is_rule && !is_plan) return false;
  const Value code = machine().unifier().instantiate(term, intention.frame(intention.top()));
  record_bindings(intention, 0);
  const bool removes = kind == Step::Kind::remove || kind == Step::Kind::remove_new_focus;
  const Place place = kind == Step::Kind::add_end ? Place::back : Place::front;
  ActionError error;
  if (is_rule) {
    change_rules(code, kind);
  } else if (removes) {
    const Plan* const known = plan_with_label(plan_parts(code).label);
    if (known != nullptr) remove_plan_source(*known, Value::atom(predicates::self));
  } else if (!add_plan_term(code, Value::atom(predicates::self), place, error.message)) {
    fail(intention, error);
    return true;
  }
  go_on(intention);
  return true;
}

// As in Jason a removed rule is found by its head alone, and there is no event.
void Agent::change_rules(Value rule, Step::Kind kind) {
  const Value head = as_literal(rule);
  const bool removes = kind == Step::Kind::remove || kind == Step::Kind::remove_new_focus;
  if (removes && is_literal(head)) remove_like(head);
  if (kind == Step::Kind::replace && is_literal(head)) remove_like(any_like(head));
  if (!removes) add_rule(rule, kind == Step::Kind::add_end ? Place::back : Place::front);
}

void Agent::remove_like(Value head) {
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  (void)beliefs_.remove_like(with_own_source(head), unifier);
  unifier.undo(trail);
}

// A rule that was data.
void Agent::add_rule(Value rule, Place place) {
  heap_.require_room();
  heap_.note_other_bytes(kPlanBytes);
  std::vector<Symbol> names;
  const Value made = as_template(rule, names);
  Value head = made.structure()->arg(0);
  if (!is_literal(head)) return;
  head = with_own_source(head);
  if (predicate_of(head) == predicates::select_option) unusual_ |= kSelectsByRules;
  beliefs_.add_rule(make_rule(head, made.structure()->arg(1), std::move(names), heap_,
                              machine().actions(), symbols_),
                    place);
  heap_.protect();
}

bool Agent::include(std::shared_ptr<const Program> program, std::string& problem) {
  heap_.require_room();
  std::vector<std::shared_ptr<const Plan>> added;
  for (const auto& plan : program->library().plans()) {
    const Plan* const known = plan->is_standard ? plan.get() : plan_with_label(plan->label);
    if (known == nullptr) {
      added.push_back(plan);
    } else if (known != plan.get() && !equal_plans(*known, *plan)) {
      problem = fmt::format("another plan has the label {} already", plan_name(*plan));
      return false;
    }
  }
  for (auto& plan : added) own_library().add(std::move(plan));
  note_unusual();
  std::vector<RuleFunction>& functions = own().functions;
  if (functions.empty()) functions = program_->functions();
  functions.insert(functions.end(), program->functions().begin(), program->functions().end());
  machine().use_functions(functions);
  own().included.push_back(program);
  begin(*program, {}, {});
  return true;
}

}  // namespace jaywalk
