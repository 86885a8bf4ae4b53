// SPDX-License-Identifier: Apache-2.0
#include "interpreter/coverage/probes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "interpreter/logic/formula_compiler.h"
#include "interpreter/program/plan_compiler.h"

namespace jaywalk {
namespace {

constexpr std::string_view kAsked = ".condition_asked";        // (Number, Asking, Variables...)
constexpr std::string_view kAnswered = ".condition_answered";  // (Number, Asking)

void collect_slots(Value term, std::vector<std::uint32_t>& slots) {
  if (term.is_slot()) {
    if (std::find(slots.begin(), slots.end(), term.slot_index()) == slots.end()) {
      slots.push_back(term.slot_index());
    }
  } else if (term.is_structure()) {
    const Structure& s = *term.structure();
    for (const Value arg : s.arg_span()) collect_slots(arg, slots);
    if (s.is_annotated()) collect_slots(s.annots(), slots);
  } else {
    for (; term.is_pair(); term = term.pair()->tail) collect_slots(term.pair()->head, slots);
    if (term.is_slot()) collect_slots(term, slots);
  }
}

ActionDefinition probe(std::string_view name, Probe kind) {
  ActionDefinition action;
  action.name = name;
  action.signature = name;
  action.probe = kind;
  return action;
}

}  // namespace

// Puts probes around the conditions of a formula. In a context a condition is asked again only when
// its last asking is over; rules are asked within and beside each other, so a variable of its own
// carries the name of the asking from one probe to the other.
class Probes::Rewriter {
 public:
  /// `first_slot`: where the rule's own variables end; kNone: the formula is a context.
  Rewriter(Probes& probes, std::span<const Symbol> slot_names, std::size_t first_slot)
      : probes_(probes), slot_names_(slot_names), next_slot_(first_slot) {}

  Value rewrite(Value formula) {
    if (is_form(formula, Form::logical)) {
      const Structure& s = *formula.structure();
      std::array<Value, 2> args;
      const bool is_negation = s.predicate() == predicates::logical_not;
      const std::uint32_t nots = std::exchange(nots_, 0);
      const bool outside = negated_;
      if (is_negation) {
        nots_ = nots + 1;
      } else if (nots % 2 == 1) {
        negated_ = !negated_;  // of a whole group
      }
      for (std::size_t i = 0; i < s.arity; ++i) args[i] = rewrite(s.arg(i));
      nots_ = 0;
      negated_ = outside;
      return probes_.heap_.structure(s.predicate(), std::span(args.data(), s.arity),
                                     Value::empty_list(), Form::logical);
    }
    ProbedCondition condition{.slots = {},
                              .slot_names = slot_names_,
                              .nots = std::exchange(nots_, 0),
                              .negated = negated_};
    if (is_literal(formula)) condition.asks = literal_parts(formula).predicate;
    collect_slots(formula, condition.slots);
    const Value number = Value::number(static_cast<double>(probes_.conditions_.size()));
    Value asking = Value::number(0);
    if (next_slot_ != kNone) asking = Value::slot(static_cast<std::uint32_t>(next_slot_++));
    std::vector<Value> args{number, asking};
    const Value end = call(kAnswered, args);
    if (probes_.detail_ == Detail::bindings) {
      for (const std::uint32_t slot : condition.slots) args.push_back(Value::slot(slot));
    }
    probes_.conditions_.push_back(std::move(condition));
    return conjunction(call(kAsked, args), conjunction(formula, end));
  }

  [[nodiscard]] std::size_t next_slot() const { return next_slot_; }

 private:
  Value call(std::string_view name, std::span<const Value> args) {
    const Predicate predicate =
        probes_.symbols_.predicate(name, static_cast<std::uint16_t>(args.size()));
    return probes_.heap_.structure(predicate, args);
  }
  Value conjunction(Value left, Value right) {
    const std::array<Value, 2> args{left, right};
    return probes_.heap_.structure(predicates::logical_and, args, Value::empty_list(),
                                   Form::logical);
  }

  Probes& probes_;
  std::span<const Symbol> slot_names_;
  std::size_t next_slot_;
  std::uint32_t nots_ = 0;
  bool negated_ = false;
};

Probes::Probes(const std::shared_ptr<const SymbolTable>& symbols, Detail detail)
    : symbols_(symbols), detail_(detail), heap_(Heap::Owner::program) {}
Probes::~Probes() = default;

const ActionRegistry& Probes::with_probes(const ActionRegistry& actions) {
  const auto [found, is_new] = registries_.try_emplace(&actions);
  if (is_new) {
    found->second.add_all(actions);
    found->second.add(probe(kAsked, Probe::asked));
    found->second.add(probe(kAnswered, Probe::answered));
  }
  return found->second;
}

void Probes::add(const std::shared_ptr<const Program>& program) {
  if (std::find(programs_.begin(), programs_.end(), program) != programs_.end()) return;
  programs_.push_back(program);
  const ActionRegistry& actions = with_probes(program->actions());
  const std::size_t first = plans_.size();
  for (const auto& plan : program->library().plans()) add_plan(*plan, actions);
  if (plans_.size() > first) plans_[first].first_plan_of_program = true;
  for (const Program::Belief& belief : program->beliefs()) {
    if (belief.rule != nullptr) add_rule(belief, actions);
  }
}

void Probes::add_plan(const Plan& plan, const ActionRegistry& actions) {
  if (plan.is_standard) return;
  ProbedPlan probed{
      .plan = &plan, .first_condition = conditions_.size(), .first_formula = formulas_.size()};
  if (plan.context != nullptr) {
    const Value context =
        Rewriter(*this, plan.slot_names, kNone).rewrite(plan_parts(plan.source).context);
    FormulaCode& code = *contexts_.emplace_back(std::make_unique<FormulaCode>());
    code.entry = FormulaCompiler(code, actions, symbols_).compile(context, nullptr);
    probed.context = code.entry;
  }
  add_formulas(*plan.code.entry);
  probed.conditions = conditions_.size() - probed.first_condition;
  probed.formulas = formulas_.size() - probed.first_formula;
  plan_index_.insert(key(&plan), static_cast<std::uint32_t>(plans_.size()));
  plans_.push_back(probed);
  if (plan.subplans == nullptr) return;
  for (const auto& inner : plan.subplans->plans()) add_plan(*inner, actions);
}

void Probes::add_rule(const Program::Belief& belief, const ActionRegistry& actions) {
  const RuleCode& rule = *belief.rule;
  ProbedRule probed{.rule = &rule,
                    .predicate = belief.predicate,
                    .where = belief.where,
                    .first_condition = conditions_.size()};
  const Structure& source = *rule.source.structure();
  const Value body = deref(source.arg(1));
  // Computed values in the head had slots of their own behind the written ones; they get others
  // now.
  Rewriter rewriter(*this, rule.slot_names, rule.slot_count);
  const bool is_true = body.is_atom() && body.atom_id() == predicates::truth;
  const Value rewritten = is_true ? body : rewriter.rewrite(body);
  std::vector<Symbol> names = rule.slot_names;
  names.resize(rewriter.next_slot(), names::unnamed);
  probed.probed =
      make_rule(deref(source.arg(0)), rewritten, std::move(names), heap_, actions, symbols_);
  probed.probed->source = rule.source;
  probed.conditions = conditions_.size() - probed.first_condition;
  rule_index_.insert(key(&rule), static_cast<std::uint32_t>(rules_.size()));
  rules_.push_back(std::move(probed));
}

// In the order in which they are written; what forks add is left out.
void Probes::add_formulas(const Body& body) {
  for (const Step& step : body.steps) {
    if (step.kind == Step::Kind::join) continue;
    step_index_.insert(key(&step), static_cast<std::uint32_t>(formulas_.size()));
    formulas_.push_back(&step);
    if (step.first != nullptr) add_formulas(*step.first);
    if (step.second != nullptr) add_formulas(*step.second);
    for (const Body* const branch : step.branches) add_formulas(*branch);
  }
}

}  // namespace jaywalk
