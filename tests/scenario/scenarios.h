#pragma once

// The project's own scenarios, prepared for tests.

#include <memory>
#include <string>
#include <vector>

#include "experiment/trial.h"

namespace jaywalk::testing_scenario {

/// A file of the project, by its path from the project's folder.
[[nodiscard]] std::string project_file(const std::string& path);

/// scenarios/paper.yaml with settings; a test that asks for more than there is fails.
[[nodiscard]] std::shared_ptr<const PreparedScenario> paper(const ScenarioOptions& options = {});

/// The same with start cells instead of chance, for test 0.
[[nodiscard]] std::shared_ptr<const PreparedScenario> paper_from(
    const std::vector<Position>& start, std::vector<std::string> sets = {});

/// The index of a behaviour by its name.
[[nodiscard]] std::size_t behaviour(const PreparedScenario& prepared, const std::string& name);

/// Runs a trial that must come to its end.
[[nodiscard]] CrossingResult outcome(const PreparedScenario& prepared, const std::string& name,
                                     std::uint32_t agents, std::uint64_t test = 0);

}  // namespace jaywalk::testing_scenario
