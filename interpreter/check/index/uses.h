// SPDX-License-Identifier: Apache-2.0
#pragma once

// A file's uses of names, by their roles; the checks go through these lists instead of walking the
// syntax tree themselves.

#include <cstdint>
#include <set>
#include <span>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "interpreter/syntax/ast.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// A rule or fact, as `head :- body`; the body of a fact is null.
struct Clause {
  const ast::Node* head = nullptr;
  const ast::Node* body = nullptr;
};

/// A formula that decides something.
struct Condition {
  enum class Role : std::uint8_t { context, rule, statement, formula };

  const ast::Node* node = nullptr;
  Role role = Role::formula;
};

struct Uses {
  /// Goals that are posted, `!g` and `!!g`, initial ones too: literals or variables.
  std::vector<const ast::Node*> goals;
  /// Literals in queries that a belief, rule, percept or plan +?t has to answer.
  std::vector<const ast::Node*> queries;
  /// Literals that stand as formulas in bodies.
  std::vector<const ast::Node*> actions;
  /// Internal actions and functions, wherever they occur but in programs as terms.
  std::vector<const ast::Node*> internal_actions;
  /// Contexts, bodies of rules, conditions of if and for (not of while, which may be `true`), tests
  /// and relations in bodies, queries that are arguments (`.findall`).
  std::vector<Condition> conditions;
  /// Plans of the outermost level and of blocks, and their sub-plans.
  std::vector<const ast::Plan*> plans;
  /// Lists of plans one behind another, of one file, block or set of sub-plans.
  std::vector<std::vector<const ast::Plan*>> plan_lists;
  std::vector<Clause> clauses;
};

[[nodiscard]] Uses uses_in(std::span<const ast::Component> components);

/// Whether the plan is for one goal that is posted, `+!g`.
[[nodiscard]] bool is_for_goal(const ast::Plan& plan);

/// The performatives of messages that the plans handle, `+!kqml_received(_, tell, _, _)`.
[[nodiscard]] std::set<std::string_view> handled_performatives(const Uses& uses);

/// The argument of an internal action that is a query, or null.
[[nodiscard]] const ast::Node* query_argument(const ast::Node& action);

/// The names that a program mentions outside of definitions: it may post, ask for or tell them,
/// even indirectly (by a term in a variable, or a text that becomes a plan). REQUIRES: the program
/// lives as long, whose texts these are.
struct Mentions {
  /// Functors anywhere but of the triggers of plans and the heads of rules, and all words within
  /// strings that may be names.
  std::unordered_set<std::string_view> names;
};

[[nodiscard]] Mentions mentions_in(const SourceTree& program);

/// Whether anything in a program shows that there are other agents: messages, names, sources.
[[nodiscard]] bool shows_other_agents(const SourceTree& program);

}  // namespace jaywalk
