// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/reach.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {
namespace {

constexpr std::array<std::string_view, 8> kPlanPerformatives{"tellHow",    "askHow",   "untellHow",
                                                             "tell-how",   "ask-how",  "untell-how",
                                                             "'tell-how'", "'ask-how'"};

bool is_one_of(std::string_view name, const auto& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Reads all terms of a program.
class Reader {
 public:
  Reader(const Program& program, const SymbolTable& symbols)
      : program_(program), symbols_(symbols) {}

  Reach read() {
    for (const Program::Belief& belief : program_.beliefs()) {
      term(belief.fact);
      if (belief.rule == nullptr) continue;
      term(belief.rule->head);
      formulas(belief.rule->body);
    }
    for (const Program::Goal& goal : program_.goals()) term(goal.literal);
    library(program_.library());
    return reach_;
  }

 private:
  void library(const PlanLibrary& library) {
    for (const auto& each : library.plans()) {
      if (!each->is_standard) plan(*each);
    }
  }

  void plan(const Plan& plan) {
    term(plan.trigger);
    term(plan.label);
    formulas(plan.code.formulas);
    for (const Body& body : plan.code.bodies) {
      for (const Step& step : body.steps) {
        if (step.kind == Step::Kind::variable) reach_.runs_terms = true;
        term(step.term);
      }
    }
    if (plan.subplans != nullptr) library(*plan.subplans);
  }

  void formulas(const FormulaCode& code) {
    for (const jaywalk::Goal& goal : code.goals) {
      if (goal.kind == jaywalk::Goal::Kind::variable) reach_.runs_terms = true;
      term(goal.term);
    }
  }

  void term(Value value) {
    switch (value.kind()) {
      case Value::Kind::atom:
        name(value.atom_id(), {});
        break;
      case Value::Kind::text:
        if (is_one_of(value.text()->view(), kPlanPerformatives)) reach_.sends_plans = true;
        break;
      case Value::Kind::pair:
        for (; value.is_pair(); value = value.pair()->tail) term(value.pair()->head);
        term(value);
        break;
      case Value::Kind::structure: {
        const Structure& structure = *value.structure();
        name(structure.predicate(), structure.arg_span());
        for (const Value arg : structure.arg_span()) term(arg);
        term(structure.annots());
        break;
      }
      case Value::Kind::number:
      case Value::Kind::special:
      case Value::Kind::variable:
      case Value::Kind::object:
        break;
    }
  }

  void name(Predicate predicate, std::span<const Value> args) {
    const std::string_view functor = symbols_.functor(predicate);
    if (is_one_of(functor, kPlanPerformatives)) reach_.sends_plans = true;
    if (!symbols_.signature(predicate).dotted) return;
    if (functor == ".term2string") reach_.makes_terms = true;
    if (functor == ".wait" && !args.empty() && (args[0].is_slot() || args[0].is_variable())) {
      reach_.runs_terms = true;
    }
    if (is_far(functor, args.size())) reach_.is_far = true;
  }

  // The effects of host-defined actions are unknown.
  [[nodiscard]] bool is_far(std::string_view functor, std::size_t arity) const {
    if (const ActionDefinition* const action = program_.actions().action(functor)) {
      const ActionDefinition* const standard = standard_actions().action(functor);
      if (standard == nullptr || action->own || standard->function != action->function) return true;
      return traits_of(action->name).is_far(arity);
    }
    const FunctionDefinition* const function = program_.actions().function(functor, arity);
    const FunctionDefinition* const standard = standard_actions().function(functor, arity);
    return function != nullptr &&
           (standard == nullptr || function->own || standard->function != function->function);
  }

  const Program& program_;
  const SymbolTable& symbols_;
  Reach reach_;
};

}  // namespace

Reach reach_of(const Program& program, const SymbolTable& symbols) {
  return Reader(program, symbols).read();
}

void Reaches::add(const Program& program, const SymbolTable& symbols) {
  const auto [entry, is_new] = programs_.try_emplace(&program);
  if (!is_new) return;
  entry->second = reach_of(program, symbols);
  const Reach& reach = entry->second;
  all_.is_far = all_.is_far || reach.is_far;
  all_.runs_terms = all_.runs_terms || reach.runs_terms;
  all_.makes_terms = all_.makes_terms || reach.makes_terms;
  all_.sends_plans = all_.sends_plans || reach.sends_plans;
  ++version_;
}

bool Reaches::is_near(const Program& program) const {
  const Reach& reach = programs_.at(&program);
  if (reach.is_far || all_.sends_plans) return false;
  return !reach.runs_terms || !(all_.is_far || all_.makes_terms);
}

}  // namespace jaywalk
