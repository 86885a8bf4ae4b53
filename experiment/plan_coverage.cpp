#include "experiment/plan_coverage.h"

namespace jaywalk {

void add_programs(const PreparedScenario& prepared, Probes& probes) {
  const auto add = [&](const std::vector<PreparedBehaviour>& behaviours) {
    for (const PreparedBehaviour& behaviour : behaviours) {
      probes.add(behaviour.program);
      for (const auto& [number, program] : behaviour.team) probes.add(program);
    }
  };
  add(prepared.behaviours());
  add(prepared.actors());
}

PlanCoverage::PlanCoverage(const PreparedScenario& prepared)
    : prepared_(prepared), probes_(prepared.symbols(), Probes::Detail::counts) {
  add_programs(prepared, probes_);
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
