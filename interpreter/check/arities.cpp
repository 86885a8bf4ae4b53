// SPDX-License-Identifier: Apache-2.0
// Known names with a number of arguments that they do not have.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "interpreter/check/checking.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;

void goals(Checking& checking, CheckedFile& file) {
  const ProgramIndex& index = checking.index();
  if (checking.may_be_told_plans()) return;
  for (const Node* goal : file.uses.goals) {
    if (goal->kind != Kind::literal) continue;
    const int arity = arity_of(*goal);
    const std::set<int> planned = index.planned_goals.arities(goal->text);
    if (planned.empty() || index.planned_goals.contains(goal->text, arity)) continue;
    if (file.asked.contains(goal_name(*goal))) continue;
    checking.warn(
        file, goal->span,
        fmt::format("no plan for the goal '{}' with {}", goal->text, counted(std::set{arity})),
        fmt::format("there are plans for it with {}", counted(planned)));
  }
}

// Other agents may send literals that the program itself does not contain, but never a percept of
// the environment.
void beliefs(Checking& checking, CheckedFile& file) {
  if (checking.index().has_open_beliefs) return;
  for (const Node* belief : file.uses.queries) {
    const int arity = arity_of(*belief);
    const std::set<int> known = checking.answers().arities(belief->text);
    if (known.empty() || checking.answers().contains(belief->text, arity)) continue;
    if (file.asked.contains(belief_name(*belief))) continue;
    const bool percept = entry_of(checking.vocabulary().percepts, belief->text) != nullptr;
    if (!checking.told_everything() && !percept) continue;
    checking.warn(
        file, belief->span,
        fmt::format("nothing is known of '{}' with {}", belief->text, counted(std::set{arity})),
        fmt::format("it is known with {}", counted(known)));
  }
}

void actions(Checking& checking, CheckedFile& file) {
  if (!checking.vocabulary().environment_known) return;
  for (const Node* action : file.uses.actions) {
    const int arity = arity_of(*action);
    std::set<int> known;  // `move(Way)` and `move(Way,Cells)` are two
    bool taken = false;
    for (const Vocabulary::Entry& entry : checking.vocabulary().actions) {
      if (entry.name != action->text) continue;
      known.insert({entry.least_args, entry.most_args});
      taken = taken || takes(entry, arity);
    }
    if (known.empty() || taken) continue;
    checking.warn(
        file, action->span,
        fmt::format("the action '{}' has {}, not {}", action->text, counted(known), arity));
  }
}

// A name can be that of an action and of a function.
void internal_actions(Checking& checking, CheckedFile& file) {
  const auto& entries = checking.vocabulary().internal_actions;
  for (const Node* action : file.uses.internal_actions) {
    const int arity = arity_of(*action);
    const std::string_view name = short_name(action->text);
    const Vocabulary::Entry* const known = entry_of(entries, name);
    const bool taken = std::ranges::any_of(entries, [&](const Vocabulary::Entry& entry) {
      return entry.name == name && takes(entry, arity);
    });
    if (known == nullptr || taken || checking.index().functions.contains(action->text, arity)) {
      continue;
    }
    checking.warn(file, action->span,
                  fmt::format("'{}' has {}, not {}", action->text, counted(*known), arity),
                  known->summary);
  }
}

}  // namespace

void wrong_arities(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    goals(checking, file);
    beliefs(checking, file);
    actions(checking, file);
    internal_actions(checking, file);
  }
}

}  // namespace jaywalk
