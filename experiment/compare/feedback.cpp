// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/feedback.h"

#include <algorithm>

namespace jaywalk {
CoverageFeedback::CoverageFeedback(const ExperimentPlan& plan, std::uint64_t generation,
                                   const SituationTable& table)
    : plan_(plan), generation_(generation), table_(table) {
  const std::uint64_t generations = (plan.tests + generation - 1) / generation;
  cells_.resize(plan.behaviours.size() * plan.agents.size());
  for (Cell& cell : cells_) {
    cell.missing.assign(generations, generation);
    cell.missing.back() = plan.tests - (generations - 1) * generation;
    cell.covered.emplace_back();
  }
}

CoverageFeedback::Cell& CoverageFeedback::cell_of(const TestKey& test) {
  const auto place = std::ranges::find(plan_.agents, test.agents) - plan_.agents.begin();
  return cells_[test.behaviour * plan_.agents.size() + static_cast<std::size_t>(place)];
}

std::optional<std::vector<CoveredBin>> CoverageFeedback::wait_for(const TestKey& test) {
  const std::uint64_t generation = test.number / generation_;
  std::unique_lock lock(mutex_);
  Cell& cell = cell_of(test);
  changed_.wait(lock, [&] { return given_up_ || cell.complete >= generation; });
  if (given_up_) return std::nullopt;
  return cell.covered[generation];
}

void CoverageFeedback::finished(const TestKey& test) {
  const std::lock_guard lock(mutex_);
  Cell& cell = cell_of(test);
  --cell.missing[test.number / generation_];
  while (cell.complete < cell.missing.size() && cell.missing[cell.complete] == 0) {
    const std::uint64_t first = cell.complete * generation_;
    table_.add_to(cell.coverage, test.behaviour, test.agents, first,
                  std::min(first + generation_, plan_.tests));
    cell.covered.push_back(feedback_of(cell.coverage));
    ++cell.complete;
  }
  changed_.notify_all();
}

void CoverageFeedback::give_up() {
  const std::lock_guard lock(mutex_);
  given_up_ = true;
  changed_.notify_all();
}

}  // namespace jaywalk
