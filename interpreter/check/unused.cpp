// SPDX-License-Identifier: Apache-2.0
// Plans and rules that nothing uses.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using ast::TriggerKind;
using ast::TriggerOperator;

// Rules that the interpreter itself asks for, and goals that it posts.
bool is_reserved(std::string_view name) {
  return name.starts_with("kqml") || name.starts_with("jag_") || name == "select__option" ||
         name == "observation";
}

// A plan that `jaywalk test` runs, or that says itself where it comes from.
bool is_test(const ast::Plan& plan) {
  if (plan.label == nullptr) return false;
  const Node* const annots = plan.label->kind == Kind::list ? plan.label : plan.label->annots;
  if (annots == nullptr) return false;
  for (const Node* annot : annots->args) {
    if (annot->text == "test") return true;
  }
  return false;
}

// With more goals than this, no similar names are searched for.
constexpr std::size_t kMostGoals = 500;

/// The goals that are posted, those with plans and those without.
struct PostedGoals {
  std::vector<std::string> planned;
  std::vector<std::string> unplanned;

  explicit PostedGoals(const ProgramIndex& index) {
    for (std::string& goal : index.posted_goals.names()) {
      const bool has_plan = !index.planned_goals.arities(goal).empty();
      (has_plan ? planned : unplanned).push_back(std::move(goal));
    }
    if (planned.size() > kMostGoals) planned.clear();
    if (unplanned.size() > kMostGoals) unplanned.clear();
  }

  /// A goal with plans that the plan is meant for, as a hint.
  [[nodiscard]] std::string meant(std::string_view plan) const {
    std::vector<std::string> goals;
    for (const std::string& goal : planned) {
      if (is_misspelling(plan, goal)) goals.push_back(goal);
    }
    return did_you_mean(plan, goals);
  }
  /// Whether a goal without plans is a slip for that plan's: unknown_goals reports it then.
  [[nodiscard]] bool is_missed(std::string_view plan) const {
    const std::vector<std::string> only = {std::string(plan)};
    return std::ranges::any_of(
        unplanned, [&](const std::string& goal) { return !did_you_mean(goal, only).empty(); });
  }
};

void achievement(Checking& checking, CheckedFile& file, const PostedGoals& posted,
                 const Node& goal) {
  if (!checking.index().posted_goals.arities(goal.text).empty()) return;
  std::string hint = posted.meant(goal.text);
  const bool certain = checking.asked_by_nobody() && !checking.is_mentioned(goal.text) &&
                       !posted.is_missed(goal.text);
  if (hint.empty() && !certain) return;
  checking.warn(file, goal.span, fmt::format("nobody posts the goal '{}'", goal.text),
                std::move(hint));
}

void test_goal(Checking& checking, CheckedFile& file, const Node& goal) {
  if (!checking.asked_by_nobody() || checking.is_mentioned(goal.text)) return;
  checking.warn(file, goal.span, fmt::format("nobody asks for '{}'", goal.text));
}

using Names = std::set<std::string_view>;

// Only of a known environment is it known what there is to perceive.
void belief(Checking& checking, CheckedFile& file, const Lazy<Names>& heads, const Node& literal) {
  if (!checking.told_everything() || !checking.asked_by_nobody() ||
      checking.is_mentioned(literal.text) || heads->contains(literal.text) ||
      entry_of(checking.vocabulary().percepts, literal.text) != nullptr) {
    return;
  }
  checking.warn(file, literal.span,
                fmt::format("'{}' is neither perceived nor believed", literal.text),
                did_you_mean(literal.text, names_of(checking.vocabulary().percepts)));
}

}  // namespace

void unused_plans(Checking& checking) {
  if (checking.index().has_open_goals) return;
  const PostedGoals posted(checking.index());
  const Lazy<Names> heads([&checking] {
    Names names;
    for (const CheckedFile& file : checking.files()) {
      for (const Clause& clause : file.uses.clauses) names.insert(clause.head->text);
    }
    return names;
  });
  for (CheckedFile& file : checking.files()) {
    for (const ast::Plan* plan : file.uses.plans) {
      const Node& literal = *plan->trigger.literal;
      if (literal.kind != Kind::literal || plan->trigger.op == TriggerOperator::goal_state ||
          is_reserved(literal.text) || is_test(*plan)) {
        continue;
      }
      // Plans of included files may be meant for other programs.
      const bool included = !file.is_main;
      if (plan->trigger.kind == TriggerKind::belief) {
        if (!included) belief(checking, file, heads, literal);
      } else if (plan->trigger.op == TriggerOperator::remove) {
        // A failure plan; orphan_failure_plans looks at it.
      } else if (plan->trigger.kind == TriggerKind::achieve) {
        if (!included || !posted.meant(literal.text).empty()) {
          achievement(checking, file, posted, literal);
        }
      } else if (!included) {
        test_goal(checking, file, literal);
      }
    }
  }
}

void unused_rules(Checking& checking) {
  const bool is_passive = !checking.index().has_unread_parts &&
                          std::ranges::all_of(checking.files(), [](const CheckedFile& file) {
                            return file.uses.plans.empty();
                          });
  for (CheckedFile& file : checking.files()) {
    if (!file.is_main) continue;
    for (const Clause& clause : file.uses.clauses) {
      const Node& head = *clause.head;
      if (clause.body == nullptr || is_reserved(head.text)) continue;
      if (file.reported.contains({head.span.begin, "missing-definition"})) continue;
      // Without plans nothing asks for anything: a library is missing, if one asks for that rule.
      const std::string name = belief_name(head);
      std::string hint = is_passive && checking.library_defining(name).empty()
                             ? checking.library_asking(name)
                             : std::string();
      if (hint.empty() && !checking.asked_by_nobody()) continue;
      if (checking.is_mentioned(head.text)) continue;
      checking.warn(file, head.span, fmt::format("nothing asks for '{}'", head.text),
                    std::move(hint));
    }
  }
}

}  // namespace jaywalk
