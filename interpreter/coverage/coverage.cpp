// SPDX-License-Identifier: Apache-2.0
#include "interpreter/coverage/coverage.h"

#include "interpreter/agent/agent.h"

namespace jaywalk {

void CoverageCounts::fit(const Probes& probes) {
  plans.resize(probes.plans().size());
  conditions.resize(probes.conditions().size());
  formulas.resize(probes.formulas().size());
}

void CoverageCounts::add(const CoverageCounts& other) {
  for (std::size_t i = 0; i < other.plans.size(); ++i) {
    plans[i].relevant += other.plans[i].relevant;
    plans[i].applicable += other.plans[i].applicable;
    plans[i].chosen += other.plans[i].chosen;
  }
  for (std::size_t i = 0; i < other.conditions.size(); ++i) {
    conditions[i].asked += other.conditions[i].asked;
    conditions[i].held += other.conditions[i].held;
  }
  for (std::size_t i = 0; i < other.formulas.size(); ++i) {
    formulas[i].executed += other.formulas[i].executed;
    formulas[i].failed += other.formulas[i].failed;
  }
}

CoverageObserver::CoverageObserver(const Probes& probes) : probes_(probes) { fit(); }

// Mostly the same as before: a plan is relevant, is tried, and is chosen.
std::size_t CoverageObserver::index_of(const Plan& plan) {
  if (&plan != known_plan_) {
    known_plan_ = &plan;
    known_index_ = probes_.find(plan);
  }
  return known_index_;
}

void CoverageObserver::fit() {
  known_plan_ = nullptr;
  counts_.fit(probes_);
  latest_held_.resize(counts_.conditions.size());
}

const Goal* CoverageObserver::context_of(const Plan& plan) {
  const std::size_t index = index_of(plan);
  return index == Probes::kNone ? plan.context : probes_.plans()[index].context;
}

const RuleCode& CoverageObserver::rule_for(const RuleCode& rule) {
  const std::size_t index = probes_.find(rule);
  return index == Probes::kNone ? rule : *probes_.rules()[index].probed;
}

std::size_t CoverageObserver::condition_asked(Agent&, std::size_t number, std::span<const Value>) {
  ++counts_.conditions[number].asked;
  latest_held_[number] = false;
  held_.push_back(false);
  return first_asking_ + held_.size() - 1;
}

void CoverageObserver::condition_answered(Agent&, std::size_t number, std::size_t asking) {
  // An asking of a query that a later one has interrupted is no longer known.
  if (asking != 0 && asking < first_asking_) return;
  std::vector<bool>::reference held =
      asking == 0 ? latest_held_[number] : held_[asking - first_asking_];
  if (!held) ++counts_.conditions[number].held;
  held = true;
}

void CoverageObserver::forget_askings() {
  if (held_.empty()) return;
  first_asking_ += held_.size();
  held_.clear();
}

void CoverageObserver::plan_relevant(Agent&, const Plan& plan, const Event&,
                                     std::span<const Value>) {
  forget_askings();
  const std::size_t index = index_of(plan);
  if (index != Probes::kNone) ++counts_.plans[index].relevant;
}

void CoverageObserver::plan_tried(Agent&, const Plan& plan, bool applicable) {
  const std::size_t index = index_of(plan);
  if (index != Probes::kNone && applicable) ++counts_.plans[index].applicable;
}

void CoverageObserver::plan_chosen(Agent&, const Plan& plan, const Event&, const Intention&) {
  const std::size_t index = index_of(plan);
  if (index != Probes::kNone) ++counts_.plans[index].chosen;
}

void CoverageObserver::formula_executes(Agent&, const Intention&, const Step& step) {
  forget_askings();
  const std::size_t index = probes_.find(step);
  if (index != Probes::kNone) ++counts_.formulas[index].executed;
}

void CoverageObserver::formula_failed(Agent&, const Intention& intention, const ActionError&) {
  if (intention.is_finished() || intention.top().is_finished()) return;
  const std::size_t index = probes_.find(intention.top().step());
  if (index != Probes::kNone) ++counts_.formulas[index].failed;
}

}  // namespace jaywalk
