// SPDX-License-Identifier: Apache-2.0
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
#include "experiment/export/comparison_files.h"
#include "experiment/report/tables/tables.h"
#include "experiment/scenario/files/portable_names.h"
#include "experiment/scenario/number_list.h"
#include "experiment/test_run/plan_coverage.h"
#include "experiment/test_run/simulator_version.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/watch.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/store_options.h"
#include "tools/jaywalk/run/agent_trace.h"
#include "tools/jaywalk/run/run_files.h"
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
  /// The simulator that moves the vehicles, with its version (simulator_version.h).
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

/// The settings that these options stand for, in the form of `--set`: a stored test keeps them.
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
  const auto agents = arguments.number(option::kAgents, 1, diagnostics, kMaxAgents);
  const auto seed = arguments.number(option::kSeed, 0, diagnostics);
  Request request;
  request.setup.test = arguments.number(option::kTest, 0, diagnostics).value_or(0);
  request.max_cycles = arguments.number(option::kMaxCycles, 1, diagnostics).value_or(0);
  // Only checked here: limits_of() hands them on as settings of the scenario.
  (void)arguments.number(option::kMaxInferences, 0, diagnostics, TestLimits::kMost);
  (void)arguments.number(option::kMaxMemory, 0, diagnostics, TestLimits::kMostMegabytes);
  request.max_ticks = arguments.number(option::kMaxTicks, 1, diagnostics).value_or(0);
  request.timeout_s = arguments.positive(option::kTimeout, diagnostics);
  request.speed = arguments.positive(option::kSpeed, diagnostics).value_or(kDefaultSpeed);
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
  return fmt::format(
      "{}, {}, seed {}, test {}", request.prepared->behaviours()[request.setup.behaviour].name,
      counted(request.setup.agents, "agent"), request.setup.seed, request.setup.test);
}

/// The store for this one test.
std::unique_ptr<ResultsWriter> open_store(const Request& request, const Arguments& arguments,
                                          const std::string& path, PortableNames& names,
                                          Console& console) {
  const PreparedBehaviour& behaviour = request.prepared->behaviours()[request.setup.behaviour];
  const ExperimentPlan plan{
      .behaviours = {behaviour.name}, .agents = {request.setup.agents}, .tests = 1};
  ExperimentDescription description =
      describe(*request.prepared,
               scenario_options(arguments, behaviours_of(arguments), limits_of(arguments)), plan,
               request.setup.seed);
  add_judging(description, request.criteria.files, request.criteria.metrics);
  make_portable(description, request.prepared->scenario().files);
  description.simulator = request.simulator;
  // The first behaviour is the one that runs; the others are no part of the plan.
  description.behaviours.resize(1);
  description.first_test = request.setup.test;
  names = description.names;
  auto store = open_store({.path = path, .level = StoreLevel::all}, std::move(description));
  if (store) return std::move(store).value();
  console.report(store.diagnostics());
  return nullptr;
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

/// The test as a comparison, so that conditions of --fail-on can be evaluated.
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

/// Writes the verdicts and evaluates --fail-on.
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
  const OutputOptions output{.strict = arguments.has(option::kStrict)};
  return fails_strictly(output, comparison, console) || failed ? ExitCode::failed
                                                               : ExitCode::success;
}

/// The one test, with everything that listens to it while it runs.
class ScenarioRun {
 public:
  ScenarioRun(const Request& request, const Arguments& arguments, Console& console)
      : request_(request), arguments_(arguments), console_(console) {}

  ExitCode run() {
    if (const auto path = arguments_.text(option::kStore)) {
      store_ = open_store(request_, arguments_, *path, names_, console_);
      if (!store_) return ExitCode::usage;
    }
    if (!open_trace(arguments_, trace_file_, console_)) return ExitCode::usage;
    const TestRun result = run_listened();
    console_.tell_counted();
    if (!finish_trace(arguments_, trace_file_, console_)) return ExitCode::failed;
    if (interrupt_.interrupted()) {
      console_.note("interrupted");
      return ExitCode::interrupted;
    }
    for (const std::string& note : result.notes) console_.note(note);
    if (!result.completed) {
      console_.error(result.message);
      return ExitCode::failed;
    }
    return report(result);
  }

 private:
  [[nodiscard]] TestOptions options() {
    TestOptions options{.names = store_ ? &names_ : nullptr,
                        .max_cycles = request_.max_cycles,
                        .max_ticks = request_.max_ticks};
    options.log = [this](std::string_view line) { console_.warn_of_agent(line); };
    options.print = [this](std::string_view line) {
      if (watch_) {
        viewer_.add_line(line);
      } else {
        console_.print(fmt::format("{}\n", line));
      }
    };
    options.observe = [this](const World& world, const Mas& mas) { see(world, mas); };
    options.interrupted = [this] { return interrupt_.interrupted(); };
    if (store_ || asks(request_.criteria)) options.record = &recording_;
    return options;
  }

  void see(const World& world, const Mas& mas) {
    if (trace_file_) trace_.tick(world, mas);
    if (watch_ && !interrupt_.interrupted()) viewer_.show(world, mas);
    if (world.finished()) outcome_ = world.describe_result();
  }

  [[nodiscard]] TestRun run_listened() {
    TestOptions options = this->options();
    std::optional<PlanCoverage::Borrowed> counting;  // returns what it has counted at the end
    Observers observers;
    if (arguments_.has(option::kCoverage)) {
      const BehavioursRun run{{request_.setup.behaviour, request_.setup.agents}};
      observers.add(*counting.emplace(coverage_.emplace(*request_.prepared, run)).get());
    }
    if (trace_file_) {
      observers.add(trace_);
      trace_.begin(request_.prepared->behaviours()[request_.setup.behaviour].name, request_.setup);
    }
    options.observer = observers.get();
    // Where tests depend on each other, those before this one run first, without output.
    const auto setup = in_its_chain(*request_.prepared, request_.setup, [this] {
      return interrupt_.interrupted() ? Proceed::no : Proceed::yes;
    });
    TestRun result = setup ? run_test(*request_.prepared, *setup, options) : TestRun{};
    if (trace_file_) {
      trace_.end(result);
      trace_file_->add(0, trace_.lines());
    }
    return result;
  }

  /// Writes the result of a completed test to the terminal and into the files.
  ExitCode report(const TestRun& result) {
    TestAssessment assessment;
    std::string found;
    if (asks(request_.criteria)) {
      assessment =
          assess(request_.criteria, recording_, request_.prepared->scenario().world->ground());
      found = render_assessment(request_.criteria, assessment, recording_.actors());
      if (found.ends_with('\n')) found.pop_back();
    }
    if (store_) {
      store_test(request_, result, std::move(recording_), assessment, *store_);
      if (!is_kept(store_->finish(), *arguments_.text(option::kStore), console_)) {
        return ExitCode::failed;
      }
    }
    show(found);
    if (coverage_) {
      const std::string subject =
          fmt::format("{}: {}", portable_path(arguments_.operands().front()), title_of(request_));
      if (!write_coverage(arguments_, coverage_->total(), subject, console_)) {
        return ExitCode::failed;
      }
    }
    return conclude(request_, arguments_, result, assessment, console_);
  }

  void show(const std::string& found) {
    if (watch_) {
      console_.print(fmt::format("{}\n{}{}", outcome_, found, found.empty() ? "" : "\n"));
      return;
    }
    console_.note(fmt::format("{}: {}", title_of(request_), outcome_));
    if (!found.empty()) console_.note(found);
  }

  const Request& request_;
  const Arguments& arguments_;
  Console& console_;
  const InterruptGuard interrupt_;
  const Deadline deadline_{request_.timeout_s};
  const bool watch_ = arguments_.has(option::kWatch);
  Viewer viewer_{title_of(request_), request_.speed, interrupt_, console_};
  std::string outcome_;
  std::unique_ptr<ResultsWriter> store_;
  PortableNames names_;  // of the store
  Recording recording_;
  std::optional<PlanCoverage> coverage_;
  std::optional<TraceFile> trace_file_;
  TestTrace trace_;
};

}  // namespace

ExitCode run_scenario_file(const std::string& path, const Arguments& arguments, Console& console) {
  const auto request = read_request(path, arguments, console);
  return request ? ScenarioRun(*request, arguments, console).run() : ExitCode::usage;
}

}  // namespace jaywalk
