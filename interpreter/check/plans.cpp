// SPDX-License-Identifier: Apache-2.0
// Plans and formulas that are never reached, failure plans of no goal, atomic plans that wait.
// Rules that can only answer by way of themselves.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/checking.h"
#include "interpreter/check/index/traversal.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/printer.h"

namespace jaywalk {
namespace {

using ast::BodyOperator;
using ast::Kind;
using ast::Node;
using ast::Plan;
using ast::TriggerKind;
using ast::TriggerOperator;

// The most plans for one trigger that are compared with later ones.
constexpr std::size_t kMostCompared = 100;

bool is_always(const Node* context) {
  return context == nullptr || (context->kind == Kind::truth && context->text == "true");
}

/// Whether whatever unifies with the special term unifies with the general one, too; variables of
/// the general one stand for terms of the special one.
class Subsumption {
 public:
  bool covers(const Node& general, const Node& special) {
    if (general.kind == Kind::variable && general.annots == nullptr && general.ns == nullptr &&
        !general.negated) {
      if (general.text.front() == '_') return true;
      const auto [known, is_new] = values_.emplace(general.text, print(special));
      const bool fresh = special.kind == Kind::variable && special.text.front() == '_';
      return is_new || (!fresh && known->second == print(special));
    }
    if (general.kind != Kind::literal || special.kind != Kind::literal) {
      return print(general) == print(special) && is_ground(general);
    }
    return same_name(general, special) && annots_covered(general, special) &&
           std::equal(general.args.begin(), general.args.end(), special.args.begin(),
                      special.args.end(),
                      [&](const Node* a, const Node* b) { return covers(*a, *b); });
  }

 private:
  static bool is_ground(const Node& node) {
    bool ground = true;
    each_node(node, [&](const Node& each) { ground &= each.kind != Kind::variable; });
    return ground;
  }

  static bool same_name(const Node& a, const Node& b) {
    if (a.text != b.text || a.negated != b.negated || a.this_namespace != b.this_namespace) {
      return false;
    }
    if (a.ns == nullptr || b.ns == nullptr) return a.ns == b.ns;
    return a.ns->kind == Kind::literal && a.ns->text == b.ns->text;
  }

  // Whether the annotations of the general literal are among those of the special one.
  static bool annots_covered(const Node& general, const Node& special) {
    if (general.annots == nullptr) return true;
    return special.annots != nullptr && is_ground(*general.annots) &&
           print(*general.annots) == print(*special.annots);
  }

  std::map<std::string_view, std::string> values_;
};

// Whether the first is chosen wherever the second could be.
bool comes_first(const Plan& first, const Plan& second) {
  const bool same = print(*first.trigger.literal) == print(*second.trigger.literal);
  if (is_always(first.context)) {
    return same || Subsumption().covers(*first.trigger.literal, *second.trigger.literal);
  }
  return same && second.context != nullptr && print(*first.context) == print(*second.context);
}

bool has_annotation(const Plan& plan, std::string_view name, std::size_t arity) {
  if (plan.label == nullptr) return false;
  const Node* const annots = plan.label->kind == Kind::list ? plan.label : plan.label->annots;
  return annots != nullptr && std::ranges::any_of(annots->args, [&](const Node* annot) {
           return annot->kind == Kind::literal && annot->text == name &&
                  annot->args.size() == arity;
         });
}

// Options of a policy: which of those that are applicable is chosen, is drawn.
bool are_options(const Plan& first, const Plan& second) {
  return has_annotation(first, "learned", 1) && has_annotation(second, "learned", 1);
}

using TriggerKey = std::tuple<TriggerOperator, TriggerKind, std::string_view, std::size_t>;

void look_for_unreachable(Checking& checking, CheckedFile& file,
                          const std::vector<const Plan*>& plans,
                          const Lazy<bool>& choice_may_change) {
  std::map<TriggerKey, std::vector<const Plan*>> earlier;
  for (const Plan* plan : plans) {
    const Node& literal = *plan->trigger.literal;
    if (literal.kind != Kind::literal) continue;
    auto& rivals =
        earlier[{plan->trigger.op, plan->trigger.kind, literal.text, literal.args.size()}];
    const auto first = std::ranges::find_if(rivals, [&](const Plan* rival) {
      return !are_options(*rival, *plan) && comes_first(*rival, *plan);
    });
    if (first != rivals.end()) {
      if (*choice_may_change) return;
      const auto line = file.file->source->position((*first)->trigger.literal->span.begin).line;
      checking.warn(file, literal.span,
                    fmt::format("this plan is never chosen: the one at line {} is, whenever this "
                                "could be",
                                line),
                    is_always((*first)->context) ? "put the plan without a condition last"
                                                 : "both have the same trigger and context");
    } else if (rivals.size() < kMostCompared) {
      rivals.push_back(plan);
    }
  }
}

// Whether the program can remove plans, or choose among them itself.
bool changes_choice(const Checking& checking) {
  const auto& names = checking.mentions().names;
  const auto removes = [](std::string_view name) { return traits_of(name).removes_plans; };
  return std::ranges::any_of(names, removes) || names.contains("untellHow") ||
         names.contains("untell-how") ||
         !checking.index().beliefs.arities("select__option").empty();
}

/// Calls `visit(formulas)` for the body and for each block within.
template <class Visit>
void each_block(std::span<const ast::Formula> formulas, Visit&& visit) {
  visit(formulas);
  for (const ast::Formula& formula : formulas) {
    if (formula.statement == ast::Statement::formula) {
      if (formula.node->kind == Kind::body && formula.op == BodyOperator::none) {
        each_block(formula.node->formulas, visit);
      }
      continue;
    }
    for (const Node* argument : formula.node->args) {
      if (argument->kind == Kind::body) each_block(argument->formulas, visit);
    }
  }
}

bool always_fails(const ast::Formula& formula) {
  return formula.op == BodyOperator::none && formula.statement == ast::Statement::formula &&
         formula.node->kind == Kind::literal && traits_of(formula.node->text).fails;
}

bool is_atomic(const Plan& plan) { return has_annotation(plan, "atomic", 0); }

bool waits(const Node& action) {
  const ActionTraits traits = traits_of(action.text);
  if (!traits.waits_with(action.args.size())) return false;
  // Messages suspend the intention only if they ask.
  return traits.about != About::message ||
         action.args[traits.performative]->text.starts_with("ask");
}

using ast::Kind;
using ast::Node;
using ast::Operator;

bool is_same(const Node& a, const Node& b) {
  return a.kind == Kind::literal && a.text == b.text && a.args.size() == b.args.size() &&
         a.negated == b.negated && a.ns == nullptr && b.ns == nullptr;
}

// Whether there is no answer to the formula without one to a literal like the head.
bool needs(const Node& formula, const Node& head) {
  if (formula.op == Operator::logical_and) {
    return needs(*formula.args[0], head) || needs(*formula.args[1], head);
  }
  if (formula.op == Operator::logical_or) {
    return needs(*formula.args[0], head) && needs(*formula.args[1], head);
  }
  return is_same(formula, head);
}

using HeadKey = std::tuple<std::string_view, std::size_t, bool>;

}  // namespace

void unreachable_plans(Checking& checking) {
  const Lazy<bool> choice_may_change([&checking] { return changes_choice(checking); });
  for (CheckedFile& file : checking.files()) {
    for (const auto& plans : file.uses.plan_lists) {
      look_for_unreachable(checking, file, plans, choice_may_change);
    }
  }
}

void unreachable_formulas(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    for (const Plan* plan : file.uses.plans) {
      each_block(plan->body, [&](std::span<const ast::Formula> formulas) {
        const auto failing = std::ranges::find_if(formulas, always_fails);
        if (failing == formulas.end() || failing + 1 == formulas.end()) return;
        checking.warn(file, (failing + 1)->span, "this is never done: the '.fail' before it fails");
      });
    }
  }
}

void orphan_failure_plans(Checking& checking) {
  if (checking.may_be_told_plans()) return;
  for (CheckedFile& file : checking.files()) {
    for (const Plan* plan : file.uses.plans) {
      const Node& goal = *plan->trigger.literal;
      const bool failure =
          plan->trigger.op == TriggerOperator::remove && plan->trigger.kind == TriggerKind::achieve;
      if (!failure || goal.kind != Kind::literal) continue;
      const NameSet& plans = checking.index().achievable_goals;
      if (plans.contains(goal.text, arity_of(goal))) continue;
      std::string hint = plans.arities(goal.text).empty()
                             ? did_you_mean(goal.text, plans.names())
                             : "the plans +! for it have another number of arguments";
      checking.warn(
          file, goal.span,
          fmt::format("there is a plan for the failure of '{}', but none for the goal", goal.text),
          std::move(hint));
    }
  }
}

void waiting_atomic_plans(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    for (const Plan* plan : file.uses.plans) {
      if (!is_atomic(*plan)) continue;
      each_block(plan->body, [&](std::span<const ast::Formula> formulas) {
        for (const ast::Formula& formula : formulas) {
          const Node& node = *formula.node;
          if (formula.op != BodyOperator::none || node.kind != Kind::literal || !waits(node)) {
            continue;
          }
          checking.warn(file, node.span,
                        fmt::format("the whole agent waits for '{}' in an atomic plan", node.text),
                        "wait in a plan that is not atomic");
        }
      });
    }
  }
}

void endless_rules(Checking& checking) {
  if (checking.index().has_open_beliefs) return;
  std::map<HeadKey, bool> has_base;  // beside facts
  for (const CheckedFile& file : checking.files()) {
    for (const auto& [head, body] : file.uses.clauses) {
      if (body == nullptr) continue;
      has_base[{head->text, head->args.size(), head->negated}] |= !needs(*body, *head);
    }
  }
  for (CheckedFile& file : checking.files()) {
    for (const auto& [head, body] : file.uses.clauses) {
      if (body == nullptr || has_base[{head->text, head->args.size(), head->negated}]) continue;
      if (checking.index().facts.contains(head->text, arity_of(*head))) continue;
      checking.warn(file, head->span,
                    fmt::format("'{}' has no answer: every rule for it needs another '{}'",
                                head->text, head->text),
                    "add a rule or a belief that ends the recursion");
    }
  }
}

}  // namespace jaywalk
