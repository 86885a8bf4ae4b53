// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/reader.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "env/config/reader.h"
#include "experiment/compare/avs/av_ranking.h"
#include "experiment/compare/kills/kills.h"
#include "experiment/compare/per_test.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/store/store_file.h"
#include "experiment/results/stored_rows.h"
#include "experiment/test_run/covered_bins.h"
#include "experiment/test_run/tested_vehicles.h"

namespace jaywalk {
namespace {

/// Less than the greatest speed of an AV, in cells per tick.
constexpr std::int64_t kMostHeadStart = 9'999;

/// The command that its tests start, of the AV, its twin or its simulator; empty: none.
std::string command_of(const Scenario& scenario) {
  return fmt::format("{}", fmt::join(scenario.world->command(), " "));
}

}  // namespace

class ResultsReader::Impl {
 public:
  Impl(std::string path, Commands commands, DescribedStore store)
      : path_(std::move(path)),
        commands_(commands),
        database_(std::move(store.database)),
        description_(std::move(store.description)) {
    count_ =
        static_cast<std::uint64_t>(database_->number("SELECT count(*) FROM tests").value_or(0));
  }

  [[nodiscard]] Database& database() { return *database_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const ExperimentDescription& description() const { return description_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }

  /// The value, unless reading it failed.
  template <class T>
  Result<T> checked(T value) {
    if (database_->failure()) return store_error(path_, trouble_with(*database_));
    return value;
  }

  [[nodiscard]] std::optional<Diagnostics> failure() const {
    if (database_->failure()) return store_error(path_, trouble_with(*database_));
    return std::nullopt;
  }

  /// The test of that id; if the plan has none, reading has failed.
  std::optional<TestKey> planned(std::int64_t id) {
    auto test = find_test(description_, id);
    if (!test) database_->fail(fmt::format("the store is damaged: it has a test {}", id));
    return test;
  }

  void stop_when(std::function<bool()> stopped) {
    stopped_ = std::move(stopped);
    database_->stop_when(stopped_);
  }
  [[nodiscard]] const std::function<bool()>& stopped() const { return stopped_; }

  [[nodiscard]] Commands commands() const { return commands_; }

  Result<std::shared_ptr<const PreparedScenario>> prepare() {
    if (prepared_) return prepared_;
    auto scenario =
        read_scenario(description_.scenario, {.preset = description_.preset,
                                              .sets = description_.sets,
                                              .behaviours = description_.behaviour_options,
                                              .files = copies_of(description_.inputs),
                                              .include = description_.include});
    if (!scenario) return std::move(scenario.diagnostics());
    Diagnostics warnings;  // were shown when the tests ran
    auto prepared = PreparedScenario::prepare(std::move(scenario).value(), warnings);
    if (prepared) prepared_ = prepared.value();
    return prepared;
  }

 private:
  std::string path_;
  Commands commands_;
  std::unique_ptr<Database> database_;
  ExperimentDescription description_;
  std::uint64_t count_ = 0;
  std::function<bool()> stopped_;
  std::shared_ptr<const PreparedScenario> prepared_;
};

ResultsReader::ResultsReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsReader::~ResultsReader() = default;

Result<std::unique_ptr<ResultsReader>> ResultsReader::open(const std::string& path,
                                                           Commands commands) {
  auto store = described(open_to_read(path, results_store(), Scrutiny::header), path);
  if (!store) return std::move(store.diagnostics());
  auto impl = std::make_unique<Impl>(path, commands, std::move(store).value());
  if (impl->database().failure()) return store_error(path, trouble_with(impl->database()));
  return std::unique_ptr<ResultsReader>(new ResultsReader(std::move(impl)));
}

void ResultsReader::stop_when(std::function<bool()> stopped) {
  impl_->stop_when(std::move(stopped));
}
const std::string& ResultsReader::path() const { return impl_->path(); }
const ExperimentDescription& ResultsReader::description() const { return impl_->description(); }
std::uint64_t ResultsReader::count() const { return impl_->count(); }

bool ResultsReader::complete() const {
  const ExperimentDescription& plan = description();
  return count() == cells(plan) * tests_in_shard(plan);
}

Result<std::vector<StoredTest>> ResultsReader::tests(const TestFilter& filter) const {
  std::vector<StoredTest> tests;
  auto failure = for_each_test(filter, [&](const StoredTest& each) {
    tests.push_back(each);
    return Proceed::yes;
  });
  if (failure) return std::move(*failure);
  return tests;
}

Result<std::uint64_t> ResultsReader::count(const TestFilter& filter) const {
  std::uint64_t count = 0;
  auto failure = for_each_test(filter, [&](const StoredTest&) {
    ++count;
    return Proceed::yes;
  });
  if (failure) return std::move(*failure);
  return count;
}

std::optional<Diagnostics> ResultsReader::for_each_test(
    const TestFilter& filter, const std::function<Proceed(const StoredTest&)>& callback) const {
  read_tests(impl_->database(), description(), filter, callback);
  return impl_->failure();
}

Result<StoredTest> ResultsReader::test(std::int64_t id) const {
  auto found = impl_->checked(read_test(impl_->database(), description(), id));
  if (!found) return std::move(found.diagnostics());
  if (found.value()) return *found.value();
  const std::uint64_t planned = cells(description()) * description().tests;
  return store_error(path(), fmt::format("the store has no test {}", id),
                     fmt::format("it has {} of the tests 1 to {}", count(), planned));
}

Result<std::vector<AgentScore>> ResultsReader::scores(std::int64_t id) const {
  return impl_->checked(read_scores(impl_->database(), id));
}

Result<std::vector<AssessmentRow>> ResultsReader::assessments(std::int64_t id) const {
  return impl_->checked(read_assessments(impl_->database(), id));
}

Result<std::vector<Actor>> ResultsReader::actors(std::int64_t id) const {
  return impl_->checked(read_actors(impl_->database(), id));
}

Result<std::vector<std::string>> ResultsReader::assertion_ids() const {
  return impl_->checked(read_assertion_ids(impl_->database()));
}

std::optional<Diagnostics> ResultsReader::for_each_place(
    std::string_view kind,
    const std::function<void(const TestKey& test, double x_m, double y_m)>& callback) const {
  read_places(impl_->database(), kind, [&](std::int64_t id, double x_m, double y_m) {
    if (const auto test = impl_->planned(id)) callback(*test, x_m, y_m);
  });
  return impl_->failure();
}

std::optional<Diagnostics> ResultsReader::for_each_assessed(
    const std::function<void(const TestKey& test, const std::vector<AssessmentRow>& assessments)>&
        callback) const {
  read_all_assessments(impl_->database(), [&](std::int64_t id, const auto& assessments) {
    if (const auto test = impl_->planned(id)) callback(*test, assessments);
  });
  return impl_->failure();
}

Result<Recording> ResultsReader::recording(std::int64_t id) const {
  auto stored = test(id);
  if (!stored) return std::move(stored.diagnostics());
  if (stored.value().scenes > 0) {
    return impl_->checked(read_recording(impl_->database(), description().tick_s, stored.value()));
  }
  Recording recording;
  auto result = rerun(id, {.record = &recording});
  if (!result) return std::move(result.diagnostics());
  return recording;
}

Result<std::string> ResultsReader::error(std::int64_t id) const {
  return impl_->checked(read_event(impl_->database(), id, kErrored));
}

Result<std::shared_ptr<const PreparedScenario>> ResultsReader::prepared() const {
  return impl_->prepare();
}

Result<std::vector<Assertion>> ResultsReader::assertions() const {
  if (description().assertion_files.empty()) {
    auto scenario = prepared();
    if (!scenario) return std::move(scenario.diagnostics());
    return scenario.value()->scenario().assertions;
  }
  auto files = read_assertion_files(description().assertion_files,
                                    copies_of(impl_->description().inputs), SameId::replaced);
  if (!files) return std::move(files.diagnostics());
  return std::move(files).value().assertions;
}

Result<TestSetup> ResultsReader::setup(std::int64_t id) const {
  auto stored = test(id);
  if (!stored) return std::move(stored.diagnostics());
  const TestKey& wanted = stored.value().test;
  auto scenario = prepared();
  if (!scenario) return std::move(scenario.diagnostics());
  const auto vehicle = find_vehicle(*scenario.value(), description().vehicles[wanted.vehicle]);
  if (!vehicle) {
    return store_error(path(), fmt::format("its scenario has no vehicle '{}'",
                                           description().vehicles[wanted.vehicle]));
  }
  const std::string command = command_of(scenario.value()->scenario());
  if (impl_->commands() == Commands::refused && !command.empty()) {
    return store_error(path(), fmt::format("to run its tests again it starts '{}'", command),
                       "--allow-commands lets it; whoever made the store chose the command");
  }
  // The beliefs that the test received from earlier tests were stored with it, so that it can run
  // alone.
  const auto event = impl_->checked(read_event(impl_->database(), id, "feedback"));
  if (!event) return event.diagnostics();
  const auto ahead = impl_->checked(read_event(impl_->database(), id, "head_start"));
  if (!ahead) return ahead.diagnostics();
  auto feedback = parse_feedback(event.value());
  const auto head_start = ahead.value().empty() ? 0 : parse_integer(ahead.value());
  if (!feedback || !head_start || *head_start < 0 || *head_start > kMostHeadStart) {
    return store_error(path(), fmt::format("test {} has a damaged event", id));
  }
  return TestSetup{.behaviour = wanted.behaviour,
                   .agents = wanted.agents,
                   .seed = description().seed,
                   .test = wanted.number,
                   .feedback = std::move(*feedback),
                   .head_start = static_cast<int>(*head_start),
                   .vehicle = *vehicle};
}

Result<TestRun> ResultsReader::rerun(std::int64_t id, const TestOptions& options) const {
  auto stored = test(id);
  if (!stored) return std::move(stored.diagnostics());
  auto scenario = prepared();
  if (!scenario) return std::move(scenario.diagnostics());
  auto again = setup(id);
  if (!again) return std::move(again.diagnostics());
  if (const std::string why = problem(*scenario.value(), again.value()); !why.empty()) {
    return store_error(path(), why);
  }
  TestOptions stoppable = options;
  if (!stoppable.interrupted) stoppable.interrupted = impl_->stopped();
  TestRun result = run_test(*scenario.value(), again.value(), stoppable);
  if (result.interrupted) return store_error(path(), "interrupted");
  const TestResult& wanted = stored.value().result;
  // Bit for bit: the same version with the same inputs gives the same numbers. Of an errored test
  // only that it errs again counts, since a limit of time depends on the machine.
  const bool same = wanted.errored
                        ? !result.completed
                        : result.completed && result.outcome.success == wanted.succeeded &&
                              static_cast<std::uint32_t>(result.outcome.ticks) == wanted.ticks &&
                              result.outcome.score() == wanted.score;
  if (same) return result;
  return store_error(
      path(), fmt::format("test {} came out otherwise than stored", id),
      fmt::format("jaywalk {} stored it, this is {}", description().version, JAYWALK_VERSION));
}

std::optional<Diagnostics> ResultsReader::add_assessments(Comparison& comparison) const {
  auto ids = assertion_ids();
  if (!ids) return std::move(ids.diagnostics());
  const ExperimentPlan plan = plan_of(description());
  Criteria criteria;
  // The table only needs their number: the verdicts are stored, nothing is judged again.
  criteria.assertions.resize(ids.value().size());
  AssessmentTable table(criteria, plan);
  KillTable kills(plan, tests_in_shard(description()));
  bool any = false;
  auto failure = for_each_assessed([&](TestKey test, const std::vector<AssessmentRow>& rows) {
    // A shard's tests are numbered within the whole plan, the tables of this store from 0.
    any = true;
    test.number -= description().first_test;
    kills.add(test, blames_the_av(rows));
    if (test.vehicle == 0) table.add(test, from_rows(rows, ids.value()));
  });
  if (failure || !any) return failure;
  // Errored tests have no assessments, but the kill matrix counts them as not decided.
  failure = for_each_test({.vehicle = std::nullopt, .errored = true}, [&](const StoredTest& each) {
    TestKey test = each.test;
    test.number -= description().first_test;
    kills.add_errored(test);
    return Proceed::yes;
  });
  if (failure) return failure;
  comparison.kills = kills.matrix();
  comparison.assertions = std::move(ids).value();
  for (const Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(plan.behaviours, summary.behaviour);
    comparison.assessments.push_back(table.summary(
        static_cast<std::size_t>(behaviour - plan.behaviours.begin()), summary.agents));
  }
  return std::nullopt;
}

/// REQUIRES: the assessments are there.
std::optional<Diagnostics> ResultsReader::add_avs(Comparison& comparison) const {
  AvTable table(plan_of(description()), tests_in_shard(description()));
  if (!table.wanted()) return std::nullopt;
  std::optional<Diagnostics> trouble;
  auto failure = for_each_test({.vehicle = std::nullopt}, [&](const StoredTest& each) {
    TestKey test = each.test;
    test.number -= description().first_test;
    Blame blame = Blame::unknown;
    // Blame is about collisions alone, which are few: only their rows are read.
    if (each.outcome.impact_mps && !comparison.assertions.empty()) {
      const auto rows = assessments(each.id);
      if (!rows.ok()) {
        trouble = rows.diagnostics();
        return Proceed::no;
      }
      blame = blame_of(rows.value());
    }
    table.add(test, each.result, each.outcome.impact_mps, blame);
    return Proceed::yes;
  });
  if (trouble || failure) return trouble ? trouble : std::move(failure);
  comparison.avs = table.ranking(!comparison.assertions.empty());
  return std::nullopt;
}

/// Two passes over the tests, of which none is kept.
Result<Summary> ResultsReader::summary_of(std::size_t behaviour, std::uint32_t agents) const {
  const TestFilter cell{.behaviour = behaviour, .agents = agents};
  SummaryMaker maker;
  for (int pass = 0; pass < SummaryMaker::kPasses; ++pass) {
    auto failure = for_each_test(cell, [&](const StoredTest& each) {
      maker.add(each.result);
      return Proceed::yes;
    });
    if (failure) return std::move(*failure);
    maker.end_pass();
  }
  Summary summary = maker.summary();
  summary.behaviour = description().behaviours[behaviour].name;
  summary.agents = agents;
  summary.code_lines = description().behaviours[behaviour].code_lines;
  return summary;
}

Result<Comparison> ResultsReader::comparison() const {
  const ExperimentDescription& plan = description();
  Comparison comparison{.scenario = plan.scenario,
                        .seed = plan.seed,
                        .tests = tests_in_shard(plan),
                        .complete = complete()};
  for (std::size_t behaviour = 0; behaviour < plan.behaviours.size(); ++behaviour) {
    for (const std::uint32_t agents : plan.agents) {
      auto summary = summary_of(behaviour, agents);
      if (!summary) return std::move(summary.diagnostics());
      // A row of which tests are missing would be compared as if it were whole.
      if (summary.value().tests == 0 || summary.value().tests != tests_in_shard(plan)) continue;
      comparison.summaries.push_back(std::move(summary).value());
      const TestKey first{.behaviour = behaviour, .agents = agents, .number = plan.first_test};
      const std::int64_t id = test_id(plan, first);
      auto troubles = impl_->checked(
          read_troubles(impl_->database(), id, id + static_cast<std::int64_t>(plan.tests) - 1));
      if (!troubles) return std::move(troubles.diagnostics());
      comparison.troubles.push_back(std::move(troubles).value());
    }
  }
  if (auto failure = add_assessments(comparison)) return std::move(*failure);
  if (auto failure = add_avs(comparison)) return std::move(*failure);
  // A scenario that this version cannot read any more has no published figures beside it.
  if (const auto scenario = prepared()) comparison.published = published_rows(*scenario.value());
  return comparison;
}

std::optional<Diagnostics> write_per_test_table(const ResultsReader& store, const TextSink& sink) {
  auto ids = store.assertion_ids();
  if (!ids) return std::move(ids.diagnostics());
  const ExperimentDescription& description = store.description();
  const ExperimentPlan plan = plan_of(description);
  const PerTestLines lines(plan, ids.value());
  sink(lines.header());
  std::optional<Diagnostics> trouble;
  // In the order of their ids, which is that of the plan.
  auto failure = store.for_each_test({.vehicle = std::nullopt}, [&](const StoredTest& each) {
    std::vector<Verdict> verdicts;
    if (!each.result.errored && !ids.value().empty()) {
      const auto rows = store.assessments(each.id);
      if (!rows.ok()) {
        trouble = rows.diagnostics();
        return Proceed::no;
      }
      verdicts = verdicts_of(from_rows(rows.value(), ids.value()));
    }
    sink(lines.line(each.test, each.outcome, verdicts));
    return Proceed::yes;
  });
  return trouble ? trouble : std::move(failure);
}

}  // namespace jaywalk
