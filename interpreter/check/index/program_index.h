// SPDX-License-Identifier: Apache-2.0
#pragma once

// The names that all files of a program together define, post and believe; the checker (check.h)
// compares the uses with them. Namespaces and strong negation are ignored: a name that is known in
// one of them is known.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/check/index/uses.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

/// Names with the numbers of arguments that they occur with.
class NameSet {
 public:
  void add(std::string_view name, int arity);
  void add_any_arity(std::string_view name) { add(name, kAnyArity); }
  [[nodiscard]] bool contains(std::string_view name, int arity) const;
  /// Empty if the name is unknown.
  [[nodiscard]] std::set<int> arities(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  static constexpr int kAnyArity = -1;

  std::map<std::string, std::set<int>, std::less<>> arities_;
};

struct ProgramIndex {
  /// Goals that have a plan, `+!g` or at least `-!g`.
  NameSet planned_goals;
  /// Goals that have a plan `+!g`.
  NameSet achievable_goals;
  /// Test goals that have a plan.
  NameSet planned_tests;
  /// Goals that are posted anywhere, sent to other agents or written as a trigger or body term.
  NameSet posted_goals;
  /// Beliefs and heads of rules, initial or added; beliefs that are sent or that a plan reacts to.
  NameSet beliefs;
  /// The names in `beliefs` that are not only heads of rules.
  NameSet facts;
  /// Beliefs that the program gives itself or others, rules too: not those to which it only reacts.
  NameSet given;
  /// Functions and internal actions that the program registers.
  NameSet functions;
  /// Whether there is a plan for any goal, `+!G`, or plans come from where the checker cannot look.
  bool has_open_goals = false;
  /// Whether beliefs are added whose names are not written in the program.
  bool has_open_beliefs = false;
  /// Whether parts of the program are missing, or loaded while it runs: they may define any name.
  bool has_unread_parts = false;
  bool sends_messages = false;
};

[[nodiscard]] ProgramIndex index_of(const SourceTree& program);

/// The index and, for each of the program's files in their order, the uses of names.
/// REQUIRES: the program lives as long.
struct ProgramWords {
  ProgramIndex index;
  std::vector<Uses> uses;
};

[[nodiscard]] ProgramWords words_of(const SourceTree& program);

/// The number of arguments of a literal.
[[nodiscard]] int arity_of(const ast::Node& literal);

/// How comments for the checker write a belief and a goal: `radius/1`, `!cross/0`.
[[nodiscard]] std::string belief_name(const ast::Node& literal);
[[nodiscard]] std::string goal_name(const ast::Node& literal);

}  // namespace jaywalk
