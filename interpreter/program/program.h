// SPDX-License-Identifier: Apache-2.0
#pragma once

// A compiled AgentSpeak program: immutable, shared by every agent that runs it, on any thread.

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/logic/action.h"
#include "interpreter/logic/beliefs/rule_table.h"
#include "interpreter/logic/beliefs/shared_rows.h"
#include "interpreter/program/plan.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

class Program {
 public:
  /// A fact with its annotations, or a rule, in source order.
  struct Belief {
    Value fact;
    const RuleCode* rule = nullptr;
    Predicate predicate{};
    SourceSpan where;
  };
  /// An agent's initial beliefs of one predicate.
  struct Beginning {
    Predicate predicate{};
    /// Null: plans hear of it, so that each agent comes to believe it by itself.
    std::unique_ptr<const SharedRows> rows;
    /// The beliefs, by number, in the order in which they come to be: from the last to the first.
    std::vector<std::uint32_t> beliefs;
  };
  struct Goal {
    Value literal;  // a template; its slots are fresh variables of the goal
    std::uint32_t slot_count = 0;
    std::vector<Symbol> slot_names;
  };
  explicit Program(std::string name) : name_(std::move(name)), constants_(Heap::Owner::program) {}
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<Belief>& beliefs() const { return beliefs_; }
  /// In the order of addition. A predicate that plans hear of may occur several times.
  [[nodiscard]] const std::vector<Beginning>& beginnings() const { return beginnings_; }
  /// The rules of each predicate that has rules alone, if they are few.
  [[nodiscard]] const std::vector<std::pair<Predicate, RuleTable>>& rule_tables() const {
    return rule_tables_;
  }
  [[nodiscard]] const std::vector<Goal>& goals() const { return goals_; }
  [[nodiscard]] const PlanLibrary& library() const { return library_; }
  [[nodiscard]] const std::vector<RuleFunction>& functions() const { return functions_; }
  [[nodiscard]] const ActionRegistry& actions() const { return *actions_; }
  /// It has local namespaces, or one for a variable: an agent that includes it a second time is to
  /// have them a second time.
  [[nodiscard]] bool has_own_namespaces() const { return has_own_namespaces_; }
  /// The text of one of its files, by the name that its plans have (Plan::file); null: none of its.
  [[nodiscard]] SourcePtr find_source(std::string_view file) const;
  /// There are initial goals, and it makes no difference whether an agent starts at once or only
  /// when it first reasons: it makes no variables and cannot fail, since all goals are ground.
  [[nodiscard]] bool can_start_later() const;

 private:
  friend class ProgramBuilder;

  std::string name_;
  Heap constants_;
  const ActionRegistry* actions_ = nullptr;
  std::vector<Belief> beliefs_;
  std::vector<std::unique_ptr<RuleCode>> rules_;
  std::vector<std::pair<Predicate, RuleTable>> rule_tables_;
  std::vector<Beginning> beginnings_;
  std::vector<Goal> goals_;
  PlanLibrary library_;
  std::vector<RuleFunction> functions_;
  std::vector<SourcePtr> sources_;
  bool has_own_namespaces_ = false;
};

}  // namespace jaywalk
