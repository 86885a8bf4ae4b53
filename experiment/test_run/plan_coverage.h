// SPDX-License-Identifier: Apache-2.0
#pragma once

// Plan coverage of an experiment's tests. Tests may run on any threads and in any order: each
// borrows an observer, and what observers have counted is summed up at the end.
//
//   PlanCoverage coverage(*prepared, {{behaviour, agents}});
//   {
//     const PlanCoverage::Borrowed observer(coverage);
//     run_test(*prepared, input, {.observer = observer.get()});
//   }
//   coverage_text(coverage.total());

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "experiment/test_run/prepared_scenario.h"
#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {

/// Which behaviours run, by their index, and with how many agents at most.
using BehavioursRun = std::map<std::size_t, std::uint32_t>;
[[nodiscard]] BehavioursRun all_behaviours(const PreparedScenario& prepared, std::uint32_t agents);

class PlanCoverage {
 public:
  /// Covers the programs that the agents of these behaviours and the actors load; what belongs to
  /// other behaviours alone is not counted as missing. `prepared` must outlive it.
  PlanCoverage(const PreparedScenario& prepared, const BehavioursRun& behaviours);

  class Borrowed {
   public:
    explicit Borrowed(PlanCoverage& owner) : owner_(owner), observer_(owner.lend()) {}
    ~Borrowed() { owner_.take_back(std::move(observer_)); }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    [[nodiscard]] CoverageObserver* get() const { return observer_.get(); }

   private:
    PlanCoverage& owner_;
    std::unique_ptr<CoverageObserver> observer_;
  };

  /// REQUIRES: no observer is borrowed.
  [[nodiscard]] SourceCoverage total() const;

 private:
  std::unique_ptr<CoverageObserver> lend();
  void take_back(std::unique_ptr<CoverageObserver> observer);

  const PreparedScenario& prepared_;
  Probes probes_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<CoverageObserver>> idle_;
};

/// Adds the programs that the agents of these behaviours and the actors load.
void add_programs(const PreparedScenario& prepared, const BehavioursRun& behaviours,
                  Probes& probes);

}  // namespace jaywalk
