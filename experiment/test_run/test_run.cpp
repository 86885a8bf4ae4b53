// SPDX-License-Identifier: Apache-2.0
#include "experiment/test_run/test_run.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "experiment/scenario/number_list.h"
#include "experiment/test_run/covered_bins.h"
#include "interpreter/agent/agent.h"
#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

// Separate random streams of a test's seed, so that start cells do not depend on the agents' draws.
enum class Purpose : std::uint64_t { start_cells = 0, agents = 1 };

std::uint64_t seed_for(const TestSetup& setup, Purpose purpose) {
  return mix(mix(setup.seed, setup.test), static_cast<std::uint64_t>(purpose));
}

// A single agent's parameters replace those of the whole behaviour.
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

/// Sets the parameters common to all agents of a test's behaviour; those of single agents are not
/// changed.
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

std::vector<AgentSpec> agents_of(const PreparedScenario& prepared, const TestSetup& setup) {
  std::vector<AgentSpec> specs;
  const PreparedBehaviour& behaviour = prepared.behaviours()[setup.behaviour];
  for (std::uint32_t number = 1; number <= setup.agents; ++number) {
    // The order of precedence: the member's program, then what single agents are given.
    const auto own = behaviour.team.find(number);
    AgentSpec& spec = specs.emplace_back(AgentSpec{
        prepared.scenario().world->agent_name(number),
        own == behaviour.team.end() ? behaviour.program : own->second, behaviour.parameters});
    set_own_parameters(behaviour, number, spec);
  }
  for (const PreparedBehaviour& actor : prepared.actors()) {
    specs.push_back({actor.name, actor.program, actor.parameters});
  }
  return specs;
}

/// The one limit of a test that depends on the machine.
class TestDeadline {
 public:
  /// Seconds from now; 0: never.
  explicit TestDeadline(double limit_s)
      : limit_s_(limit_s), start_(std::chrono::steady_clock::now()) {}

  [[nodiscard]] bool passed() const {
    if (limit_s_ <= 0) return false;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
    return taken.count() > limit_s_;
  }
  [[nodiscard]] std::string message() const {
    return fmt::format("the test took longer than its limit of {:g} s", limit_s_);
  }

 private:
  double limit_s_;
  std::chrono::steady_clock::time_point start_;
};

/// REQUIRES: deadline and options outlive the run. A test that asks for more than its memory is at
/// fault as a whole: an agent whose steps fail would go on and be measured as if it had chosen to.
void set_limits(const TestLimits& limits, const TestDeadline& deadline, const TestOptions& wanted,
                MasOptions& options) {
  constexpr std::uint64_t kMegabyte = std::uint64_t{1} << 20U;
  options.max_run_inferences = limits.inferences;
  options.at_memory_limit = MasOptions::AtMemoryLimit::end_run;
  if (limits.memory_mb > 0) {
    options.max_agent_bytes = limits.memory_mb * kMegabyte;
    options.max_system_bytes = limits.memory_mb * kMegabyte;
  }
  if (limits.time_s <= 0 && !wanted.interrupted) return;
  options.interrupted = [&deadline, &asked = wanted.interrupted] {
    return deadline.passed() || (asked && asked());
  };
}

std::string describe(const RunOutcome& outcome, const TestDeadline& deadline) {
  if (outcome.end == RunEnd::interrupted) {
    return deadline.passed() ? deadline.message() : "interrupted";
  }
  // Some messages name their place already.
  if (!outcome.message.empty()) {
    const bool placed =
        outcome.where.empty() || outcome.message.find(outcome.where) != std::string::npos;
    return placed ? outcome.message : fmt::format("{} ({})", outcome.message, outcome.where);
  }
  if (outcome.end != RunEnd::stopped) return "the run was cut short";
  return fmt::format("{} stopped the system",
                     outcome.agent.empty() ? "an agent" : "agent " + outcome.agent);
}

void record_events(const World& world, const TestSetup& setup, const TestRun& result,
                   Recording& recording) {
  if (!setup.feedback.empty()) {
    recording.add(RecordedEvent{
        .tick = 0, .actor = {}, .kind = "feedback", .text = feedback_text(setup.feedback)});
  }
  if (setup.head_start > 0) {
    recording.add(RecordedEvent{
        .tick = 0, .actor = {}, .kind = "head_start", .text = fmt::format("{}", setup.head_start)});
  }
  for (WorldEvent& each : world.events()) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(each.tick),
                                .actor = static_cast<std::uint32_t>(each.actor),
                                .kind = std::move(each.kind),
                                .text = std::move(each.text)});
  }
  for (const std::size_t agent : world.result().met_by) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(world.result().ticks),
                                .actor = static_cast<std::uint32_t>(agent + 1),
                                .kind = "precondition",
                                .text = {}});
  }
  for (const Collision& each : world.result().collisions) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(each.tick),
                                .actor = static_cast<std::uint32_t>(each.body + 1),
                                .kind = "collision",
                                .text = fmt::format("impact at {:.1f} m/s", each.impact_mps)});
  }
  if (!result.completed) {
    recording.add(RecordedEvent{.tick = static_cast<std::uint32_t>(recording.scenes() - 1),
                                .actor = {},
                                .kind = std::string(kErrored),
                                .text = result.message});
  }
}

/// REQUIRES: the agents are those of the world, then perhaps others that they have created.
TestTroubles troubles_of(const Mas& mas, const WorldResult& outcome) {
  TestTroubles troubles{.agents = mas.agent_count(), .pedestrians = outcome.agents.size()};
  for (const AgentOutcome& each : outcome.agents) troubles.idle += each.actions == 0;
  for (std::uint32_t number = 0; number < mas.agent_count(); ++number) {
    // An agent that has ended took its record of drops with it.
    if (!mas.is_alive(AgentId{number})) continue;
    for (const DropCause& cause : mas.agent(AgentId{number}).drops()) {
      troubles.drops.push_back({.actor = number + 1, .cause = cause});
    }
  }
  return troubles;
}

void shorten_paths(TestTroubles& troubles, const PortableNames& names) {
  for (AgentDrop& drop : troubles.drops) {
    for (std::string* const text : {&drop.cause.file, &drop.cause.message, &drop.cause.goals}) {
      *text = names.in(std::move(*text));
    }
  }
}

void give_up(std::string why, TestRun& result) {
  result.completed = false;
  result.message = std::move(why);
}

void run_to_the_end(Mas& mas, const World& world, const TestOptions& options,
                    const TestDeadline& deadline, TestRun& result) {
  const auto observe = [&] {
    if (options.observe) options.observe(world, mas);
    if (options.record != nullptr) options.record->add(world.scene());
  };
  observe();
  while (!world.finished()) {
    // The last step may both finish the world and end the run: then the test is complete.
    if (!mas.step() && !world.finished()) {
      return give_up(describe(mas.outcome(), deadline), result);
    }
    observe();
    if (std::string failure = world.failure(); !failure.empty()) {
      return give_up(std::move(failure), result);
    }
    if (deadline.passed()) return give_up(deadline.message(), result);
    if (options.interrupted && options.interrupted()) return give_up("interrupted", result);
  }
}

/// Tells the controller that the test ends, which may fail, too.
void end_drive(World& world, TestRun& result) {
  world.end();
  if (std::string failure = world.failure(); !failure.empty()) {
    give_up(std::move(failure), result);
  }
}

}  // namespace

TestRun errored_test(std::string why, const TestOptions& options) {
  TestRun failed;
  give_up(std::move(why), failed);
  failed.troubles.error = failed.message;
  if (options.record != nullptr) {
    *options.record = Recording();
    options.record->add(RecordedEvent{
        .tick = 0, .actor = {}, .kind = std::string(kErrored), .text = failed.message});
  }
  return failed;
}

WorldStart start_of(const TestSetup& setup) {
  return {.agents = setup.agents,
          .test = setup.test,
          .seed = seed_for(setup, Purpose::start_cells),
          .head_start = setup.head_start,
          .cells = setup.starts};
}

std::vector<Position> start_cells(const Scenario& scenario, const TestSetup& setup) {
  return scenario.world->start_cells(start_of(setup));
}

std::map<std::uint64_t, std::vector<Position>> start_cells(const Scenario& scenario,
                                                           std::uint32_t agents, std::uint64_t seed,
                                                           std::uint64_t tests) {
  std::map<std::uint64_t, std::vector<Position>> cells;
  for (std::uint64_t test = 0; test < tests; ++test) {
    cells[test] = start_cells(scenario, {.agents = agents, .seed = seed, .test = test});
  }
  return cells;
}

std::string problem(const PreparedScenario& prepared, const TestSetup& setup) {
  if (setup.behaviour >= prepared.behaviours().size()) {
    return fmt::format("there is no behaviour {}, only {}", setup.behaviour,
                       prepared.behaviours().size());
  }
  if (setup.agents == 0) return "a test needs at least one agent";
  if (setup.agents > kMaxAgents) {
    return fmt::format("a test has at most {} agents, found {}", kMaxAgents, setup.agents);
  }
  return prepared.scenario().world->problem(start_of(setup));
}

TestResult result_of(const TestRun& run, double wall_us) {
  TestResult result{.errored = !run.completed,
                    .ticks = static_cast<std::uint32_t>(run.outcome.ticks),
                    .cpu_us = run.cpu_s * 1e6,
                    .wall_us = wall_us};
  if (result.errored) return result;
  result.succeeded = run.outcome.success;
  result.score = run.outcome.score();
  return result;
}

TestOutcome outcome_of(const TestRun& run) {
  const WorldResult& of = run.outcome;
  TestOutcome outcome{.ticks = static_cast<std::uint32_t>(of.all_ticks)};
  if (!run.completed) {
    outcome.ended_by = kErrored;
    return outcome;
  }
  if (of.success) outcome.precondition_ticks = static_cast<std::uint32_t>(of.ticks);
  if (!of.end.empty()) outcome.ended_by = of.end;
  if (!of.collisions.empty()) outcome.impact_mps = of.collisions.front().impact_mps;
  return outcome;
}

void TestRunner::add_agents(const TestSetup& setup) {
  if (specs_.empty() || behaviour_ != setup.behaviour || agents_ != setup.agents) {
    specs_ = agents_of(prepared_, setup);
    behaviour_ = setup.behaviour;
    agents_ = setup.agents;
  }
  // This test's own beliefs use the system's symbols.
  const std::vector<Parameter> feedback = beliefs(setup.feedback, mas_->symbols());
  const std::vector<Parameter> given = beliefs(setup.parameters, mas_->symbols());
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    if ((feedback.empty() && given.empty()) || i >= agents_) {
      mas_->add_agent(specs_[i]);
      continue;
    }
    AgentSpec spec = specs_[i];
    set_common_parameters(prepared_.behaviours()[setup.behaviour],
                          static_cast<std::uint32_t>(i + 1), given, spec);
    spec.parameters.insert(spec.parameters.end(), feedback.begin(), feedback.end());
    mas_->add_agent(spec);
  }
}

TestRun TestRunner::run(const TestSetup& setup, const TestOptions& options) {
  assert(problem(prepared_, setup).empty() && "the caller has asked for obstacles");
  const std::unique_ptr<World> world = prepared_.world(setup.vehicle).make(start_of(setup));
  MasOptions mas_options;
  mas_options.seed = seed_for(setup, Purpose::agents);
  mas_options.max_cycles_per_tick = options.max_cycles_per_tick;
  const TestLimits& limits = prepared_.scenario().experiment.limits;
  const TestDeadline deadline(limits.time_s);
  mas_options.max_cycles = options.max_cycles > 0 ? options.max_cycles : limits.cycles;
  mas_options.max_ticks = options.max_ticks;
  set_limits(limits, deadline, options, mas_options);
  mas_options.print = options.print;
  mas_options.log = options.log;
  mas_options.measure_cpu = options.measure_cpu;
  mas_options.observer = options.observer;
  mas_options.policies = options.policies;
  std::optional<PolicyReader> policy;
  // The options' policy takes precedence: a learner watches and explores through it.
  if (options.policies == nullptr && prepared_.behaviours()[setup.behaviour].policy != nullptr) {
    mas_options.policies = &policy.emplace(prepared_.behaviours()[setup.behaviour].policy);
  }
  if (mas_ == nullptr) {
    mas_ = std::make_unique<Mas>(prepared_.symbols(), std::move(mas_options), world.get());
  } else {
    // The system of the last test keeps its memory, and nothing else (Mas::restart).
    mas_->restart(std::move(mas_options), world.get());
  }
  add_agents(setup);
  test_ = setup.test;
  world->begin({.test = setup.test,
                .seed = setup.seed,
                .behaviour = prepared_.behaviours()[setup.behaviour].name,
                .agents = setup.agents,
                .processes = &processes_,
                .simulators = &simulators_});

  TestRun result;
  if (options.record != nullptr) {
    *options.record = Recording(prepared_.scenario().world->tick_s(), world->actors());
  }
  run_to_the_end(*mas_, *world, options, deadline, result);
  // Asked again, since the run may have ended by a limit of its own just before.
  result.interrupted = !result.completed && options.interrupted && options.interrupted();
  if (result.completed) end_drive(*world, result);
  result.notes = world->take_notes();
  if (options.names != nullptr) result.message = options.names->in(std::move(result.message));
  if (options.record != nullptr) record_events(*world, setup, result, *options.record);
  result.outcome = world->result();
  // A chain goes on as if a new one began.
  result.left_over = result.completed ? world->left_over() : 0;
  result.cycles = mas_->outcome().cycles;
  result.troubles = troubles_of(*mas_, result.outcome);
  if (options.names != nullptr) shorten_paths(result.troubles, *options.names);
  if (!result.completed) result.troubles.error = result.message;
  result.cpu_s = mas_->reasoning_cpu_s();
  return result;
}

bool TestRunner::has_run(const TestSetup& setup) const {
  return behaviour_ == setup.behaviour && agents_ == setup.agents && test_ == setup.test;
}

/// Null: all are lent.
std::unique_ptr<TestRunner> TestRunners::idle_runner(const TestSetup& setup) {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return nullptr;
  const auto fit = std::ranges::find_if(
      idle_, [&](const std::unique_ptr<TestRunner>& each) { return each->has_run(setup); });
  if (fit != idle_.end()) std::swap(*fit, idle_.back());
  std::unique_ptr<TestRunner> runner = std::move(idle_.back());
  idle_.pop_back();
  return runner;
}

TestRun TestRunners::run(const TestSetup& setup, const TestOptions& options) {
  std::unique_ptr<TestRunner> runner = idle_runner(setup);
  TestRun result;
  try {
    if (runner == nullptr) runner = std::make_unique<TestRunner>(prepared_);
    result = runner->run(setup, options);
  } catch (const std::bad_alloc&) {
    // The runner is dropped, not returned to the idle ones: its state is unknown.
    return errored_test("the machine has no memory left for the test", options);
  }
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(runner));
  return result;
}

TestRun run_test(const PreparedScenario& prepared, const TestSetup& setup,
                 const TestOptions& options) {
  return TestRunner(prepared).run(setup, options);
}

}  // namespace jaywalk
