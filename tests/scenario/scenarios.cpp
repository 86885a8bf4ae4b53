// SPDX-License-Identifier: Apache-2.0
#include "scenarios.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace jaywalk::testing_scenario {

void start_from(Scenario& scenario, StartCells cells) {
  scenario.world = std::make_shared<CrossingSpec>(
      crossing_parameters(*scenario.world), std::make_shared<const StartCells>(std::move(cells)));
}

namespace {

std::shared_ptr<const PreparedScenario> prepare(Result<Scenario> scenario,
                                                const std::vector<Position>& start) {
  if (!scenario.ok()) {
    ADD_FAILURE() << scenario.diagnostics().render();
    return nullptr;
  }
  if (!start.empty()) start_from(scenario.value(), StartCells{{0, start}});
  Diagnostics warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
  EXPECT_TRUE(warnings.empty()) << warnings.render();
  if (!prepared.ok()) {
    ADD_FAILURE() << prepared.diagnostics().render();
    return nullptr;
  }
  return prepared.value();
}

}  // namespace

std::string project_file(const std::string& path) {
  return std::string(JAYWALK_SOURCE_DIR) + "/" + path;
}

SourceFiles installed_files() { return SourceFiles(project_file("agents")); }

std::shared_ptr<const PreparedScenario> scenario(const std::string& name,
                                                 std::vector<std::string> sets) {
  return prepare(
      read_scenario(
          project_file("scenarios/" + name + ".yaml"),
          {.preset = {}, .sets = std::move(sets), .behaviours = {}, .files = installed_files()}),
      {});
}

std::shared_ptr<const PreparedScenario> paper(const ScenarioOptions& options) {
  return prepare(read_scenario(project_file("scenarios/paper.yaml"), options), {});
}

std::shared_ptr<const PreparedScenario> paper_from(const std::vector<Position>& start,
                                                   std::vector<std::string> sets) {
  ScenarioOptions options;
  options.sets = std::move(sets);
  return prepare(read_scenario(project_file("scenarios/paper.yaml"), options), start);
}

std::size_t behaviour(const PreparedScenario& prepared, const std::string& name) {
  for (std::size_t i = 0; i < prepared.behaviours().size(); ++i) {
    if (prepared.behaviours()[i].name == name) return i;
  }
  ADD_FAILURE() << "no behaviour " << name;
  return 0;
}

TestObserver observing(CrossingResult& result) {
  return [&result](const World& world, const Mas&) { result = find_crossing(world)->result(); };
}

CrossingResult outcome(const PreparedScenario& prepared, const std::string& name,
                       std::uint32_t agents, std::uint64_t test) {
  TestOptions options;
  std::string log;
  options.log = [&](std::string_view line) { (log += line) += '\n'; };
  CrossingResult seen;
  options.observe = observing(seen);
  const TestRun result = run_test(prepared,
                                  {.behaviour = behaviour(prepared, name),
                                   .agents = agents,
                                   .seed = prepared.scenario().experiment.seed,
                                   .test = test},
                                  options);
  EXPECT_TRUE(result.completed) << result.message;
  EXPECT_EQ(log, "");
  return seen;
}

Seen run(const PreparedScenario& prepared, const std::string& name, std::uint32_t agents,
         std::uint64_t test, std::uint64_t seed) {
  Seen seen;
  const TestRun result = run_test(
      prepared,
      {.behaviour = behaviour(prepared, name), .agents = agents, .seed = seed, .test = test},
      {.observe = observing(seen.outcome), .record = &seen.recording});
  EXPECT_TRUE(result.completed) << result.message;
  return seen;
}

VerdictCounts verdicts(const PreparedScenario& prepared, const std::string& name,
                       std::string_view assertion, std::uint64_t tests, std::uint32_t agents) {
  const auto& assertions = prepared.scenario().assertions;
  const auto judged = std::ranges::find(assertions, assertion, &Assertion::id);
  const Ground on = prepared.scenario().world->ground();
  VerdictCounts counts;
  for (std::uint64_t test = 0; test < tests; ++test) {
    const Recording recording = run(prepared, name, agents, test).recording;
    ++counts.tests[static_cast<std::size_t>(judge(*judged, TestView(recording, on)).verdict)];
  }
  return counts;
}

}  // namespace jaywalk::testing_scenario
