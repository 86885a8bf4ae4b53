// SPDX-License-Identifier: Apache-2.0
// Names that mean nothing: goals without plans, queries that nothing answers, actions that are
// none, percepts that agents never have in the scenario of their program.

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/check/checking.h"

namespace jaywalk {
namespace {

using ast::Node;

// Whether it stands in a rule of a library that the program does not use.
bool is_in_unused_rule(const Checking& checking, const CheckedFile& file, const Node& query) {
  return !file.is_main && std::ranges::any_of(file.uses.clauses, [&](const Clause& clause) {
    return clause.body != nullptr && clause.body->span.begin <= query.span.begin &&
           query.span.end <= clause.body->span.end && !checking.is_mentioned(clause.head->text);
  });
}

// Looks at literals that a percept would answer, and warns of each absent percept once.
class AbsentPercepts {
 public:
  explicit AbsentPercepts(Checking& checking) : checking_(checking) {}

  void look_at(CheckedFile& file, const Node& literal) {
    if (literal.kind != ast::Kind::literal) return;
    const Vocabulary::Entry* const percept =
        entry_of(checking_.vocabulary().percepts, literal.text);
    if (percept == nullptr || percept->absent_without.empty()) return;
    if (!takes(*percept, arity_of(literal)) || comes_from_elsewhere(*percept)) return;
    if (is_in_unused_rule(checking_, file, literal) || told_.contains(literal.text)) return;
    const std::size_t before = file.found.warning_count();
    checking_.warn(file, literal.span,
                   fmt::format("the scenario does not give the percept '{}'", literal.text),
                   fmt::format("it needs {}", percept->absent_without));
    if (file.found.warning_count() > before) told_.insert(literal.text);
  }

 private:
  [[nodiscard]] bool comes_from_elsewhere(const Vocabulary::Entry& percept) const {
    return checking_.index().given.contains(percept.name, percept.least_args) ||
           checking_.index().planned_tests.contains(percept.name, percept.least_args) ||
           checking_.vocabulary().named_by_others.contains(percept.name);
  }

  Checking& checking_;
  std::set<std::string_view> told_;
};

}  // namespace

using ast::Kind;
using ast::Node;

void unknown_goals(Checking& checking) {
  const ProgramIndex& index = checking.index();
  if (checking.may_be_told_plans()) return;
  for (CheckedFile& file : checking.files()) {
    for (const Node* goal : file.uses.goals) {
      if (goal->kind != Kind::literal || !index.planned_goals.arities(goal->text).empty()) continue;
      if (file.asked.contains(goal_name(*goal))) continue;
      std::string hint =
          checking.is_full(file) ? "" : did_you_mean(goal->text, index.planned_goals.names());
      if (hint.empty()) hint = checking.library_defining(goal_name(*goal));
      checking.warn(file, goal->span, fmt::format("no plan for the goal '{}'", goal->text),
                    std::move(hint));
    }
  }
}

void unknown_beliefs(Checking& checking) {
  if (checking.index().has_open_beliefs) return;
  for (CheckedFile& file : checking.files()) {
    for (const Node* belief : file.uses.queries) {
      if (!checking.answers().arities(belief->text).empty()) continue;
      if (file.asked.contains(belief_name(*belief))) continue;
      if (checking.is_full(file)) break;
      std::vector<std::string> names = checking.answers().names();
      if (!checking.told_everything()) {
        std::erase_if(names, [&](const auto& name) { return !is_misspelling(belief->text, name); });
      }
      std::string hint = did_you_mean(belief->text, names);
      if (hint.empty() && !checking.told_everything()) continue;
      if (hint.empty()) hint = checking.library_defining(belief_name(*belief));
      checking.warn(file, belief->span,
                    fmt::format("'{}' is neither a belief nor a percept", belief->text),
                    std::move(hint));
    }
  }
}

namespace {

// `wait(500)` for `.wait(500)`.
bool lacks_dot(const Vocabulary& vocabulary, const Node& action) {
  return std::ranges::any_of(vocabulary.internal_actions, [&](const Vocabulary::Entry& entry) {
    return !entry.is_function && entry.name.substr(1) == action.text &&
           takes(entry, arity_of(action));
  });
}

std::string hint_for_dot(const Node& action) {
  return fmt::format("internal actions begin with a dot: '.{}'", action.text);
}

// Warns of actions that lack their dot, if the environment is unknown and there are no other
// actions.
void actions_without_dot(Checking& checking) {
  const auto is_slip = [&](const Node* action) {
    return lacks_dot(checking.vocabulary(), *action);
  };
  const bool has_environment = std::ranges::any_of(checking.files(), [&](const CheckedFile& file) {
    return !std::ranges::all_of(file.uses.actions, is_slip);
  });
  if (has_environment) return;
  for (CheckedFile& file : checking.files()) {
    for (const Node* action : file.uses.actions) {
      checking.warn(file, action->span,
                    fmt::format("'{}' is an action of an environment", action->text),
                    hint_for_dot(*action));
    }
  }
}

}  // namespace

void unknown_actions(Checking& checking) {
  const Vocabulary& vocabulary = checking.vocabulary();
  if (!vocabulary.environment_known) return actions_without_dot(checking);
  for (CheckedFile& file : checking.files()) {
    for (const Node* action : file.uses.actions) {
      if (entry_of(vocabulary.actions, action->text) != nullptr) continue;
      std::string hint = lacks_dot(vocabulary, *action)
                             ? hint_for_dot(*action)
                             : did_you_mean(action->text, names_of(vocabulary.actions));
      if (hint.empty() && !checking.index().planned_goals.arities(action->text).empty()) {
        hint = fmt::format("there are plans for it: write '!{}'", action->text);
      }
      if (hint.empty() && !checking.answers().arities(action->text).empty()) {
        hint = fmt::format("to ask for a belief, write '?{}'", action->text);
      }
      checking.warn(file, action->span,
                    fmt::format("the environment has no action '{}'", action->text),
                    std::move(hint));
    }
  }
}

void unknown_internal_actions(Checking& checking) {
  const auto& known = checking.vocabulary().internal_actions;
  if (known.empty()) return;
  std::set<std::string_view> reported;  // a package that is missing is mostly called more than once
  for (CheckedFile& file : checking.files()) {
    for (const Node* action : file.uses.internal_actions) {
      if (!checking.index().functions.arities(action->text).empty()) continue;
      if (entry_of(known, short_name(action->text)) != nullptr) continue;
      if (reported.contains(action->text)) continue;
      const std::size_t before = file.found.warning_count();
      checking.warn(file, action->span,
                    fmt::format("there is no internal action '{}'", action->text),
                    did_you_mean(action->text, names_of(known)));
      if (file.found.warning_count() > before) reported.insert(action->text);
    }
  }
}

void absent_percepts(Checking& checking) {
  if (checking.index().has_open_beliefs) return;
  AbsentPercepts absent(checking);
  for (CheckedFile& file : checking.files()) {
    for (const Node* query : file.uses.queries) absent.look_at(file, *query);
    for (const ast::Plan* plan : file.uses.plans) {
      if (plan->trigger.kind == ast::TriggerKind::belief) {
        absent.look_at(file, *plan->trigger.literal);
      }
    }
  }
}

}  // namespace jaywalk
