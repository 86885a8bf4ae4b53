// SPDX-License-Identifier: Apache-2.0
#pragma once

// Probes observe a program as it runs: its plans, the conditions in contexts and rules, the
// formulas of bodies, each with a number. Contexts and rules are compiled again with goals around
// every condition that report to the observer (agent/surroundings/observer.h) that it is asked and
// that it holds; their meaning does not change. The programs themselves are left as they are.
//
//   Probes probes(symbols, Probes::Detail::counts);
//   probes.add(program);
//   CoverageObserver observer(probes);      // one for each thread
//   MasOptions{.observer = &observer};

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/program/program.h"
#include "interpreter/support/containers/flat_index.h"

namespace jaywalk {

/// A condition, which is no conjunction, disjunction or negation itself.
struct ProbedCondition {
  /// The numbers of its variables among the slots of the plan or rule.
  std::vector<std::uint32_t> slots;
  /// The names of all slots of the plan or rule.
  std::span<const Symbol> slot_names;
  /// How many `not` stand right before it, with nothing else between.
  std::uint32_t nots = 0;
  /// Whether the condition with its `nots` stands within an odd number of further negations, so
  /// that the formula needs it to fail.
  bool negated = false;
  /// The predicate that it queries; empty if it is not a literal.
  std::optional<Predicate> asks;
};

struct ProbedPlan {
  const Plan* plan = nullptr;
  /// Null: it has no context.
  const Goal* context = nullptr;
  std::size_t first_condition = 0;
  std::size_t conditions = 0;
  std::size_t first_formula = 0;
  std::size_t formulas = 0;
  /// The plans of another program begin here.
  bool first_plan_of_program = false;
};

struct ProbedRule {
  const RuleCode* rule = nullptr;
  std::unique_ptr<RuleCode> probed;
  Predicate predicate{};
  SourceSpan where;
  std::size_t first_condition = 0;
  std::size_t conditions = 0;
};

class Probes {
 public:
  enum class Detail {
    counts,    // the observer learns which condition
    bindings,  // and what its variables are bound to
  };

  /// `symbols` is the table into which the programs were compiled.
  Probes(const std::shared_ptr<const SymbolTable>& symbols, Detail detail);
  Probes(const Probes&) = delete;
  Probes& operator=(const Probes&) = delete;
  ~Probes();

  /// Adds a program; nothing happens if it is known. The plans that every agent has, for messages,
  /// are left out. REQUIRES: no run that uses these probes is under way on another thread.
  void add(const std::shared_ptr<const Program>& program);

  [[nodiscard]] const std::vector<ProbedPlan>& plans() const { return plans_; }
  [[nodiscard]] const std::vector<ProbedRule>& rules() const { return rules_; }
  [[nodiscard]] const std::vector<ProbedCondition>& conditions() const { return conditions_; }
  [[nodiscard]] const std::vector<const Step*>& formulas() const { return formulas_; }

  /// Indices; kNone for plans made at run time and for those that are no part of the programs.
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  [[nodiscard]] std::size_t find(const Plan& plan) const { return look_up(plan_index_, &plan); }
  [[nodiscard]] std::size_t find(const RuleCode& rule) const { return look_up(rule_index_, &rule); }
  [[nodiscard]] std::size_t find(const Step& step) const { return look_up(step_index_, &step); }

 private:
  class Rewriter;
  static std::uint64_t key(const void* of) { return reinterpret_cast<std::uintptr_t>(of); }
  static std::size_t look_up(const FlatIndex<std::uint64_t>& index, const void* of) {
    const std::uint32_t found = index.find(key(of));
    return found == FlatIndex<std::uint64_t>::kNone ? kNone : found;
  }
  void add_plan(const Plan& plan, const ActionRegistry& actions);
  void add_rule(const Program::Belief& belief, const ActionRegistry& actions);
  void add_formulas(const Body& body);
  const ActionRegistry& with_probes(const ActionRegistry& actions);

  SymbolTable symbols_;  // the probes' own names, above those of the programs
  Detail detail_;
  Heap heap_;
  std::vector<std::shared_ptr<const Program>> programs_;
  std::unordered_map<const ActionRegistry*, ActionRegistry> registries_;
  std::vector<std::unique_ptr<FormulaCode>> contexts_;
  std::vector<ProbedPlan> plans_;
  std::vector<ProbedRule> rules_;
  std::vector<ProbedCondition> conditions_;
  std::vector<const Step*> formulas_;
  // The numbers of probes, by the address of the plan, condition or formula.
  FlatIndex<std::uint64_t> plan_index_;
  FlatIndex<std::uint64_t> rule_index_;
  FlatIndex<std::uint64_t> step_index_;
};

}  // namespace jaywalk
