// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/plan_coverage.h"

namespace jaywalk {

BehavioursRun all_behaviours(const PreparedScenario& prepared, std::uint32_t agents) {
  BehavioursRun all;
  for (std::size_t i = 0; i < prepared.behaviours().size(); ++i) all[i] = agents;
  return all;
}

void add_programs(const PreparedScenario& prepared, const BehavioursRun& behaviours,
                  Probes& probes) {
  for (const auto& [index, agents] : behaviours) {
    const PreparedBehaviour& behaviour = prepared.behaviours()[index];
    // The behaviour's own program is for agents that are not in the team.
    std::uint32_t with_own = 0;
    for (const auto& [number, program] : behaviour.team) with_own += number <= agents ? 1 : 0;
    if (with_own < agents) probes.add(behaviour.program);
    for (const auto& [number, program] : behaviour.team) {
      if (number <= agents) probes.add(program);
    }
  }
  for (const PreparedBehaviour& actor : prepared.actors()) probes.add(actor.program);
}

PlanCoverage::PlanCoverage(const PreparedScenario& prepared, const BehavioursRun& behaviours)
    : prepared_(prepared), probes_(prepared.symbols(), Probes::Detail::counts) {
  add_programs(prepared, behaviours, probes_);
}

std::unique_ptr<CoverageObserver> PlanCoverage::lend() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<CoverageObserver>(probes_);
  std::unique_ptr<CoverageObserver> lent = std::move(idle_.back());
  idle_.pop_back();
  return lent;
}

void PlanCoverage::take_back(std::unique_ptr<CoverageObserver> observer) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(observer));
}

SourceCoverage PlanCoverage::total() const {
  CoverageCounts sum;
  sum.fit(probes_);
  for (const auto& observer : idle_) sum.add(observer->counts());
  return locate(probes_, sum, find_texts(probes_, prepared_.inputs()));
}

}  // namespace jaywalk
