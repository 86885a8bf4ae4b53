// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/plan_compiler.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "interpreter/logic/beliefs/belief_base.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

struct OperatorKind {
  Symbol symbol;
  Step::Kind kind;
};

constexpr std::array kOperators{
    OperatorKind{names::empty, Step::Kind::action},
    OperatorKind{names::achieve, Step::Kind::achieve},
    OperatorKind{names::achieve_new_focus, Step::Kind::achieve_new_focus},
    OperatorKind{names::test, Step::Kind::test},
    OperatorKind{names::plus, Step::Kind::add},
    OperatorKind{names::add_new_focus, Step::Kind::add_new_focus},
    OperatorKind{names::add_begin, Step::Kind::add_begin},
    OperatorKind{names::add_end, Step::Kind::add_end},
    OperatorKind{names::minus, Step::Kind::remove},
    OperatorKind{names::remove_new_focus, Step::Kind::remove_new_focus},
    OperatorKind{names::replace, Step::Kind::replace},
};

Step::Kind kind_of(Symbol symbol) {
  for (const OperatorKind& known : kOperators) {
    if (known.symbol == symbol) return known.kind;
  }
  return Step::Kind::wrong;
}

}  // namespace

const Body* BodyCompiler::compile(Value body) {
  Body made;
  body = deref(body);
  if (is_form(body, Form::body)) {
    compile_steps(*body.structure(), made);
  } else {
    Step step;
    step.kind = Step::Kind::action;
    step.term = body;
    compile_plain(step);
    made.steps.push_back(std::move(step));
  }
  return &code_.bodies.emplace_back(std::move(made));
}

void BodyCompiler::compile_steps(const Structure& body, Body& made) {
  for (Value step : body.arg_span()) {
    step = deref(step);
    // A body that stands as a formula (a variable's value) is a part of this one.
    const bool plain = is_form(step, Form::step) &&
                       symbols_.signature(step.structure()->predicate()).functor == names::empty;
    const Value inner = plain ? deref(step.structure()->arg(0)) : Value();
    if (is_form(inner, Form::body)) {
      compile_steps(*inner.structure(), made);
    } else {
      made.steps.push_back(compile_step(step));
    }
  }
}

Step BodyCompiler::compile_step(Value term) {
  term = deref(term);
  Step step;
  step.source = term;
  if (!is_form(term, Form::step)) {
    step.kind = Step::Kind::action;
    step.term = term;
    compile_plain(step);
    return step;
  }
  const Structure& s = *term.structure();
  step.kind = kind_of(symbols_.signature(s.predicate()).functor);
  step.term = deref(s.arg(0));
  const Value place = deref(s.arg(1));
  if (place.is_number()) step.place = decode_step_place(place.as_number());
  const bool open =
      step.term.is_slot() || step.term.is_variable() || is_form(step.term, Form::decorated);
  if (open) {
    step.variable_kind = step.kind;
    step.kind = Step::Kind::variable;
    if (step.variable_kind == Step::Kind::test) step.goal = formulas_.compile(step.term, nullptr);
  } else if (step.kind == Step::Kind::action) {
    compile_plain(step);
  } else if (step.kind == Step::Kind::test) {
    step.goal = formulas_.compile(step.term, nullptr);
  }
  prepare(step);
  return step;
}

void BodyCompiler::prepare(Step& step) {
  const bool is_goal = step.kind == Step::Kind::achieve;
  const bool removes = step.kind == Step::Kind::remove;
  const bool makes_event =
      is_goal || removes || step.kind == Step::Kind::add || step.kind == Step::Kind::replace;
  if (!makes_event) return;
  auto event = std::make_unique<EventCode>(decode_event(step.term));
  if (is_literal(step.term)) {
    event->event = trigger_key(removes ? TriggerOperator::remove : TriggerOperator::add,
                               is_goal ? TriggerKind::achieve : TriggerKind::belief,
                               predicate_of(step.term), symbols_);
  }
  step.event = event.get();
  code_.events.push_back(std::move(event));
}

// A formula without operator: an action, an internal action, a constraint, a statement.
void BodyCompiler::compile_plain(Step& step) {
  const Value term = step.term;
  if (term.is_slot() || term.is_variable() || is_form(term, Form::decorated)) {
    step.variable_kind = Step::Kind::action;
    step.kind = Step::Kind::variable;
    return;
  }
  if (is_form(term, Form::relation)) {
    step.kind = Step::Kind::constraint;
    step.goal = formulas_.compile(term, nullptr);
    return;
  }
  const bool callable = is_literal(term) || is_form(term, Form::function);
  const bool dotted =
      callable &&
      symbols_.signature(term.is_atom() ? term.atom_id() : term.structure()->predicate()).dotted;
  if (!dotted) {
    step.kind =
        is_literal(term) || is_form(term, Form::logical) ? Step::Kind::action : Step::Kind::wrong;
    return;
  }
  if (compile_statement(step)) return;
  step.kind = Step::Kind::internal_action;
  step.goal = formulas_.compile_action(term, nullptr);
}

void BodyCompiler::add_conjuncts(Value formula, std::vector<const Goal*>& conjuncts) {
  for (formula = deref(formula); is_form(formula, Form::logical) &&
                                 formula.structure()->predicate() == predicates::logical_and;
       formula = deref(formula.structure()->arg(1))) {
    add_conjuncts(formula.structure()->arg(0), conjuncts);
  }
  conjuncts.push_back(formulas_.compile(formula, nullptr));
}

// if, while, for and forks are internal actions by name, in Jason too.
bool BodyCompiler::compile_statement(Step& step) {
  if (!step.term.is_structure()) return false;
  const Structure& s = *step.term.structure();
  const std::string_view name = symbols_.functor(s.predicate());
  const bool is_if = name == ".if_then_else" && (s.arity == 2 || s.arity == 3);
  const bool is_while = name == ".loop" && s.arity == 2;
  const bool is_for = name == ".foreach" && s.arity == 2;
  if (is_if || is_while || is_for) {
    step.kind = is_if      ? Step::Kind::if_statement
                : is_while ? Step::Kind::while_loop
                           : Step::Kind::for_loop;
    if (is_for) {
      add_conjuncts(s.arg(0), step.conjuncts);
    } else {
      step.goal = formulas_.compile(s.arg(0), nullptr);
    }
    step.first = compile(s.arg(1));
    if (s.arity == 3) step.second = compile(s.arg(2));
    return true;
  }
  if (name != ".fork" || s.arity < 2) return false;
  const Value mode = deref(s.arg(0));
  const bool is_or = mode.is_atom() && symbols_.functor(mode.atom_id()) == "or";
  step.kind = is_or ? Step::Kind::fork_or : Step::Kind::fork_and;
  for (std::size_t i = 1; i < s.arity; ++i) {
    // Each branch ends by joining the others.
    const Body* const branch = compile(s.arg(i));
    Body& joined = code_.bodies.emplace_back(*branch);
    Step join;
    join.kind = Step::Kind::join;
    join.variable_kind = step.kind;
    join.place = step.place;
    joined.steps.push_back(std::move(join));
    step.branches.push_back(&joined);
  }
  return true;
}

namespace {

// Which formulas are last calls of the plan's own goal.
void find_last_calls(Plan& plan) {
  for (Body& body : plan.code.bodies) {
    for (Step& step : body.steps) {
      if (step.event == nullptr) continue;
      EventCode& code = **std::ranges::find(plan.code.events, step.event,
                                            [](const auto& each) { return each.get(); });
      const bool is_goal = step.kind == Step::Kind::achieve;
      const bool is_another = plan.head.is_decoded && code.event && *code.event != plan.key;
      if (step.next != nullptr || !is_goal || is_another) {
        code.last_call = EventCode::LastCall::no;
      } else if (plan.head.is_decoded && code.is_decoded && code.event == plan.key &&
                 code.predicate == plan.head.predicate && plan.is_simple) {
        code.last_call = EventCode::LastCall::yes;
      }
    }
  }
}

}  // namespace

PlanParts plan_parts(Value plan) {
  const Structure& s = *plan.structure();
  return {deref(s.arg(0)), deref(s.arg(1)), deref(s.arg(2)),
          deref(s.arg(3)), deref(s.arg(4)), deref(s.arg(5))};
}

bool equal_plans(const Plan& a, const Plan& b) {
  const PlanParts x = plan_parts(a.source);
  const PlanParts y = plan_parts(b.source);
  const auto same = [](Value p, Value q) {
    return (p.is_unset() && q.is_unset()) || (!p.is_unset() && !q.is_unset() && equal_terms(p, q));
  };
  return same(x.trigger, y.trigger) && same(x.context, y.context) && same(x.body, y.body);
}

bool trigger_parts(Value term, const SymbolTable& symbols, TriggerParts& parts) {
  term = deref(term);
  if (is_form(term, Form::body) && term.structure()->arity == 1) {
    term = deref(term.structure()->arg(0));
    if (!is_form(term, Form::step)) return false;
  } else if (!is_form(term, Form::trigger)) {
    return false;
  }
  std::string_view op = symbols.functor(term.structure()->predicate());
  if (op.empty()) return false;
  switch (op.front()) {
    case '+':
      parts.op = TriggerOperator::add;
      break;
    case '-':
      parts.op = TriggerOperator::remove;
      break;
    case '^':
      parts.op = TriggerOperator::goal_state;
      break;
    default:
      return false;
  }
  op.remove_prefix(1);
  if (op.empty()) {
    parts.kind = TriggerKind::belief;
  } else if (op == "!") {
    parts.kind = TriggerKind::achieve;
  } else if (op == "?") {
    parts.kind = TriggerKind::test;
  } else {
    return false;
  }
  parts.literal = as_literal(deref(term.structure()->arg(0)));
  return true;
}

std::string trigger_operator(TriggerOperator op, TriggerKind kind) {
  std::string text = op == TriggerOperator::add ? "+" : op == TriggerOperator::remove ? "-" : "^";
  if (kind != TriggerKind::belief) text += kind == TriggerKind::achieve ? '!' : '?';
  return text;
}

TriggerKey trigger_key(TriggerOperator op, TriggerKind kind, Predicate predicate,
                       SymbolTable& symbols) {
  if (is_negated(predicate)) {
    Signature signature = symbols.signature(predicate);
    signature.negated = false;
    predicate = symbols.predicate(signature);
  }
  return {op, kind, predicate};
}

std::shared_ptr<Plan> compile_plan(Value term, std::vector<Symbol> slot_names,
                                   const ActionRegistry& actions, SymbolTable& symbols) {
  const PlanParts parts = plan_parts(term);
  TriggerParts trigger;
  if (!trigger_parts(parts.trigger, symbols, trigger)) return nullptr;
  auto plan = std::make_shared<Plan>();
  plan->source = term;
  plan->label = parts.label;
  if (is_literal(parts.label)) {
    for (Value a = literal_parts(parts.label).annots; a.is_pair(); a = deref(a.pair()->tail)) {
      const Value annot = deref(a.pair()->head);
      if (is_literal(annot) && predicate_of(annot) == predicates::learned) {
        const Value policy = deref(literal_parts(annot).args.front());
        if (policy.is_atom()) plan->policy = policy;
      }
      if (!annot.is_atom()) continue;
      if (annot.atom_id() == predicates::atomic) plan->atomic = true;
      if (annot.atom_id() == predicates::all_unifs) plan->all_unifs = true;
    }
  }
  plan->trigger = trigger.literal;
  plan->any_predicate = !is_literal(trigger.literal);
  plan->key = {trigger.op, trigger.kind, Predicate{}};
  if (!plan->any_predicate) {
    plan->key =
        trigger_key(trigger.op, trigger.kind, literal_parts(trigger.literal).predicate, symbols);
    const std::span<const Value> args = literal_parts(trigger.literal).args;
    if (!args.empty()) {
      plan->first_key = argument_key(args.front());
      if (args.front().is_number() || args.front().is_atom()) plan->first_argument = args.front();
    }
  }
  BodyCompiler compiler(plan->code, actions, symbols);
  if (!parts.context.is_unset()) plan->context = compiler.compile_formula(parts.context);
  plan->head = decode_head(plan->trigger, slot_names);
  if (!parts.goal_condition.is_unset()) {
    plan->has_goal_condition = true;
    plan->goal_condition = compiler.compile_formula(parts.goal_condition);
  }
  plan->code.entry = compiler.compile(parts.body);
  plan->code.link(nullptr);
  plan->is_simple = !plan->atomic && !plan->has_goal_condition;
  plan->slot_count = static_cast<std::uint32_t>(slot_names.size());
  plan->own_slots = plan->slot_count;
  plan->slot_names = std::move(slot_names);
  find_last_calls(*plan);
  return plan;
}

}  // namespace jaywalk
