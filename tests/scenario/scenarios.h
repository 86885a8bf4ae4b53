// SPDX-License-Identifier: Apache-2.0
#pragma once

// The project's own scenarios, prepared for tests.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "env/crossing/world.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/test_run/prepared_scenario.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/source_files.h"

namespace jaywalk::testing_scenario {

/// A file of the project, by its path from the project's folder.
[[nodiscard]] std::string project_file(const std::string& path);

/// The disk, with the project's agents as the installed ones.
[[nodiscard]] SourceFiles installed_files();

/// scenarios/<name>.yaml with other values for keys; a test that asks for more than there is fails.
[[nodiscard]] std::shared_ptr<const PreparedScenario> scenario(const std::string& name,
                                                               std::vector<std::string> sets = {});

/// scenarios/paper.yaml with settings; a test that asks for more than there is fails.
[[nodiscard]] std::shared_ptr<const PreparedScenario> paper(const ScenarioOptions& options = {});

/// Like paper(), with start cells instead of chance, for test 0.
[[nodiscard]] std::shared_ptr<const PreparedScenario> paper_from(
    const std::vector<Position>& start, std::vector<std::string> sets = {});

/// The index of a behaviour by its name.
[[nodiscard]] std::size_t behaviour(const PreparedScenario& prepared, const std::string& name);

/// Gives start cells to a scenario of the crossing.
void start_from(Scenario& scenario, StartCells cells);

/// Keeps the result of a test of the crossing. `result` must outlive the test.
[[nodiscard]] TestObserver observing(CrossingResult& result);

/// Runs a test that must come to its end.
[[nodiscard]] CrossingResult outcome(const PreparedScenario& prepared, const std::string& name,
                                     std::uint32_t agents, std::uint64_t test = 0);

struct Seen {
  CrossingResult outcome;
  Recording recording;
};
/// Runs a test with any seed and returns its observable parts.
[[nodiscard]] Seen run(const PreparedScenario& prepared, const std::string& name,
                       std::uint32_t agents, std::uint64_t test, std::uint64_t seed = 0);

/// In how many of `tests` tests a behaviour's pedestrians have led to each verdict.
[[nodiscard]] VerdictCounts verdicts(const PreparedScenario& prepared, const std::string& name,
                                     std::string_view assertion, std::uint64_t tests,
                                     std::uint32_t agents = 1);

}  // namespace jaywalk::testing_scenario
