// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/run/trials.h"

#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/config/section_reader.h"
#include "env/vehicle/controller_processes.h"
#include "experiment/test_run/simulator_version.h"
#include "experiment/test_run/tested_vehicles.h"
#include "interpreter/environment/percepts.h"
#include "interpreter/support/text.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {
namespace {

std::string text_of(const std::vector<std::string>& command) {
  return fmt::format("{}", fmt::join(command, " "));
}

std::size_t count_percepts(const ProcessEnvironment& world, std::size_t agent) {
  Percepts percepts;
  percepts.begin_look();
  world.perceive(AgentId{static_cast<std::uint32_t>(agent)}, percepts);
  percepts.end_look();
  return percepts.size();
}

std::string description(const EnvironmentIdentity& identity) {
  std::string text = fmt::format("{} {}", identity.name, identity.version);
  text += identity.free_running ? ", free-running"
                                : fmt::format(", ticks of {:g} ms", identity.tick_ms);
  if (identity.percepts) {
    text += fmt::format(", declares {}", counted(identity.percepts->size(), "percept"));
  }
  if (identity.actions) {
    text += fmt::format(", declares {}", counted(identity.actions->size(), "action"));
  }
  return text;
}

/// A valid test input; nothing if none is found soon.
std::optional<search::TestInput> some_input(const search::SearchSpace& space, std::uint64_t seed) {
  constexpr int kMostDraws = 10'000;
  search::Random random(seed);
  for (int i = 0; i < kMostDraws; ++i) {
    search::TestInput input = space.draw_initial(random);
    if (space.contains(input)) return input;
  }
  return std::nullopt;
}

}  // namespace

void Trials::try_scenario(const Scenario& scenario, Diagnostics& diagnostics) {
  for (const TestedVehicle& vehicle : tested_vehicles(scenario)) {
    const VehicleParameters& parameters = vehicle.parameters;
    if (!parameters.command.empty() && tried_.insert(parameters.command).second) {
      try_controller(parameters, scenario, diagnostics);
    }
  }
  if (!scenario.world->simulator().name.empty()) try_simulator(scenario, diagnostics);
}

// It drives on an empty road.
void Trials::try_controller(const VehicleParameters& vehicle, const Scenario& scenario,
                            Diagnostics& diagnostics) {
  constexpr double kSpeedMps = 9;
  constexpr double kLaneM = 3;
  ControllerProcesses processes;
  const Clock::time_point since = Clock::now();
  const bool is_given = vehicle.command == scenario.world->vehicle().command;
  const std::string key = is_given ? "world.av.command" : "world.av.twin.command";
  const std::unique_ptr<VehicleController> controller = make_external(vehicle);
  controller->begin({.test = 0,
                     .seed = scenario.experiment.seed,
                     .behaviour = scenario.behaviours.front().name,
                     .agents = 1,
                     .road_m = vehicle.range_m,
                     .cruise_mps = kSpeedMps,
                     .processes = &processes});
  const SeenLane lane{.left_m = 0, .right_m = kLaneM};
  const VehicleDecision decision = controller->decide({.period_s = scenario.world->tick_s(),
                                                       .speed_mps = kSpeedMps,
                                                       .cruise_mps = kSpeedMps,
                                                       .left_m = 0.5,
                                                       .right_m = 2.5,
                                                       .lane_left_m = lane.left_m,
                                                       .lane_right_m = lane.right_m,
                                                       .actors = {},
                                                       .stop_lines = {},
                                                       .length_m = 4.5,
                                                       .range_m = vehicle.range_m,
                                                       .lanes = {&lane, 1}});
  if (const std::string why = controller->failure(); !why.empty()) {
    report(diagnostics, origin_of(scenario.origins, key, scenario.name), why);
  } else {
    say(key, text_of(vehicle.command),
        fmt::format("{:g} m/s2 on an empty road", decision.acceleration_mps2), since);
  }
  for (const std::string& note : controller->take_notes()) console_.note(note);
}

void Trials::try_simulator(const Scenario& scenario, Diagnostics& diagnostics) {
  const Clock::time_point since = Clock::now();
  auto version = simulator_version(scenario);
  if (version) {
    const SimulatorParameters& simulator = scenario.world->simulator();
    const SettingValue* const command = simulator.find("command");
    say("world.simulator", command != nullptr ? text_of(command->command) : simulator.name,
        version.value(), since);
  } else {
    diagnostics.append(std::move(version.diagnostics()));
  }
}

void Trials::try_search(const search::SearchExperiment& experiment, Diagnostics& diagnostics) {
  const search::SutModel& model = *experiment.plan.model;
  if (const Scenario* const scenario = model.scenario()) {
    try_scenario(*scenario, diagnostics);
    return;
  }
  const std::vector<std::string> command = model.command();
  if (command.empty() || !tried_.insert(command).second) return;
  const auto input = some_input(model.space(), experiment.plan.seed);
  if (!input) {
    diagnostics.error(experiment.name, "no valid test input was found to try the command with");
    return;
  }
  const Clock::time_point since = Clock::now();
  const search::Outcome outcome = model.make()->run(*input, 0);
  if (!outcome.executed()) {
    diagnostics.error(experiment.name, fmt::format("sut.command: {}", outcome.error));
    return;
  }
  std::string measures;
  for (std::size_t i = 0; i < outcome.measures.size(); ++i) {
    measures +=
        fmt::format("{}{} {:g}", i == 0 ? "" : ", ", model.measures()[i].name, outcome.measures[i]);
  }
  say("sut.command", text_of(command), measures, since);
}

std::optional<EnvironmentIdentity> Trials::try_world(const OwnWorld& world,
                                                     const std::vector<std::string>& agents,
                                                     Diagnostics& diagnostics) {
  const Clock::time_point since = Clock::now();
  SymbolTable symbols;
  auto environment = make_world(world, console_);
  bool began = environment->start();
  if (began) {
    environment->use_names(symbols);
    began = environment->begin_run(
        0, {.count = agents.size(),
            .name = [&agents](AgentId id) { return agents[static_cast<std::size_t>(id)]; },
            .next_timer_ms = {}});
  }
  if (!began) {
    world.report_failure(*environment, diagnostics);
    return std::nullopt;
  }
  std::string answered = description(environment->identity());
  for (std::size_t i = 0; i < agents.size(); ++i) {
    constexpr std::size_t kMostShown = 5;
    if (i == kMostShown) {
      answered += ", ...";
      break;
    }
    answered += fmt::format(", {} perceives {}", agents[i],
                            counted(count_percepts(*environment, i), "literal"));
  }
  say("environment", text_of(world.command), answered, since);
  return environment->identity();
}

void Trials::say(std::string_view key, std::string_view command, std::string_view answered,
                 Clock::time_point since) {
  const std::chrono::duration<double> took = Clock::now() - since;
  console_.print(fmt::format("{} '{}': {} ({:.2f} s)\n", key, command, answered, took.count()));
  console_.flush();
}

}  // namespace jaywalk
