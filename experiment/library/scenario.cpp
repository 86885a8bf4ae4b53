// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/compare/carry_over.h"
#include "experiment/library/library.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/diagnostics.h"
#include <jaywalk/scenario.h>

namespace jaywalk {

struct RunnableScenario::Parts {
  std::shared_ptr<const PreparedScenario> prepared;
  ScenarioOptions options;
  JudgingRules rules;
  Diagnostics warnings;
};

namespace {

ScenarioOptions chosen_options(const ScenarioChoice& choice) {
  ScenarioOptions options{.preset = choice.preset,
                          .sets = choice.sets,
                          .given_by = {},
                          .behaviours = choice.behaviours,
                          .files = readable_files(choice.data_folder, choice.folders),
                          .include = {choice.folders.included, choice.folders.mapped}};
  if (!choice.policies.empty()) {
    options.sets.push_back("policy=" + nlohmann::json(choice.policies).dump());
  }
  return options;
}

/// The scenario's AV is replaced.
Diagnostics put_in(std::shared_ptr<const OwnVehicle> vehicle, Scenario& scenario) {
  Diagnostics found;
  if (!vehicle->make) found.error(vehicle->name, "nothing makes a driver");
  if (!scenario.world->simulator().name.empty()) {
    found.error(scenario.name, "a simulator moves the AV of this scenario");
  }
  if (scenario.world->carries_over()) {
    found.error("world.av.carry_over",
                "only an AV that keeps a speed of whole cells per tick can carry cells over");
  }
  if (found.has_errors()) return found;
  VehicleParameters parameters = scenario.world->vehicle();
  parameters.model = "external";
  parameters.own = std::move(vehicle);
  scenario.world = scenario.world->with(std::move(parameters), scenario.world->simulator());
  return found;
}

Diagnostics no_such_test(const std::string& scenario, std::string why, std::string hint = {}) {
  Diagnostics diagnostics;
  diagnostics.error(scenario, std::move(why), std::move(hint));
  return diagnostics;
}

}  // namespace

SourceFiles readable_files(const std::string& data_folder, const ProgramFolders& folders) {
  SourceFiles files;
  if (!data_folder.empty()) {
    files = SourceFiles(data_folder + "/agents", data_folder + "/scenarios/assertions");
  }
  for (const std::string& folder : folders.readable) files.allow_reading(folder);
  return files;
}

Result<RunnableScenario> RunnableScenario::made(Result<Scenario> scenario, ScenarioOptions options,
                                                std::shared_ptr<const OwnVehicle> vehicle) {
  if (!scenario) return std::move(scenario.diagnostics());
  if (vehicle) {
    if (Diagnostics found = put_in(std::move(vehicle), scenario.value()); found.has_errors()) {
      return found;
    }
  }
  const auto parts = std::make_shared<Parts>();
  parts->options = std::move(options);
  parts->warnings = scenario.value().warnings;
  auto prepared = PreparedScenario::prepare(std::move(scenario).value(), parts->warnings);
  if (!prepared) return std::move(prepared.diagnostics());
  parts->prepared = std::move(prepared).value();
  Criteria criteria;
  criteria.assertions = parts->prepared->scenario().assertions;
  parts->rules = JudgingRules(std::make_shared<const Criteria>(std::move(criteria)));
  return RunnableScenario(parts);
}

Result<RunnableScenario> RunnableScenario::read(const std::string& path,
                                                const ScenarioChoice& choice) {
  ScenarioOptions options = chosen_options(choice);
  return made(read_scenario(path, options), options, choice.vehicle);
}

Result<RunnableScenario> RunnableScenario::parse(const std::string& name, std::string text,
                                                 const ScenarioChoice& choice) {
  ScenarioOptions options = chosen_options(choice);
  const auto source = std::make_shared<const Source>(name, std::move(text));
  return made(parse_scenario(source, options), options, choice.vehicle);
}

const std::string& RunnableScenario::name() const { return prepared()->scenario().name; }
std::string_view RunnableScenario::world() const { return prepared()->scenario().world->kind(); }
std::vector<std::string> RunnableScenario::vehicles() const { return prepared()->vehicles(); }
std::uint64_t RunnableScenario::tests() const { return prepared()->scenario().experiment.tests; }
std::uint64_t RunnableScenario::seed() const { return prepared()->scenario().experiment.seed; }
const JudgingRules& RunnableScenario::rules() const { return parts_->rules; }
const Diagnostics& RunnableScenario::warnings() const { return parts_->warnings; }
const ScenarioOptions& RunnableScenario::options() const { return parts_->options; }

std::vector<std::string> RunnableScenario::behaviours() const {
  std::vector<std::string> names;
  for (const PreparedBehaviour& behaviour : prepared()->behaviours()) {
    names.push_back(behaviour.name);
  }
  return names;
}

std::vector<std::uint32_t> RunnableScenario::agents() const {
  return prepared()->scenario().experiment.agents;
}

const std::shared_ptr<const PreparedScenario>& RunnableScenario::prepared() const {
  return parts_->prepared;
}

Result<TestReport> RunnableScenario::run(const TestChoice& choice) const {
  return run(choice, rules());
}

Result<TestSetup> setup_of(const RunnableScenario& scenario, const TestChoice& choice) {
  const PreparedScenario& prepared = *scenario.prepared();
  const auto& all = prepared.behaviours();
  const auto behaviour = choice.behaviour.empty()
                             ? all.begin()
                             : std::ranges::find(all, choice.behaviour, &PreparedBehaviour::name);
  if (behaviour == all.end()) {
    return no_such_test(scenario.name(),
                        fmt::format("there is no behaviour '{}'", choice.behaviour),
                        did_you_mean(choice.behaviour, scenario.behaviours()));
  }
  const TestSetup setup{.behaviour = static_cast<std::size_t>(behaviour - all.begin()),
                        .agents = choice.agents,
                        .seed = choice.seed.value_or(scenario.seed()),
                        .test = choice.test};
  if (choice.test >= kMaxTests) {
    return no_such_test(scenario.name(), fmt::format("test: expected 0 to {}, found {}",
                                                     kMaxTests - 1, choice.test));
  }
  if (std::string why = problem(prepared, setup); !why.empty()) {
    return no_such_test(scenario.name(), std::move(why));
  }
  auto chained = in_its_chain(prepared, setup, [&] {
    return choice.interrupted && choice.interrupted() ? Proceed::no : Proceed::yes;
  });
  if (!chained) return no_such_test(scenario.name(), "the test was interrupted");
  return *std::move(chained);
}

Result<TestReport> RunnableScenario::run(const TestChoice& choice,
                                         const JudgingRules& rules) const {
  const auto setup = setup_of(*this, choice);
  if (!setup) return setup.diagnostics();
  Recording recording;
  const TestRun run =
      run_test(*prepared(), setup.value(),
               {.record = &recording, .print = choice.print, .interrupted = choice.interrupted});
  if (run.interrupted) return no_such_test(name(), "the test was interrupted");
  const Criteria none;
  TestReport report = report_of(recording, run.completed ? rules.criteria() : none,
                                prepared()->scenario().world->ground());
  const TestOutcome outcome = outcome_of(run);
  report.error = run.completed ? std::string() : run.message;
  report.succeeded = run.completed && run.outcome.success;
  report.ended_by = outcome.ended_by;
  report.ticks = outcome.ticks;
  report.impact_mps = outcome.impact_mps;
  if (run.completed) report.score = run.outcome.score();
  return report;
}

}  // namespace jaywalk
