// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/formula_compiler.h"

#include <algorithm>
#include <array>

#include "interpreter/logic/code/known_numbers.h"
#include "interpreter/logic/rule_unfolder.h"

namespace jaywalk {
namespace {

// Whether a query can put the arguments of a fact straight into its slots (machine_queries.cpp).
bool is_plain(std::span<const Value> args) {
  constexpr std::size_t kMost = 16;
  if (args.size() > kMost) return false;
  for (std::size_t i = 0; i < args.size(); ++i) {
    if (args[i].is_closed()) continue;
    const auto is_same = [&](Value other) { return other.same_as(args[i]); };
    if (!args[i].is_slot() || std::ranges::any_of(args.first(i), is_same)) return false;
  }
  return true;
}

}  // namespace

Goal& FormulaCompiler::add(Goal::Kind kind, Value term, const Goal* next) {
  Goal& goal = code_.goals.emplace_back();
  goal.kind = kind;
  goal.term = term;
  goal.note_args();
  goal.next = next;
  return goal;
}

const Goal* FormulaCompiler::compile(Value formula, const Goal* next) {
  formula = deref(formula);
  if (formula.is_slot() || formula.is_variable()) return &add(Goal::Kind::variable, formula, next);
  if (formula.is_atom()) {
    const Predicate atom = formula.atom_id();
    if (atom == predicates::truth) {
      return next != nullptr ? next : &add(Goal::Kind::truth, formula, next);
    }
    if (atom == predicates::falsity) return &add(Goal::Kind::falsity, formula, next);
    if (symbols_.signature(atom).dotted) return compile_action(formula, next);
    Goal& goal = add(Goal::Kind::query, formula, next);
    goal.predicate = atom;
    goal.is_plain = true;
    return unfolded(goal);
  }
  if (formula.is_structure()) return compile_structure(formula, next);
  return &add(Goal::Kind::falsity, formula, next);
}

const Goal* FormulaCompiler::compile_structure(Value formula, const Goal* next) {
  const Structure& s = *formula.structure();
  switch (s.form()) {
    case Form::literal: {
      if (symbols_.signature(s.predicate()).dotted) return compile_action(formula, next);
      const auto kind = s.is_annotated() ? Goal::Kind::slow_query : Goal::Kind::query;
      Goal& goal = add(kind, formula, next);
      goal.predicate = s.predicate();
      goal.is_plain = kind == Goal::Kind::query && is_plain(s.arg_span());
      return unfolded(goal);
    }
    case Form::function:
      return compile_action(formula, next);
    case Form::relation:
      return compile_relation(formula, next);
    case Form::decorated:
      return &add(Goal::Kind::variable, formula, next);
    case Form::logical:
      break;
    default:
      return &add(Goal::Kind::falsity, formula, next);
  }
  if (s.predicate() == predicates::logical_and) return compile(s.arg(0), compile(s.arg(1), next));
  if (s.predicate() == predicates::logical_or) {
    Goal& goal = add(Goal::Kind::disjunction, formula, next);
    goal.inner = compile(s.arg(0), next);
    goal.other = compile(s.arg(1), next);
    return &goal;
  }
  Goal& negation = add(Goal::Kind::negation, formula, next);
  Goal& done = add(Goal::Kind::negation_done, formula, nullptr);
  done.origin = &negation;
  negation.inner = compile(s.arg(0), &done);
  return &negation;
}

const Goal* FormulaCompiler::unfolded(Goal& query) {
  if (unfolder_ == nullptr || query.kind != Goal::Kind::query) return &query;
  if (const auto rule = unfolder_->enter(query.predicate, query.args())) {
    query.kind = Goal::Kind::unfolded;
    query.table = rule->table;
    query.inner = compile(rule->body, query.next);
    unfolder_->leave();
  }
  return &query;
}

const Goal* FormulaCompiler::compile_relation(Value formula, const Goal* next) {
  const Predicate op = formula.structure()->predicate();
  const Goal::Kind kind = op == predicates::unify  ? Goal::Kind::unify
                          : op == predicates::univ ? Goal::Kind::univ
                                                   : Goal::Kind::compare;
  Goal& goal = add(kind, formula, next);
  goal.predicate = op;
  goal.orders = orders_of(op);
  goal.left = Operand::of(formula.structure()->arg(0));
  goal.right = Operand::of(formula.structure()->arg(1));
  return &goal;
}

const Goal* FormulaCompiler::compile_action(Value literal, const Goal* next) {
  const Predicate predicate =
      literal.is_atom() ? literal.atom_id() : literal.structure()->predicate();
  Goal& goal = add(Goal::Kind::action, literal, next);
  goal.predicate = predicate;
  goal.action = actions_.action(symbols_.functor(predicate));
  if (goal.action != nullptr && goal.action->probe != Probe::none) goal.kind = Goal::Kind::probe;
  if (goal.action == nullptr || goal.action->formula_args == 0) return &goal;
  const std::span<const Value> args = goal.args();
  goal.queries.resize(args.size());
  for (std::size_t i = 0; i < args.size(); ++i) {
    const bool last = i + 1 == args.size() && (goal.action->formula_args >> 31U) != 0;
    if (last || (i < 31 && (goal.action->formula_args >> i & 1U) != 0)) {
      goal.queries[i] = compile(args[i], nullptr);
    }
  }
  return &goal;
}

std::unique_ptr<RuleCode> make_rule(Value head, Value body, std::vector<Symbol> slot_names,
                                    Heap& heap, const ActionRegistry& actions,
                                    SymbolTable& symbols) {
  auto rule = std::make_unique<RuleCode>();
  const std::array<Value, 2> parts{head, body};
  rule->source =
      heap.structure(symbols.predicate(Signature{.functor = names::rule_text, .arity = 2}), parts,
                     Value::empty_list(), Form::rule);
  FormulaCompiler compiler(rule->body, actions, symbols);
  const Goal* entry = nullptr;
  if (head.is_structure()) {
    const Structure& s = *head.structure();
    std::vector<Value> args(s.arg_span().begin(), s.arg_span().end());
    for (Value& arg : args) {
      if (!is_evaluable(arg)) continue;
      const Value slot = Value::slot(static_cast<std::uint32_t>(slot_names.size()));
      slot_names.push_back(names::unnamed);
      const std::array<Value, 2> sides{slot, arg};
      entry = compiler.compile(
          heap.structure(predicates::unify, sides, Value::empty_list(), Form::relation), entry);
      arg = slot;
    }
    if (entry != nullptr) head = heap.structure(s.predicate(), args, s.annots());
  }
  rule->head = head;
  const bool is_true = body.is_atom() && body.atom_id() == predicates::truth;
  rule->body.entry = is_true ? entry : compiler.compile(body, entry);
  rule->slot_count = static_cast<std::uint32_t>(slot_names.size());
  rule->slot_names = std::move(slot_names);
  std::vector<Value> terms;
  for (const Goal& goal : rule->body.goals) terms.push_back(goal.term);
  rule->head_code = HeadCode(head, terms, rule->slot_names);
  return rule;
}

}  // namespace jaywalk
