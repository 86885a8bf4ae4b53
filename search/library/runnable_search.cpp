// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include <fmt/format.h>

#include "experiment/library/library.h"
#include "experiment/scenario/number_list.h"
#include "search/library/custom.h"
#include "search/search_experiment.h"
#include "search/store/search_store.h"
#include <jaywalk/search.h>

namespace jaywalk::search {

struct RunnableSearch::Parts {
  SearchExperiment experiment;
  bool is_from_file = true;
  // The plan refers to these, if a program has described it.
  std::vector<CustomGenerator> generators;
  std::deque<GeneratorKind> kinds;
};

namespace {

SearchOptions options_of(const SearchChoice& choice) {
  return {.sets = choice.sets,
          .defects = {},
          .generators = choice.generators,
          .files = readable_files(choice.data_folder, choice.folders),
          .include = {choice.folders.included, choice.folders.mapped}};
}

/// Mistakes of a description.
Diagnostics mistakes_in(const SearchDescription& described) {
  Diagnostics found;
  const auto add = [&](std::string message) { found.error(described.name, std::move(message)); };
  if (described.system.dimension == 0) add("the system's inputs have no numbers");
  if (!described.system.make_executor) add("the system has no executor");
  if (std::ranges::count(described.system.measures, described.measure) != 1) {
    add(fmt::format("'{}' is not one of the system's measures", described.measure));
  }
  if (!std::isfinite(described.harmless) || !std::isfinite(described.worst)) {
    add("'harmless' or 'worst' is not a number");
  } else if (described.harmless == described.worst) {
    add("'harmless' and 'worst' are the same value");
  }
  // Not a number is outside each of the ranges.
  if (!(described.fails_at > 0 && described.fails_at <= 1)) {
    add(fmt::format("fails_at: expected above 0 and up to 1, found {}", described.fails_at));
  }
  if (!(described.overhead_s >= 0)) {
    add(fmt::format("overhead_s: expected 0 or more, found {}", described.overhead_s));
  }
  if (described.generators.empty() && described.custom_generators.empty()) {
    add("there is no generator");
  }
  for (const std::string& name : described.generators) {
    if (find_generator(name) == nullptr) add(fmt::format("there is no generator '{}'", name));
  }
  for (const CustomGenerator& each : described.custom_generators) {
    if (!each.make) add(fmt::format("nothing makes the generator '{}'", each.name));
  }
  if (!(described.virtual_s >= 0)) {
    add(fmt::format("virtual_s: expected 0 or more, found {}", described.virtual_s));
  } else if (described.tests == 0 && described.virtual_s == 0) {
    add("nothing bounds the number of tests");
  }
  return found;
}

GeneratorSpec spec_of(std::string name, const GeneratorKind& kind) {
  GeneratorSpec spec{.name = std::move(name), .kind = &kind, .values = {}};
  for (const NumberParameter& each : kind.parameters) spec.values.push_back(each.value);
  return spec;
}

FoundTest found_test(const TestRow& row, const SearchSpace& space) {
  const ExecutedTest& test = row.test;
  return {.input = test.input.values,
          .points = space.as_points(test.input).values,
          .fitness = test.fitness,
          .has_failed = test.failed,
          .error = test.outcome.error,
          .refused = test.outcome.refused,
          .measures = test.outcome.measures,
          .simulated_s = test.outcome.simulated_s};
}

SearchReport report_of(const SearchResults& results, const SearchPlan& plan) {
  SearchReport report{.runs = {}, .trouble = results.trouble, .is_complete = results.complete};
  for (std::size_t i = 0; i < results.runs.size(); ++i) {
    const SearchRun& run = results.runs[i];
    SearchRunReport& made = report.runs.emplace_back();
    made.generator = run.generator;
    made.repetition = run.repetition;
    made.spent_s = run.spent_s;
    made.is_complete = run.complete;
    const SearchSpace& space = plan.model_of(plan.generators[i / plan.repetitions]).space();
    for (const TestRow& row : run.tests) made.tests.push_back(found_test(row, space));
  }
  return report;
}

}  // namespace

std::vector<GeneratorInfo> generator_list() {
  std::vector<GeneratorInfo> list;
  for (const GeneratorKind& kind : generators()) list.push_back({kind.name, kind.summary});
  return list;
}

std::size_t SearchRunReport::failures() const {
  return static_cast<std::size_t>(std::ranges::count(tests, true, &FoundTest::has_failed));
}

Result<RunnableSearch> RunnableSearch::read(const std::string& path, const SearchChoice& choice) {
  auto experiment = read_search(path, options_of(choice));
  if (!experiment) return std::move(experiment.diagnostics());
  const auto parts = std::make_shared<Parts>();
  parts->experiment = std::move(experiment).value();
  return RunnableSearch(parts);
}

Result<RunnableSearch> RunnableSearch::parse(const std::string& name, std::string text,
                                             const SearchChoice& choice) {
  auto experiment =
      parse_search(std::make_shared<const Source>(name, std::move(text)), options_of(choice));
  if (!experiment) return std::move(experiment.diagnostics());
  const auto parts = std::make_shared<Parts>();
  parts->experiment = std::move(experiment).value();
  return RunnableSearch(parts);
}

Result<RunnableSearch> RunnableSearch::make(const SearchDescription& description) {
  if (Diagnostics mistakes = mistakes_in(description); mistakes.has_errors()) return mistakes;
  const auto parts = std::make_shared<Parts>();
  parts->is_from_file = false;
  parts->generators = description.custom_generators;
  SearchExperiment& experiment = parts->experiment;
  experiment.name = description.name;
  experiment.sut = description.system.name;
  experiment.measure = description.measure;
  SearchPlan& plan = experiment.plan;
  plan.model = model_of(description.system);
  plan.fitness = {.measure = *find_measure(plan.model->measures(), description.measure),
                  .harmless = description.harmless,
                  .worst = description.worst,
                  .fails_at = description.fails_at};
  plan.budget.tests = description.tests;
  plan.budget.virtual_s = description.virtual_s;
  plan.budget.overhead_s = description.overhead_s;
  for (const std::string& name : description.generators) {
    plan.generators.push_back(spec_of(name, *find_generator(name)));
  }
  for (const CustomGenerator& each : parts->generators) {
    plan.generators.push_back(spec_of(each.name, parts->kinds.emplace_back(kind_of(each))));
  }
  return RunnableSearch(parts);
}

const std::string& RunnableSearch::name() const { return parts_->experiment.name; }

std::vector<std::string> RunnableSearch::generators() const {
  std::vector<std::string> names;
  for (const GeneratorSpec& spec : parts_->experiment.plan.generators) names.push_back(spec.name);
  return names;
}

std::vector<std::string> RunnableSearch::measures() const {
  std::vector<std::string> names;
  for (const MeasureKind& kind : parts_->experiment.plan.model->measures()) {
    names.emplace_back(kind.name);
  }
  return names;
}

Result<SearchReport> RunnableSearch::run(const SearchRunOptions& options) const {
  SearchExperiment experiment = parts_->experiment;
  SearchPlan& plan = experiment.plan;
  plan.seed = options.seed.value_or(plan.seed);
  plan.repetitions = options.repetitions.value_or(plan.repetitions);
  plan.threads = options.threads;
  Diagnostics wrong;
  if (plan.repetitions == 0) wrong.error("repetitions", "expected 1 or more, found 0");
  if (plan.threads == 0 || plan.threads > kMaxThreads) {
    wrong.error("threads", fmt::format("expected 1 to {}, found {}", kMaxThreads, plan.threads));
  }
  if (options.resume && options.store.empty()) {
    wrong.error("resume", "there is no store to go on with");
  }
  if (!options.store.empty() && !parts_->is_from_file) {
    wrong.error(options.store, "a store keeps searches that were read from a file");
  }
  if (wrong.has_errors()) return wrong;
  std::unique_ptr<SearchStore> store;
  if (!options.store.empty()) {
    auto opened = SearchStore::open(
        options.store, options.resume ? SearchStore::Mode::resume : SearchStore::Mode::create,
        experiment);
    if (!opened) return std::move(opened.diagnostics());
    store = std::move(opened).value();
  }
  SearchObserver observer;
  observer.progress = [&](const SearchProgress& now) {
    const bool goes_on =
        !options.progress ||
        options.progress({.tests = now.tests, .failures = now.failures, .spent = now.spent});
    return goes_on ? Continue::yes : Continue::no;
  };
  const SearchResults results = run_searches(plan, store.get(), observer);
  if (store) {
    if (const auto failure = store->finish(results)) {
      Diagnostics trouble;
      trouble.error(options.store, *failure);
      return trouble;
    }
  }
  return report_of(results, plan);
}

}  // namespace jaywalk::search
