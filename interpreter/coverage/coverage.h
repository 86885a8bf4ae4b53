// SPDX-License-Identifier: Apache-2.0
#pragma once

// Plan coverage: how often agents tried, chose and executed what their programs say. Counts are
// sums over runs, so that they depend neither on the order of the runs nor on threads.

#include <cstdint>
#include <vector>

#include "interpreter/agent/surroundings/observer.h"
#include "interpreter/coverage/probes.h"

namespace jaywalk {

struct PlanCounts {
  std::uint64_t relevant = 0;    // its trigger matched an event
  std::uint64_t applicable = 0;  // and its context held
  std::uint64_t chosen = 0;      // and it was intended
};

struct ConditionCounts {
  std::uint64_t asked = 0;
  std::uint64_t held = 0;
};

struct FormulaCounts {
  std::uint64_t executed = 0;
  std::uint64_t failed = 0;
};

/// By the numbers of the probes.
struct CoverageCounts {
  std::vector<PlanCounts> plans;
  std::vector<ConditionCounts> conditions;
  std::vector<FormulaCounts> formulas;

  /// As many as the probes have.
  void fit(const Probes& probes);
  void add(const CoverageCounts& other);
};

/// Counts. One observer serves one run after another, on one thread at a time.
class CoverageObserver : public ReasoningObserver {
 public:
  explicit CoverageObserver(const Probes& probes);

  [[nodiscard]] const CoverageCounts& counts() const { return counts_; }
  /// Call this when programs have been added to the probes.
  void fit();

  [[nodiscard]] bool wants_events() const override { return false; }
  [[nodiscard]] const Goal* context_of(const Plan& plan) override;
  [[nodiscard]] const RuleCode& rule_for(const RuleCode& rule) override;
  std::size_t condition_asked(Agent& agent, std::size_t number,
                              std::span<const Value> variables) override;
  void condition_answered(Agent& agent, std::size_t number, std::size_t asking) override;
  void plan_relevant(Agent& agent, const Plan& plan, const Event& event,
                     std::span<const Value> slots) override;
  void plan_tried(Agent& agent, const Plan& plan, bool applicable) override;
  void plan_chosen(Agent& agent, const Plan& plan, const Event& event,
                   const Intention& intention) override;
  void formula_executes(Agent& agent, const Intention& intention, const Step& step) override;
  void formula_failed(Agent& agent, const Intention& intention, const ActionError& error) override;

 private:
  void forget_askings();
  [[nodiscard]] std::size_t index_of(const Plan& plan);

  const Probes& probes_;
  const Plan* known_plan_ = nullptr;  // the one that was looked for last, and its index
  std::size_t known_index_ = 0;
  CoverageCounts counts_;
  // Askings of the query under way: whether they have held. Those of contexts by the condition's
  // number, those of rules by their own, which go on from query to query.
  std::vector<bool> latest_held_;
  std::vector<bool> held_;
  std::size_t first_asking_ = 1;
};

}  // namespace jaywalk
