// SPDX-License-Identifier: Apache-2.0
// Habits from other languages: a result as a value, a query as an action, an atom for a variable, a
// variable for a name; also unknown performatives.

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/actions/table/action_traits.h"
#include "interpreter/check/checking.h"
#include "interpreter/check/index/traversal.h"
#include "interpreter/support/text.h"
#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/printer.h"

namespace jaywalk {
namespace {

using ast::Kind;
using ast::Node;
using ast::Operator;

bool is_lower_case_atom(const Node& node) {
  return node.kind == Kind::literal && node.args.empty() && node.annots == nullptr &&
         node.ns == nullptr && !node.negated && !ast::is_internal(node) &&
         is_lower(node.text.front());
}

// --- Results ---------------------------------------------------------------------------------

// `.concat([1],[2],L)` for `L = .concat([1],[2])`.
std::string with_result(const Node& action, const Node& variable) {
  std::string text = print(action);
  if (text.ends_with(')')) {
    text.pop_back();
    return fmt::format("{},{})", text, variable.text);
  }
  return fmt::format("{}({})", text, variable.text);
}

bool may_have_result(const Vocabulary& vocabulary, const Node& action) {
  const std::string_view name = short_name(action.text);
  bool has_result = false;
  for (const Vocabulary::Entry& entry : vocabulary.internal_actions) {
    if (entry.name != name) continue;
    if (entry.is_function && takes(entry, arity_of(action))) return false;
    has_result = has_result || takes(entry, arity_of(action) + 1);
  }
  return has_result;
}

void result_as_value(Checking& checking, CheckedFile& file, const Node& relation,
                     const std::set<std::string_view>& carried_out) {
  const Node* variable = relation.args[0];
  const Node* action = relation.args[1];
  if (action->kind == Kind::variable) std::swap(variable, action);
  const bool applies = relation.op == Operator::unify && variable->kind == Kind::variable &&
                       action->kind == Kind::literal && ast::is_internal(*action) &&
                       !carried_out.contains(variable->text);
  if (!applies || !checking.index().functions.arities(action->text).empty() ||
      !may_have_result(checking.vocabulary(), *action)) {
    return;
  }
  checking.warn(file, action->span,
                fmt::format("'{}' is no function: '{}' would be the call, not its result",
                            action->text, variable->text),
                fmt::format("write {}", with_result(*action, *variable)));
}

// --- Performatives ---------------------------------------------------------------------------

std::string letters_of(std::string_view word) {
  std::string letters;
  for (const char c : word) {
    if (is_letter(c)) letters += is_upper(c) ? static_cast<char>(c + ('a' - 'A')) : c;
  }
  return letters;
}

std::string_view performative_meant(std::string_view written,
                                    const std::vector<std::string>& known) {
  for (const std::string& each : known) {
    if (each == written) return {};
  }
  const std::string letters = letters_of(written);
  for (const std::string& each : known) {
    if (is_one_slip(written, each) || letters == letters_of(each)) return each;
  }
  return {};
}

// --- Goals that no plan matches --------------------------------------------------------------

// Whether the two can be equal, whatever their variables are.
bool may_match(const Node& a, const Node& b) {
  if (a.kind == Kind::number && b.kind == Kind::number) return a.number == b.number;
  if (a.kind == Kind::string && b.kind == Kind::string) return a.text == b.text;
  const auto is_simple = [](const Node& node) {
    return node.kind == Kind::number || node.kind == Kind::string || is_lower_case_atom(node);
  };
  if (is_simple(a) && is_simple(b) && a.kind != b.kind) return false;
  return !is_lower_case_atom(a) || !is_lower_case_atom(b) || a.text == b.text;
}

bool may_match_all(const Node& a, const Node& b) {
  return std::ranges::equal(a.args, b.args,
                            [](const Node* x, const Node* y) { return may_match(*x, *y); });
}

std::string capitalised(std::string_view word) {
  std::string name(word);
  if (is_lower(name.front())) name.front() = static_cast<char>(name.front() - ('a' - 'A'));
  return name;
}

// An atom of the trigger that the plan uses again, as one uses a variable.
std::string_view atom_for_variable(const ast::Plan& plan) {
  for (const Node* argument : plan.trigger.literal->args) {
    if (!is_lower_case_atom(*argument)) continue;
    int times = 0;
    each_node(plan, [&](const Node& node) {
      times += static_cast<int>(std::ranges::count_if(node.args, [&](const Node* other) {
        return is_lower_case_atom(*other) && other->text == argument->text;
      }));
    });
    if (times > 1) return argument->text;
  }
  return {};
}

using GoalKey = std::pair<std::string_view, std::size_t>;
using Plans = std::map<GoalKey, std::vector<const ast::Plan*>>;

Plans plans_for_goals(Checking& checking) {
  Plans plans;
  for (const CheckedFile& file : checking.files()) {
    for (const ast::Plan* plan : file.uses.plans) {
      const Node& literal = *plan->trigger.literal;
      if (is_for_goal(*plan)) plans[{literal.text, literal.args.size()}].push_back(plan);
    }
  }
  return plans;
}

// --- Atoms for variables ---------------------------------------------------------------------

using AtomTimes = std::unordered_map<std::string_view, int>;

// Adds how often each atom stands as an argument in a term, formula or plan.
template <class Tree>
void count_arguments(const Tree& tree, AtomTimes& times) {
  each_node(tree, [&](const Node& each) {
    for (const Node* argument : each.args) {
      if (is_lower_case_atom(*argument)) ++times[argument->text];
    }
  });
}

void count_arguments(std::span<const ast::Component> components, AtomTimes& times) {
  for (const ast::Component& component : components) {
    if (component.literal != nullptr) count_arguments(*component.literal, times);
    if (component.body != nullptr) count_arguments(*component.body, times);
    if (component.plan != nullptr) count_arguments(*component.plan, times);
    count_arguments(component.inner, times);
  }
}

/// Facts by name and arity; the arguments of facts that the program adds while it runs are unknown.
class Facts {
 public:
  explicit Facts(Checking& checking) {
    for (const CheckedFile& file : checking.files()) {
      for (const Clause& clause : file.uses.clauses) {
        facts_[{clause.head->text, clause.head->args.size()}].push_back(clause.head);
      }
      for (const ast::Plan* plan : file.uses.plans) {
        each_formula(plan->body, [this](const ast::Formula& formula) {
          if (formula.op > ast::BodyOperator::test) changed_.insert(formula.node->text);
        });
      }
    }
  }

  /// There are such beliefs, and in all of them stands a constant where the query has the atom.
  [[nodiscard]] bool never_have(const Node& query, std::size_t index) const {
    const auto found = facts_.find({query.text, query.args.size()});
    if (found == facts_.end() || changed_.contains(query.text)) return false;
    return std::ranges::none_of(found->second, [&](const Node* fact) {
      return may_match(*fact->args[index], *query.args[index]);
    });
  }

 private:
  std::map<GoalKey, std::vector<const Node*>> facts_;
  std::set<std::string_view> changed_;
};

// A query has an atom that no belief has there, and that stands elsewhere in the clause alone, as
// one writes a variable.
void look_at_query(Checking& checking, CheckedFile& file, const Node& query,
                   const Lazy<Facts>& facts, const AtomTimes& here, const Lazy<AtomTimes>& all) {
  for (std::size_t i = 0; i < query.args.size(); ++i) {
    const Node& argument = *query.args[i];
    if (!is_lower_case_atom(argument)) continue;
    const auto times = here.find(argument.text);
    const bool only_here = times != here.end() && times->second > 1 &&
                           all->find(argument.text)->second == times->second;
    if (!only_here || !facts->never_have(query, i)) continue;
    checking.warn(
        file, argument.span,
        fmt::format("'{}' is an atom, which no '{}' has there", argument.text, query.text),
        fmt::format("variables begin with a capital: '{}'", capitalised(argument.text)));
  }
}

// --- Goals that are variables ----------------------------------------------------------------

// `walk` for `Walk`.
std::string in_small_letters(std::string_view variable) {
  std::string name(variable);
  if (is_upper(name.front())) name.front() = static_cast<char>(name.front() + ('a' - 'A'));
  return name;
}

void look_at_goal_variables(Checking& checking, CheckedFile& file, const ast::Plan& plan) {
  std::map<std::string_view, int> times;
  each_node(plan, [&](const Node& node) {
    if (node.kind == Kind::variable) ++times[node.text];
  });
  const ProgramIndex& index = checking.index();
  const Node& trigger = *plan.trigger.literal;
  if (trigger.kind == Kind::variable && plan.trigger.kind == ast::TriggerKind::achieve &&
      times[trigger.text] == 1) {
    const std::string name = in_small_letters(trigger.text);
    if (!index.posted_goals.arities(name).empty() && index.planned_goals.arities(name).empty()) {
      checking.warn(file, trigger.span,
                    fmt::format("'{}' is a variable: this plan is for any goal", trigger.text),
                    fmt::format("did you mean '{}'?", name));
    }
  }
  each_formula(plan.body, [&](const ast::Formula& formula) {
    const Node& goal = *formula.node;
    const bool posts = formula.op == ast::BodyOperator::achieve ||
                       formula.op == ast::BodyOperator::achieve_new_focus;
    if (!posts || goal.kind != Kind::variable || times[goal.text] > 1) return;
    checking.warn(
        file, goal.span, fmt::format("'{}' is a variable without a value, and no goal", goal.text),
        fmt::format("names begin with a lower-case letter: '{}'", in_small_letters(goal.text)));
  });
}

}  // namespace

void atoms_for_variables(Checking& checking) {
  if (checking.index().has_open_beliefs) return;
  const Lazy<Facts> facts([&checking] { return Facts(checking); });
  const Lazy<AtomTimes> all([&checking] {
    AtomTimes times;
    for (const CheckedFile& file : checking.files()) count_arguments(file.file->components, times);
    return times;
  });
  for (CheckedFile& file : checking.files()) {
    for (const Clause& clause : file.uses.clauses) {
      if (clause.body == nullptr) continue;
      AtomTimes here;
      count_arguments(*clause.head, here);
      count_arguments(*clause.body, here);
      each_node(*clause.body,
                [&](const Node& node) { look_at_query(checking, file, node, facts, here, all); });
    }
    for (const ast::Plan* plan : file.uses.plans) {
      if (plan->context == nullptr) continue;
      AtomTimes here;
      count_arguments(*plan, here);
      each_node(*plan->context,
                [&](const Node& node) { look_at_query(checking, file, node, facts, here, all); });
    }
  }
}

void variable_goals(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    std::set<const ast::Plan*> inner;  // whose variables are those of the plan around them
    for (const ast::Plan* plan : file.uses.plans) {
      inner.insert(plan->subplans.begin(), plan->subplans.end());
      if (!inner.contains(plan)) look_at_goal_variables(checking, file, *plan);
    }
  }
}

void results_as_values(Checking& checking) {
  for (CheckedFile& file : checking.files()) {
    std::set<std::string_view> carried_out;
    for (const ast::Plan* plan : file.uses.plans) {
      each_formula(plan->body, [&](const ast::Formula& formula) {
        if (formula.node->kind == Kind::variable) carried_out.insert(formula.node->text);
      });
    }
    for (const Condition& condition : file.uses.conditions) {
      each_node(*condition.node, [&](const Node& node) {
        if (node.kind == Kind::binary) result_as_value(checking, file, node, carried_out);
      });
    }
  }
}

void unknown_performatives(Checking& checking) {
  const std::vector<std::string>& known = checking.vocabulary().performatives;
  if (known.empty()) return;
  std::set<std::string_view> own;
  for (const CheckedFile& file : checking.files()) own.merge(handled_performatives(file.uses));
  for (CheckedFile& file : checking.files()) {
    for (const Node* action : file.uses.internal_actions) {
      const ActionTraits traits = traits_of(action->text);
      const std::size_t at = traits.performative;
      if (traits.about != About::message || action->args.size() < at + 2) continue;
      const Node& performative = *action->args[at];
      if (!is_lower_case_atom(performative) || own.contains(performative.text)) continue;
      const std::string_view meant = performative_meant(performative.text, known);
      if (meant.empty()) continue;
      checking.warn(file, performative.span,
                    fmt::format("agents have no plan for messages '{}'", performative.text),
                    fmt::format("did you mean '{}'?", meant));
    }
  }
}

void missing_questions(Checking& checking) {
  if (checking.vocabulary().environment_known) return;
  const Lazy<std::set<GoalKey>> known([&checking] {
    std::set<GoalKey> heads;
    for (const CheckedFile& file : checking.files()) {
      for (const Clause& clause : file.uses.clauses) {
        heads.insert({clause.head->text, clause.head->args.size()});
      }
    }
    return heads;
  });
  for (CheckedFile& file : checking.files()) {
    for (const Node* action : file.uses.actions) {
      if (!known->contains({action->text, action->args.size()})) continue;
      checking.warn(
          file, action->span,
          fmt::format("'{}' is a belief, but this an action of the environment", action->text),
          fmt::format("to ask for the belief, write '?{}'", print(*action)));
    }
  }
}

void unmatched_goals(Checking& checking) {
  if (checking.may_be_told_plans()) return;
  const Plans plans = plans_for_goals(checking);
  for (CheckedFile& file : checking.files()) {
    for (const Node* goal : file.uses.goals) {
      if (goal->kind != Kind::literal) continue;
      const auto found = plans.find({goal->text, goal->args.size()});
      if (found == plans.end()) continue;
      const bool matched = std::ranges::any_of(found->second, [&](const ast::Plan* plan) {
        return may_match_all(*goal, *plan->trigger.literal);
      });
      if (matched) continue;
      std::string hint;
      for (const ast::Plan* plan : found->second) {
        const std::string_view atom = atom_for_variable(*plan);
        if (atom.empty()) continue;
        hint = fmt::format("'{}' in the plan '{}' is an atom; variables begin with a capital: '{}'",
                           atom, print(plan->trigger), capitalised(atom));
        break;
      }
      checking.warn(file, goal->span,
                    fmt::format("none of the plans for '{}' is for '{}'", goal->text, print(*goal)),
                    std::move(hint));
    }
  }
}

}  // namespace jaywalk
