// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tests of the pedestrians' world as a search runs them: a scenario with values that a test input
// sets, what is measured of it, and whether it kills a defect of the AV. Read crossing_space.h
// before.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "env/ground.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/judge/situations/situations.h"
#include "experiment/test_run/prepared_scenario.h"
#include "experiment/test_run/test_run.h"
#include "search/sut.h"
#include "search/suts/crossing_space.h"

namespace jaywalk::search {

struct CrossingSettings {
  SourcePtr scenario;
  /// The parsed scenario, with the settings that are the same in all tests.
  std::shared_ptr<const Scenario> parsed_scenario;
  /// The texts of all files that tests are made from, the scenario's among them; without those of
  /// its programs if no test is run.
  std::vector<SourcePtr> inputs;
  std::string behaviour;
  std::uint32_t agents = 1;
  std::uint64_t seed = 0;
  std::vector<Assertion> assertions;
  /// The metrics of metrics.def are measured, too.
  bool metrics = true;
  /// Like the scenario's key (ExperimentSpec::feedback).
  std::uint64_t feedback = 0;
  /// Files by which the behaviour chooses among its learned plans, in place of the scenario's.
  std::vector<std::string> policies;
  /// The source of programs.
  SourceFiles files;
  /// Each test's limits, which replace the scenario's; in the form of `--set`.
  std::vector<std::string> limits;
  IncludeFolders include;
  /// The defects that the AV is searched with, one after another, and the index of its present one
  /// among the scenario's vehicles (tested_vehicles.h).
  std::vector<VehicleDefect> defects;
  std::size_t vehicle = 0;
};

/// The scenario with the values of an input. All mistakes are reported.
[[nodiscard]] Result<Scenario> scenario_of(const CrossingSettings& settings,
                                           const std::vector<std::string>& sets);

/// Why the behaviour cannot choose by the policy, or why that is none; nothing if it can; empty if
/// nothing of it is learned.
[[nodiscard]] std::optional<std::string> objection_to(const SourcePtr& policy,
                                                      const PreparedScenario& prepared);

/// The measures of a SUT with these settings, in the order of its outcomes.
class CrossingMeasures {
 public:
  explicit CrossingMeasures(const CrossingSettings& settings);
  // The kinds refer to the names.
  CrossingMeasures(const CrossingMeasures&) = delete;
  CrossingMeasures& operator=(const CrossingMeasures&) = delete;

  [[nodiscard]] std::span<const MeasureKind> kinds() const { return kinds_; }

 private:
  std::vector<std::string> names_;
  std::vector<MeasureKind> kinds_;
};

class CrossingRun : public Sut {
 public:
  /// All must outlive it; `measures` are those of the settings.
  CrossingRun(const CrossingSpace& space, const CrossingSettings& settings,
              const CrossingMeasures& measures)
      : space_(space), settings_(settings), measures_(measures) {}

  [[nodiscard]] Outcome run(const TestInput& input, std::size_t test) override;
  void remember(const Outcome& outcome) override;

 private:
  struct Seen;
  [[nodiscard]] std::string prepare(const TestInput& input);
  [[nodiscard]] Seen see(const TestSetup& setup);
  void cover(const SituationBins& bins);
  [[nodiscard]] Outcome measured(const Seen& seen);
  void measure_situations(const Recording& recording, Outcome& outcome);
  [[nodiscard]] std::uint64_t seed(const TestInput& input) const;

  const CrossingSpace& space_;
  const CrossingSettings& settings_;
  const CrossingMeasures& measures_;
  // Kept from the last test: the next one mostly differs in its TestSetup only.
  std::vector<std::string> sets_;
  std::shared_ptr<const PreparedScenario> prepared_;
  std::unique_ptr<TestRunner> runner_;
  Ground ground_;
  /// The situations covered by this search's tests so far.
  SituationCoverage covered_;
  /// The agents' beliefs about that coverage in this generation of tests.
  std::vector<CoveredBin> feedback_;
};

}  // namespace jaywalk::search
