// SPDX-License-Identifier: Apache-2.0
// Programs that never do anything, since no goal begins them.

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/check/checking.h"
#include "interpreter/check/index/traversal.h"
#include "interpreter/syntax/printer.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using ast::Plan;
using ast::TriggerKind;

class Beginning {
 public:
  explicit Beginning(Checking& checking) : checking_(checking) {
    for (const CheckedFile& file : checking.files()) {
      for (const Plan* plan : file.uses.plans) {
        const Node& trigger = *plan->trigger.literal;
        if (is_for_goal(*plan)) goals_.insert({trigger.text, trigger.args.size()});
        if (plan->trigger.kind == TriggerKind::belief) beliefs_.insert(trigger.text);
        each_formula(plan->body, [this](const ast::Formula& formula) {
          if (formula.op > ast::BodyOperator::test) beliefs_.insert(formula.node->text);
        });
      }
      for (const Node* query : file.uses.queries) beliefs_.insert(query->text);
    }
  }

  /// `walk.` for `!walk.`: a fact that nothing uses as one, and that has plans.
  bool tell_of_facts_for_goals() {
    bool told = false;
    for (CheckedFile& file : checking_.files()) {
      for (const Clause& clause : file.uses.clauses) {
        const Node& fact = *clause.head;
        const bool is_slip = clause.body == nullptr &&
                             goals_.contains({fact.text, fact.args.size()}) &&
                             !beliefs_.contains(fact.text) &&
                             !checking_.vocabulary().named_by_others.contains(fact.text);
        if (!is_slip) continue;
        checking_.warn(
            file, fact.span,
            fmt::format("'{}' is a belief here, and no goal begins the program", fact.text),
            fmt::format("did you mean '!{}'?", fact.text));
        told = true;
      }
    }
    return told;
  }

  /// Whether some plan is for an initial belief or a percept.
  [[nodiscard]] bool reacts() const {
    return std::ranges::any_of(checking_.files(), [this](const CheckedFile& file) {
      return std::ranges::any_of(file.uses.plans, [this](const Plan* plan) {
        return plan->trigger.kind == TriggerKind::belief && is_given(*plan->trigger.literal);
      });
    });
  }

  void tell_of_idleness() {
    CheckedFile& main = checking_.files().front();
    if (const Node* const goal = first_goal()) {
      const auto own = std::ranges::find_if(main.uses.plans,
                                            [](const Plan* plan) { return is_for_goal(*plan); });
      checking_.warn(main, own == main.uses.plans.end() ? Span{} : (*own)->trigger.literal->span,
                     "no goal begins the program, so that it does nothing",
                     fmt::format("begin with a goal: !{}.", print(*goal)));
      return;
    }
    const bool has_plans = std::ranges::any_of(
        checking_.files(), [](const CheckedFile& file) { return !file.uses.plans.empty(); });
    checking_.warn(main, Span{},
                   has_plans
                       ? "no plan is for anything that the agent believes or perceives, so that "
                         "it does nothing"
                       : "the program has no plan, so that it does nothing",
                   "an agent begins with a goal that it has a plan for: !start. +!start <- ...");
  }

 private:
  [[nodiscard]] bool is_given(const Node& literal) const {
    return literal.kind != Kind::literal ||
           !checking_.index().given.arities(literal.text).empty() ||
           entry_of(checking_.vocabulary().percepts, literal.text) != nullptr;
  }

  /// The goal of the first plan whose goal no plan posts, or else of the first plan; null: none is
  /// for a goal.
  [[nodiscard]] const Node* first_goal() const {
    const Node* first = nullptr;
    for (const CheckedFile& file : checking_.files()) {
      for (const Plan* plan : file.uses.plans) {
        if (!is_for_goal(*plan)) continue;
        const Node* const goal = plan->trigger.literal;
        if (checking_.index().posted_goals.arities(goal->text).empty()) return goal;
        if (first == nullptr) first = goal;
      }
    }
    return first;
  }

  Checking& checking_;
  std::set<std::pair<std::string_view, std::size_t>> goals_;  // that have plans
  std::set<std::string_view> beliefs_;                        // that plans and rules use
};

bool has_goal_patterns(const SourceTree& program) {
  return std::ranges::any_of(program.files, [](const auto& file) {
    return std::ranges::any_of(file->components, [](const ast::Component& component) {
      return component.is_block && component.literal->text != "namespace";
    });
  });
}

}  // namespace

void missing_goals(Checking& checking) {
  // A pattern of goals may begin by itself.
  if (checking.has_initial_goal() || checking.index().has_unread_parts ||
      has_goal_patterns(checking.program())) {
    return;
  }
  Beginning beginning(checking);
  if (beginning.tell_of_facts_for_goals()) return;
  const bool is_explained =
      std::ranges::any_of(checking.files().front().reported,
                          [](const auto& each) { return each.second == "unused-rule"; });
  if (!checking.vocabulary().begins_by_itself || is_explained || beginning.reacts()) return;
  beginning.tell_of_idleness();
}

}  // namespace jaywalk
