#include "experiment/trial.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/format.h>

#include "env/crossing/spawn.h"
#include "env/grid/random.h"
#include "experiment/feedback.h"
#include "interpreter/agent/agent.h"

namespace jaywalk {
namespace {

// What a test's seed is used for, so that where agents start does not depend on what they draw.
enum class Purpose : std::uint64_t { start_cells = 0, agents = 1 };

std::uint64_t seed_for(const TrialInput& input, Purpose purpose) {
  return mix(mix(input.seed, input.test), static_cast<std::uint64_t>(purpose));
}

// What single agents are given takes the place of what all of a behaviour have.
void set_own_parameters(const PreparedBehaviour& behaviour, std::uint32_t number, AgentSpec& spec) {
  const auto own = behaviour.agent_parameters.find(number);
  if (own == behaviour.agent_parameters.end()) return;
  for (const Parameter& parameter : own->second) {
    std::erase_if(spec.parameters,
                  [&](const Parameter& common) { return common.predicate == parameter.predicate; });
    spec.parameters.push_back(parameter);
  }
}

std::vector<Parameter> beliefs(const std::vector<CoveredBin>& feedback, SymbolTable& symbols) {
  std::vector<Parameter> parameters;
  for (const CoveredBin& each : feedback) {
    parameters.push_back({symbols.predicate("covered", 3),
                          {Value::atom(symbols.predicate(each.item, 0)), Value::number(each.bin),
                           Value::number(static_cast<double>(each.times))}});
  }
  return parameters;
}

std::vector<Parameter> beliefs(const std::vector<ParameterSetting>& settings,
                               SymbolTable& symbols) {
  std::vector<Parameter> parameters;
  for (const ParameterSetting& each : settings) {
    Parameter& parameter = parameters.emplace_back(Parameter{
        symbols.predicate(each.name, static_cast<std::uint16_t>(each.values.size())), {}});
    for (const ParameterValue& value : each.values) {
      const auto* const number = std::get_if<double>(&value);
      parameter.args.push_back(
          number != nullptr ? Value::number(*number)
                            : Value::atom(symbols.predicate(std::get<std::string>(value), 0)));
    }
  }
  return parameters;
}

/// What a test sets for all agents of its behaviour, but not what the scenario says of single ones.
void set_common_parameters(const PreparedBehaviour& behaviour, std::uint32_t number,
                           const std::vector<Parameter>& given, AgentSpec& spec) {
  const auto own = behaviour.agent_parameters.find(number);
  for (const Parameter& parameter : given) {
    const auto same = [&](const Parameter& other) {
      return other.predicate == parameter.predicate;
    };
    if (own != behaviour.agent_parameters.end() && std::ranges::any_of(own->second, same)) continue;
    std::erase_if(spec.parameters, same);
    spec.parameters.push_back(parameter);
  }
}

std::vector<AgentSpec> agents_of(const PreparedScenario& prepared, const TrialInput& input) {
  std::vector<AgentSpec> specs;
  const PreparedBehaviour& behaviour = prepared.behaviours()[input.behaviour];
  for (std::uint32_t number = 1; number <= input.agents; ++number) {
    const auto own = behaviour.team.find(number);
    AgentSpec& spec = specs.emplace_back(AgentSpec{
        fmt::format("p{}", number), own == behaviour.team.end() ? behaviour.program : own->second,
        behaviour.parameters});
    set_own_parameters(behaviour, number, spec);
  }
  for (const PreparedBehaviour& actor : prepared.actors()) {
    specs.push_back({actor.name, actor.program, actor.parameters});
  }
  return specs;
}

std::string describe(const RunOutcome& outcome) {
  if (!outcome.message.empty()) return outcome.message;
  return outcome.end == RunEnd::stopped ? "an agent stopped the system" : "the run was cut short";
}

void record_events(const Crossing& crossing, const TrialInput& input, Recording& recording) {
  if (!input.feedback.empty()) {
    recording.add(RecordedEvent{
        .tick = 0, .actor = {}, .kind = "feedback", .text = feedback_text(input.feedback)});
  }
  if (input.head_start > 0) {
    recording.add(RecordedEvent{
        .tick = 0, .actor = {}, .kind = "head_start", .text = fmt::format("{}", input.head_start)});
  }
  for (const SignalChange& each : crossing.result().signals) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(each.tick),
                                .actor = static_cast<std::uint32_t>(each.body + 1),
                                .kind = "signal",
                                .text = std::string(name(each.colour))});
  }
  for (const std::size_t pedestrian : crossing.result().hit_by) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(crossing.result().ticks),
                                .actor = static_cast<std::uint32_t>(pedestrian + 1),
                                .kind = "precondition",
                                .text = {}});
  }
  for (const Collision& each : crossing.result().collisions) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(each.tick),
                                .actor = static_cast<std::uint32_t>(each.body + 1),
                                .kind = "collision",
                                .text = fmt::format("impact at {:.3f} m/s", each.impact_mps)});
  }
}

/// REQUIRES: the agents are those of the crossing, then perhaps others that they have created.
TestTroubles troubles_of(const Mas& mas, const CrossingResult& outcome) {
  TestTroubles troubles{.agents = mas.agent_count(), .pedestrians = outcome.pedestrians.size()};
  for (const PedestrianOutcome& each : outcome.pedestrians) troubles.idle += each.actions == 0;
  for (std::uint32_t number = 0; number < mas.agent_count(); ++number) {
    if (!mas.is_alive(AgentId{number})) continue;
    for (const DropCause& cause : mas.agent(AgentId{number}).drops()) {
      troubles.drops.push_back({.actor = number + 1, .cause = cause});
    }
  }
  return troubles;
}

void run_to_the_end(Mas& mas, const Crossing& crossing, const TrialOptions& options,
                    TrialResult& result) {
  const auto observe = [&] {
    if (options.observe) options.observe(crossing, mas);
    if (options.record != nullptr) options.record->add(crossing.scene());
  };
  observe();
  while (!crossing.finished()) {
    if (!mas.step() && !crossing.finished()) {
      result.completed = false;
      result.message = describe(mas.outcome());
      return;
    }
    observe();
    if (std::string failure = crossing.failure(); !failure.empty()) {
      result.completed = false;
      result.message = std::move(failure);
      return;
    }
  }
}

}  // namespace

std::vector<Position> start_cells(const Scenario& scenario, const TrialInput& input) {
  if (!input.starts.empty()) return input.starts;
  if (!scenario.start_cells) {
    return spawn(scenario.world, input.agents, seed_for(input, Purpose::start_cells));
  }
  const auto test = scenario.start_cells->find(input.test);
  if (test == scenario.start_cells->end() || test->second.size() < input.agents) return {};
  return {test->second.begin(), test->second.begin() + input.agents};
}

StartCells start_cells(const Scenario& scenario, std::uint32_t agents, std::uint64_t seed,
                       std::uint64_t tests) {
  StartCells cells;
  for (std::uint64_t test = 0; test < tests; ++test) {
    cells[test] = start_cells(scenario, {.agents = agents, .seed = seed, .test = test});
  }
  return cells;
}

std::string obstacle(const PreparedScenario& prepared, const TrialInput& input) {
  if (input.behaviour >= prepared.behaviours().size()) {
    return fmt::format("there is no behaviour {}, only {}", input.behaviour,
                       prepared.behaviours().size());
  }
  if (input.agents == 0) return "a test needs at least one agent";
  if (start_cells(prepared.scenario(), input).empty()) {
    return fmt::format("test {} has fewer than {} start cells in the scenario's file", input.test,
                       input.agents);
  }
  return {};
}

TestOutcome outcome_of(const TrialResult& trial) {
  const CrossingResult& of = trial.outcome;
  TestOutcome outcome{.ticks = static_cast<std::uint32_t>(of.all_ticks)};
  if (of.success) outcome.precondition_ticks = static_cast<std::uint32_t>(of.ticks);
  if (of.end) outcome.ended_by = name(*of.end);
  if (!of.collisions.empty()) outcome.impact_mps = of.collisions.front().impact_mps;
  return outcome;
}

void TrialRunner::add_agents(const TrialInput& input) {
  if (specs_.empty() || behaviour_ != input.behaviour || agents_ != input.agents) {
    specs_ = agents_of(prepared_, input);
    behaviour_ = input.behaviour;
    agents_ = input.agents;
  }
  // What is of this test alone is in the system's own names.
  const std::vector<Parameter> feedback = beliefs(input.feedback, mas_->symbols());
  const std::vector<Parameter> given = beliefs(input.parameters, mas_->symbols());
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if ((feedback.empty() && given.empty()) || i >= agents_) {
      mas_->add_agent(specs_[i]);
      continue;
    }
    AgentSpec spec = specs_[i];
    set_common_parameters(prepared_.behaviours()[input.behaviour],
                          static_cast<std::uint32_t>(i + 1), given, spec);
    spec.parameters.insert(spec.parameters.end(), feedback.begin(), feedback.end());
    mas_->add_agent(spec);
  }
}

TrialResult TrialRunner::run(const TrialInput& input, const TrialOptions& options) {
  assert(obstacle(prepared_, input).empty() && "the caller has asked for obstacles");
  Crossing crossing(prepared_.world(input.vehicle), prepared_.vocabulary(),
                    start_cells(prepared_.scenario(), input), input.head_start);
  MasOptions mas_options;
  mas_options.seed = seed_for(input, Purpose::agents);
  mas_options.max_cycles_per_tick = options.max_cycles_per_tick;
  mas_options.max_cycles = options.max_cycles;
  mas_options.max_ticks = options.max_ticks;
  mas_options.print = options.print;
  mas_options.log = options.log;
  mas_options.measure_cpu = options.measure_cpu;
  mas_options.observer = options.observer;
  if (mas_ == nullptr) {
    mas_ = std::make_unique<Mas>(prepared_.symbols(), std::move(mas_options), &crossing);
  } else {
    mas_->restart(std::move(mas_options), &crossing);
  }
  add_agents(input);
  crossing.begin({.test = input.test,
                  .seed = input.seed,
                  .behaviour = prepared_.behaviours()[input.behaviour].name,
                  .agents = input.agents,
                  .processes = &processes_});

  TrialResult result;
  if (options.record != nullptr) {
    *options.record = Recording(prepared_.scenario().world.tick_s, crossing.actors());
  }
  run_to_the_end(*mas_, crossing, options, result);
  if (result.completed) crossing.end();
  result.note = crossing.note();
  if (options.record != nullptr) record_events(crossing, input, *options.record);
  result.outcome = crossing.result();
  result.left_over = crossing.left_over();
  result.cycles = mas_->outcome().cycles;
  result.troubles = troubles_of(*mas_, result.outcome);
  result.cpu_s = mas_->reasoning_cpu_s();
  return result;
}

TrialResult TrialRunners::run(const TrialInput& input, const TrialOptions& options) {
  std::unique_ptr<TrialRunner> runner;
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      runner = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (runner == nullptr) runner = std::make_unique<TrialRunner>(prepared_);
  TrialResult result = runner->run(input, options);
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(runner));
  return result;
}

TrialResult run_trial(const PreparedScenario& prepared, const TrialInput& input,
                      const TrialOptions& options) {
  return TrialRunner(prepared).run(input, options);
}

}  // namespace jaywalk
