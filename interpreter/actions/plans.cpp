// SPDX-License-Identifier: Apache-2.0
// Plans: added, removed, looked up.

#include <array>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/compile/plan_reader.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

bool is_plan(Value value) {
  return value.is_structure() && value.structure()->form() == Form::plan;
}

// In Jason a trigger is a plan, which has no label.
bool is_body(Value value) { return is_form(value, Form::body) || is_form(value, Form::trigger); }

// The name of the class that is a term in Jason.
std::string_view java_class(Value term) {
  if (term.is_number()) return "NumberTermImpl";
  if (term.is_text()) return "StringTermImpl";
  if (term.is_variable()) return "VarTerm";
  if (term.is_atom()) return is_unsigned_atom(term) ? "Atom" : "LiteralImpl";
  if (term.is_list()) return "ListTermImpl";
  if (!term.is_structure()) return "ObjectTermImpl";
  switch (term.structure()->form()) {
    case Form::logical:
      return "LogExpr";
    case Form::relation:
      return "RelExpr";
    case Form::expression:
      return "ArithExpr";
    case Form::body:
    case Form::step:
      return "PlanBodyImpl";
    default:
      return "LiteralImpl";
  }
}

// A plan, a body that stands for a plan without body ({+!g}), a text, or a list of them.
Outcome add(ActionCall& call, Value what, Value source, Place place) {
  if (what.is_list()) {
    for (const Value element : elements(what)) {
      const Outcome outcome = add(call, element, source, place);
      if (outcome != Outcome::succeeded) return outcome;
    }
    return Outcome::succeeded;
  }
  std::string problem;
  Value plan = what;
  const bool is_text = what.is_text();
  if (is_text) {
    std::string text(what.text()->view());
    // Jason removes all backslashes, not only those before quotes.
    std::erase(text, '\\');
    plan = read_plan(text, call.heap(), call.symbols(), call.machine().actions(),
                     call.machine().texts(), problem);
  } else if (!is_plan(what)) {
    plan = plan_of_trigger(what, call.heap(), call.symbols());
  }
  if (problem.empty() && !plan.is_unset() &&
      call.agent()->add_plan_term(plan, source, place, problem)) {
    return Outcome::succeeded;
  }
  // A text that cannot be parsed is an exception in Jason, a plan that cannot be added a failure.
  if (is_text && plan.is_unset()) return call.java_exception(problem);
  if (problem.empty()) {
    return call.wrong_arguments(
        fmt::format("The term '{}' ({}) can not be used as a plan for "
                    ".add_plan.",
                    brief_text(what, call.symbols()), java_class(what)));
  }
  return call.fail("internal_action", problem);
}

// A plan's label, a label, or one as text, "@p", as the book has it; unset: none of these.
Value label_of(ActionCall& call, Value what) {
  if (is_plan(what)) return plan_parts(what).label;
  if (!what.is_text()) return is_java_literal(what) && !is_body(what) ? what : Value();
  const std::string_view text = what.text()->view();
  if (!text.starts_with('@')) return {};
  return Value::atom(call.symbols().predicate(text.substr(1), 0));
}

Outcome remove(ActionCall& call, Value what, Value source) {
  if (what.is_list()) {
    for (const Value element : elements(what)) {
      const Outcome outcome = remove(call, element, source);
      if (outcome != Outcome::succeeded) return outcome;
    }
    return Outcome::succeeded;
  }
  const Value label = label_of(call, what);
  if (label.is_unset()) return call.java_exception("what is to be removed is no label");
  const Plan* const plan = call.agent()->plan_with_label(label);
  if (plan != nullptr) call.agent()->remove_plan_source(*plan, source);
  return Outcome::succeeded;
}

// The event that a trigger, or a plan as text, stands for.
std::optional<Event> event_of(ActionCall& call, Value trigger) {
  if (trigger.is_text()) {
    std::string problem;
    const Value plan = read_plan(std::string(trigger.text()->view()), call.heap(), call.symbols(),
                                 call.machine().actions(), call.machine().texts(), problem);
    if (plan.is_unset()) return std::nullopt;
    trigger = plan_parts(plan).trigger;
  }
  TriggerParts parts;
  if (!trigger_parts(trigger, call.symbols(), parts)) return std::nullopt;
  Value literal = parts.literal;
  if (is_literal(literal) && !has_source(literal_parts(literal).annots)) {
    // Plans may ask for a source: any will do.
    const Value any = call.heap().variable();
    const Value source = call.heap().structure(predicates::source, std::span(&any, 1));
    literal =
        with_annotations(call.heap(), literal,
                         union_of(call.heap(), literal_parts(literal).annots,
                                  call.heap().pair(source, Value::empty_list()), call.symbols()));
  }
  return Event{parts.op, parts.kind, literal, nullptr, 0};
}

std::vector<const Plan*> plans_for(ActionCall& call, const Event& event) {
  return call.agent()->relevant_plans(event.op, event.kind, event.literal);
}

Outcome no_trigger(ActionCall& call) {
  return call.wrong_arguments(
      fmt::format("first argument '{}' must follow the syntax of a trigger.",
                  brief_text(call.arg(0), call.symbols())));
}

// Each plan with its label, one after another.
class LabelledPlans : public Solutions {
 public:
  explicit LabelledPlans(std::vector<const Plan*> plans) : plans_(std::move(plans)) {}

  bool next(ActionCall& call) override {
    while (next_ < plans_.size()) {
      const Plan& plan = *plans_[next_++];
      const std::size_t trail = call.unifier().mark();
      if (call.unify(0, call.agent()->plan_term(plan)) &&
          call.unify(1, call.agent()->label_term(plan))) {
        return true;
      }
      call.unifier().undo(trail);
    }
    return false;
  }

 private:
  std::vector<const Plan*> plans_;
  std::size_t next_ = 0;
};

// The plans for an event, one after another, each as the event would find it: with the values that
// its trigger gets, and gives. As in Jason they are printed without braces.
class RelevantPlans : public Solutions {
 public:
  RelevantPlans(Value literal, std::vector<const Plan*> plans)
      : literal_(literal), plans_(std::move(plans)) {}

  bool next(ActionCall& call) override {
    while (next_ < plans_.size()) {
      const Value plan = call.agent()->plan_term(*plans_[next_++]);
      plan.structure()->info |= Structure::kBare;
      TriggerParts trigger;
      const std::size_t trail = call.unifier().mark();
      if (trigger_parts(plan_parts(plan).trigger, call.symbols(), trigger) &&
          call.unifier().unify(trigger.literal, literal_) && call.unify(1, plan)) {
        return true;
      }
      call.unifier().undo(trail);
    }
    return false;
  }

 private:
  Value literal_;
  std::vector<const Plan*> plans_;
  std::size_t next_ = 0;
};

}  // namespace

Outcome add_plan(ActionCall& call) {
  const Value source = call.count() > 1 ? call.arg(1) : Value::atom(predicates::self);
  Place place = Place::back;
  if (call.count() > 2) {
    const std::string where = text_of(call.arg(2), call.symbols());
    if (where == "begin") place = Place::front;
  }
  return add(call, call.arg(0), source, place);
}

Outcome remove_plan(ActionCall& call) {
  const Value source = call.count() > 1 ? call.arg(1) : Value::atom(predicates::self);
  if (!is_java_literal(source)) return call.java_exception("the source is no atom");
  return remove(call, call.arg(0), source);
}

Outcome plan_label(ActionCall& call) {
  const Value label = call.arg(1);
  if (is_literal(label)) {
    const Plan* const plan = call.agent()->plan_with_label(label);
    return plan == nullptr ? Outcome::failed : call.result(0, call.agent()->plan_term(*plan));
  }
  if (is_plan(call.arg(0))) {
    const Value own = plan_parts(call.arg(0)).label;
    return own.is_unset() ? Outcome::failed : call.result(1, own);
  }
  if (!call.arg(0).is_variable()) return call.java_exception("the first argument is no plan");
  std::vector<const Plan*> all;
  for (const auto& plan : call.agent()->library().plans()) all.push_back(plan.get());
  return call.many(std::make_unique<LabelledPlans>(std::move(all)));
}

Outcome relevant_plans(ActionCall& call) {
  const std::optional<Event> event = event_of(call, call.arg(0));
  if (!event) return no_trigger(call);
  std::vector<Value> terms;
  std::vector<Value> labels;
  for (const Plan* const plan : plans_for(call, *event)) {
    terms.push_back(call.agent()->plan_term(*plan));
    labels.push_back(call.agent()->label_term(*plan));
  }
  if (!call.unify(1, call.heap().list(terms))) return Outcome::failed;
  return call.count() == 2 ? Outcome::succeeded : call.result(2, call.heap().list(labels));
}

Outcome relevant_plan(ActionCall& call) {
  if (call.arg(0).is_variable() && is_plan(call.arg(1))) {
    return call.result(0, plan_parts(call.arg(1)).trigger);
  }
  const std::optional<Event> event = event_of(call, call.arg(0));
  if (!event) return no_trigger(call);
  return call.many(std::make_unique<RelevantPlans>(event->literal, plans_for(call, *event)));
}

Outcome list_plans(ActionCall& call) {
  std::vector<const Plan*> plans;
  if (call.count() == 1) {
    const std::optional<Event> event = event_of(call, call.arg(0));
    if (!event) return no_trigger(call);
    plans = plans_for(call, *event);
  } else {
    for (const auto& plan : call.agent()->library().plans()) plans.push_back(plan.get());
  }
  for (const Plan* const plan : plans) {
    if (plan->is_standard) continue;
    std::string text = term_text(call.agent()->plan_term(*plan), call.symbols());
    // Without the braces around it.
    call.agent()->host().print(*call.agent(), text.substr(2, text.size() - 4) + ".");
  }
  return Outcome::succeeded;
}

}  // namespace jaywalk::actions
