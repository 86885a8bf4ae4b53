#include "tools/jaywalk/run/run_scenario.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <sys/ioctl.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiment/compare/carry_over.h"
#include "experiment/export/junit.h"
#include "experiment/report/tables/troubles_text.h"
#include "experiment/report/tables/verdict_table.h"
#include "experiment/test_run/plan_coverage.h"
#include "experiment/test_run/simulator_version.h"
#include "experiment/test_run/test_run.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/viewer.h"
#include "tools/jaywalk/console/watch.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/store_options.h"
#include "tools/jaywalk/run/test_trace.h"
#include "tools/jaywalk/run/trace_output.h"

namespace jaywalk {
namespace {

constexpr double kDefaultSpeed = 2;

struct Request {
  std::shared_ptr<const PreparedScenario> prepared;
  TestSetup setup;
  std::optional<double> timeout_s;
  std::uint64_t max_cycles = 0;
  std::uint64_t max_ticks = 0;
  /// Who moves the vehicles (simulator_version.h).
  std::string simulator;
  Criteria criteria;
  std::vector<FailureCondition> conditions;
  /// Ticks a second.
  double speed = kDefaultSpeed;
};

std::vector<std::string> behaviours_of(const Arguments& arguments) {
  if (const auto behaviour = arguments.text(option::kBehaviour)) return {*behaviour};
  return {};
}

/// What these options set, as `--set` would: so it is kept with a stored test.
std::vector<std::string> limits_of(const Arguments& arguments) {
  std::vector<std::string> sets;
  if (const auto inferences = arguments.text(option::kMaxInferences)) {
    sets.push_back("experiment.limits.inferences=" + *inferences);
  }
  if (const auto megabytes = arguments.text(option::kMaxMemory)) {
    sets.push_back("experiment.limits.memory_mb=" + *megabytes);
  }
  return sets;
}

std::optional<Request> read_request(const std::string& path, const Arguments& arguments,
                                    Console& console) {
  Diagnostics diagnostics;
  const auto agents = arguments.number(option::kAgents, 1, diagnostics);
  const auto seed = arguments.number(option::kSeed, 0, diagnostics);
  Request request;
  request.setup.test = arguments.number(option::kTest, 0, diagnostics).value_or(0);
  request.max_cycles = arguments.number(option::kMaxCycles, 1, diagnostics).value_or(0);
  // Only checked here: limits_of() hands them on as settings of the scenario.
  (void)arguments.number(option::kMaxInferences, 0, diagnostics);
  (void)arguments.number(option::kMaxMemory, 0, diagnostics);
  request.max_ticks = arguments.number(option::kMaxTicks, 1, diagnostics).value_or(0);
  request.timeout_s = arguments.positive(option::kTimeout, diagnostics);
  request.speed = arguments.positive(option::kSpeed, diagnostics).value_or(kDefaultSpeed);
  if (agents.value_or(1) > kMaxAgents) {
    diagnostics.error(option::kAgents.dashed(), fmt::format("at most {}", kMaxAgents));
  }
  request.conditions = read_conditions(arguments, diagnostics);
  check_coverage_options(arguments, diagnostics);
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  request.prepared =
      prepare_scenario(path, arguments, behaviours_of(arguments), console, limits_of(arguments));
  if (!request.prepared) return std::nullopt;
  const ExperimentSpec& defaults = request.prepared->scenario().experiment;
  request.setup.agents = static_cast<std::uint32_t>(agents.value_or(defaults.agents.front()));
  request.setup.seed = seed.value_or(defaults.seed);
  if (const std::string why = problem(*request.prepared, request.setup); !why.empty()) {
    console.error(why);
    return std::nullopt;
  }
  auto criteria = read_criteria(arguments, request.prepared->scenario().assertions, console);
  if (!criteria || !check_conditions(request.conditions, *criteria, console)) return std::nullopt;
  request.criteria = std::move(*criteria);
  auto simulator = simulator_version(request.prepared->scenario());
  if (!simulator.ok()) {
    console.report(simulator.diagnostics());
    return std::nullopt;
  }
  request.simulator = std::move(simulator).value();
  return request;
}

std::string title_of(const Request& request) {
  return fmt::format("{}, {} agent{}, seed {}, test {}",
                     request.prepared->behaviours()[request.setup.behaviour].name,
                     request.setup.agents, request.setup.agents == 1 ? "" : "s", request.setup.seed,
                     request.setup.test);
}

/// The store for this one test, with everything that is seen of it.
std::unique_ptr<ResultsWriter> open_store(const Request& request, const Arguments& arguments,
                                          const std::string& path, Console& console) {
  const PreparedBehaviour& behaviour = request.prepared->behaviours()[request.setup.behaviour];
  const ExperimentPlan plan{
      .behaviours = {behaviour.name}, .agents = {request.setup.agents}, .tests = 1};
  ExperimentDescription description =
      describe(*request.prepared,
               scenario_options(arguments, behaviours_of(arguments), limits_of(arguments)), plan,
               request.setup.seed);
  add_judging(description, request.criteria.files, request.criteria.metrics);
  description.simulator = request.simulator;
  // The first behaviour is the one that runs; the others are no part of the plan.
  description.behaviours.resize(1);
  description.first_test = request.setup.test;
  return open_store({.path = path, .level = StoreLevel::all}, std::move(description), console);
}

TestResult result_of(const TestRun& run) {
  return {.succeeded = run.outcome.success,
          .ticks = static_cast<std::uint32_t>(run.outcome.ticks),
          .score = run.outcome.score()};
}

void store_test(const Request& request, const TestRun& run, Recording recording,
                const TestAssessment& assessment, ResultsWriter& store) {
  const TestKey test{.behaviour = request.setup.behaviour,
                     .agents = request.setup.agents,
                     .number = request.setup.test};
  TestRecord record = make_test_record(test, result_of(run), run, std::move(recording));
  record.assessments = to_rows(request.criteria, assessment);
  store.add(std::move(record));
}

/// The one test as a comparison, which conditions of --fail-on are about.
Comparison comparison_of(const Request& request, const TestRun& run,
                         const TestAssessment& assessment) {
  const std::string& behaviour = request.prepared->behaviours()[request.setup.behaviour].name;
  const ExperimentPlan plan{
      .behaviours = {behaviour}, .agents = {request.setup.agents}, .tests = 1};
  AssessmentTable table(request.criteria, plan);
  table.add({.agents = request.setup.agents}, assessment);
  const TestResult result = result_of(run);
  Comparison comparison{.summaries = {summarise({&result, 1})}};
  TroublesSum troubles;
  troubles.add(request.setup.test, run.troubles);
  comparison.troubles.push_back(troubles.sum());
  comparison.summaries.front().behaviour = behaviour;
  comparison.summaries.front().agents = request.setup.agents;
  add_assessments(request.criteria, table, plan.behaviours, comparison);
  return comparison;
}

/// Writes the verdicts and looks at --fail-on.
ExitCode conclude(const Request& request, const Arguments& arguments, const TestRun& run,
                  const TestAssessment& assessment, Console& console) {
  if (const auto path = arguments.text(option::kJunit)) {
    const std::string xml = to_junit(title_of(request), request.criteria, assessment);
    if (!write_output(*path, xml, console)) return ExitCode::failed;
  }
  const Comparison comparison = comparison_of(request, run, assessment);
  std::string troubles = render_troubles(troubles_of(comparison));
  if (troubles.ends_with('\n')) troubles.pop_back();
  if (!troubles.empty()) console.note(troubles);
  const bool failed = report_failures(request.conditions, comparison, console);
  return fails_strictly(arguments, comparison, console) || failed ? ExitCode::failed
                                                                  : ExitCode::success;
}

}  // namespace

ExitCode run_scenario_file(const std::string& path, const Arguments& arguments, Console& console) {
  const auto request = read_request(path, arguments, console);
  if (!request) return ExitCode::usage;

  const InterruptGuard interrupt;
  const Deadline deadline(request->timeout_s);
  Viewer viewer(title_of(*request), request->speed, interrupt, console);
  const bool watch = arguments.has(option::kWatch);
  TestOptions options{.max_cycles = request->max_cycles, .max_ticks = request->max_ticks};
  options.log = [&](std::string_view line) { console.log(LogLevel::warning, line); };
  options.print = [&](std::string_view line) {
    if (watch) {
      viewer.add_line(line);
    } else {
      console.print(fmt::format("{}\n", line));
    }
  };
  std::string outcome;
  options.observe = [&](const World& world, const Mas& mas) {
    if (watch && !interrupt.interrupted()) viewer.show(world, mas);
    if (world.finished()) outcome = world.describe_result();
  };
  const auto store_path = arguments.text(option::kStore);
  std::unique_ptr<ResultsWriter> store;
  Recording recording;
  if (store_path) {
    store = open_store(*request, arguments, *store_path, console);
    if (!store) return ExitCode::usage;
  }
  if (store || asks(request->criteria)) options.record = &recording;
  std::optional<PlanCoverage> coverage;
  std::optional<PlanCoverage::Borrowed> observer;
  Observers observers;
  if (arguments.has(option::kCoverage)) {
    const BehavioursRun run{{request->setup.behaviour, request->setup.agents}};
    observers.add(*observer.emplace(coverage.emplace(*request->prepared, run)).get());
  }
  std::optional<TraceFile> trace_file;
  if (!open_trace(arguments, trace_file, console)) return ExitCode::usage;
  TestTrace trace;
  if (trace_file) {
    observers.add(trace);
    options.observe = [&trace, show = options.observe](const World& world, const Mas& mas) {
      trace.tick(world, mas);
      show(world, mas);
    };
    trace.begin(request->prepared->behaviours()[request->setup.behaviour].name, request->setup);
  }
  options.observer = observers.get();
  options.interrupted = [&] { return interrupt.interrupted(); };
  // Where tests depend on each other those before this one run first, unseen.
  const auto setup = in_its_chain(*request->prepared, request->setup, [&] {
    return interrupt.interrupted() ? Proceed::no : Proceed::yes;
  });
  const TestRun result = setup ? run_test(*request->prepared, *setup, options) : TestRun{};
  // Returns what was counted to `coverage`.
  observer.reset();
  if (trace_file) {
    trace.end(result);
    trace_file->add(0, trace.lines());
  }
  if (!finish_trace(arguments, trace_file, console)) return ExitCode::failed;
  if (interrupt.interrupted()) {
    console.note("interrupted");
    return ExitCode::interrupted;
  }
  if (!result.completed) {
    console.error(result.message);
    return ExitCode::failed;
  }
  if (!result.note.empty()) console.note(result.note);
  TestAssessment assessment;
  std::string found;
  if (asks(request->criteria)) {
    assessment =
        assess(request->criteria, recording, request->prepared->scenario().world->ground());
    found = render_assessment(request->criteria, assessment, recording.actors());
    if (found.ends_with('\n')) found.pop_back();
  }
  if (store) {
    store_test(*request, result, std::move(recording), assessment, *store);
    if (!finish_store(*store, *store_path, console)) return ExitCode::failed;
  }
  if (watch) {
    console.print(fmt::format("{}\n{}{}", outcome, found, found.empty() ? "" : "\n"));
  } else {
    console.note(fmt::format("{}: {}", title_of(*request), outcome));
    if (!found.empty()) console.note(found);
  }
  if (coverage) {
    const std::string subject =
        fmt::format("{}: {}", arguments.operands().front(), title_of(*request));
    if (!write_coverage(arguments, coverage->total(), subject, console)) return ExitCode::failed;
  }
  return conclude(*request, arguments, result, assessment, console);
}

}  // namespace jaywalk
