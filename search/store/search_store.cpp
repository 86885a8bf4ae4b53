// SPDX-License-Identifier: Apache-2.0
#include "search/store/search_store.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/results/store/database.h"
#include "experiment/results/store/geometry.h"
#include "experiment/results/store/geopackage.h"
#include "experiment/results/store/store_file.h"

namespace jaywalk::search {
namespace {

using Json = nlohmann::json;

/// Changes with the tables. A store of another version is refused.
constexpr std::int64_t kVersion = 2;

constexpr std::string_view kTables = R"(
CREATE TABLE search_experiment (
  id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL, origin TEXT NOT NULL, sut TEXT NOT NULL,
  measure TEXT NOT NULL, fails_at DOUBLE NOT NULL, seed TEXT NOT NULL,
  repetitions INTEGER NOT NULL);
CREATE TABLE search_runs (
  id INTEGER PRIMARY KEY NOT NULL, generator TEXT NOT NULL, repetition INTEGER NOT NULL,
  complete INTEGER NOT NULL);
CREATE TABLE search_tests (
  id INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL, geom LINESTRING, run INTEGER NOT NULL,
  number INTEGER NOT NULL, form TEXT NOT NULL, input TEXT NOT NULL, error TEXT NOT NULL,
  refused TEXT NOT NULL, simulated_s DOUBLE NOT NULL, measures TEXT NOT NULL,
  signature TEXT NOT NULL, fitness DOUBLE NOT NULL, failed INTEGER NOT NULL,
  candidates INTEGER NOT NULL, invalid INTEGER NOT NULL, generation_s DOUBLE NOT NULL,
  execution_s DOUBLE NOT NULL, UNIQUE (run, number));
)";

constexpr std::array kListed = {
    ListedTable{"search_experiment", "what was searched"},
    ListedTable{"search_runs", "one generator, one repetition"},
    ListedTable{"search_tests", "executed tests; failing roads as lines", "LINESTRING"},
};

void create_tables(Database& database) {
  create_geopackage(database, "metres");
  database.execute(std::string(kTables));
  list_tables(database, kListed, -1);
}

StoreKind search_store() {
  return {.name = "store of searches",
          .table = "search_experiment",
          .version = kVersion,
          .create = create_tables};
}

/// A list of finite numbers; nothing if the text is none.
std::optional<std::vector<double>> parse_numbers(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  std::vector<double> numbers;
  for (const Json& each : json) {
    // JSON has no infinity, so `null` stands for it.
    if (!each.is_number() && !each.is_null()) return std::nullopt;
    numbers.push_back(each.is_null() ? 0 : each.get<double>());
    if (!std::isfinite(numbers.back())) return std::nullopt;
  }
  return numbers;
}

constexpr std::string_view kDamaged = "the store is damaged: it has tests that its plan lacks";

constexpr std::string_view kRows =
    "SELECT run, form, input, error, simulated_s, measures, fitness, failed, candidates, invalid, "
    "generation_s, execution_s, signature, number, refused FROM search_tests ORDER BY run, number";

/// A test of a search with this SUT; nothing if it cannot be one.
std::optional<TestRow> read_row(const Statement& rows, const SutModel& model) {
  TestRow row;
  const auto form = parse_form(rows.text(1));
  auto input = parse_numbers(rows.text(2));
  auto measures = parse_numbers(rows.text(5));
  auto signature = parse_numbers(rows.text(12));
  if (!form || !input || !measures || !signature) return std::nullopt;
  row.test.input = {*form, std::move(*input)};
  if (!model.space().contains(row.test.input)) return std::nullopt;
  row.test.outcome = {rows.text(3), rows.real(4), std::move(*measures), std::move(*signature),
                      rows.text(14)};
  const bool measured = row.test.outcome.measures.size() == model.measures().size();
  if (row.test.outcome.executed() && !measured) return std::nullopt;
  row.test.fitness = rows.real(6);
  row.test.failed = rows.number(7) != 0;
  row.candidates = rows.integer<std::uint64_t>(8);
  row.invalid = rows.integer<std::uint64_t>(9);
  row.generation_s = rows.real(10);
  row.execution_s = rows.real(11);
  return row;
}

/// By search, as TestLog::finished() numbers them.
using FinishedTests = std::vector<std::vector<TestRow>>;

/// Nothing if a test has another number than it should, or is not of the plan.
std::optional<FinishedTests> read_finished(Database& database, const SearchPlan& plan) {
  FinishedTests finished(plan.searches());
  Statement rows(database, kRows);
  while (rows.step()) {
    const auto run = rows.integer<std::size_t>(0);
    if (run >= finished.size()) return std::nullopt;
    auto row = read_row(rows, plan.model_of(plan.generators[run / plan.repetitions]));
    if (!row || rows.integer<std::size_t>(13) != finished[run].size()) return std::nullopt;
    finished[run].push_back(std::move(*row));
  }
  return finished;
}

/// The error that prevents this experiment from continuing the store. Its files may have other
/// names now: the folder may have been moved.
std::optional<std::string> mismatch(Database& database, const SearchExperiment& experiment) {
  const auto origin = database.text("SELECT origin FROM search_experiment");
  const auto seed = database.text("SELECT seed FROM search_experiment");
  const auto repetitions = database.number("SELECT repetitions FROM search_experiment");
  const std::vector<StoredInput> before = read_inputs(database);
  const std::vector<StoredInput> now = stored_inputs(experiment.inputs);
  if (origin != experiment.origin || seed != std::to_string(experiment.plan.seed) ||
      repetitions != std::int64_t{experiment.plan.repetitions} || before.size() != now.size()) {
    return "the store holds another experiment";
  }
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (before[i].sha256 == now[i].sha256) continue;
    return fmt::format("the store holds tests that were made from another text of '{}'",
                       now[i].path);
  }
  return std::nullopt;
}

void write_experiment(Database& database, const SearchExperiment& experiment) {
  const SearchPlan& plan = experiment.plan;
  write_versions(database, kVersion, JAYWALK_VERSION);
  Statement(database, "INSERT INTO search_experiment VALUES (1, ?, ?, ?, ?, ?, ?, ?)")
      .run(experiment.name, experiment.origin, experiment.sut, experiment.measure,
           plan.fitness.fails_at, std::to_string(plan.seed), plan.repetitions);
  write_inputs(database, stored_inputs(experiment.inputs));
  Statement insert(database, "INSERT INTO search_runs VALUES (?, ?, ?, 0)");
  std::uint64_t id = 0;
  for (const GeneratorSpec& generator : plan.generators) {
    for (std::uint32_t repetition = 0; repetition < plan.repetitions; ++repetition) {
      insert.run(id++, generator.name, repetition);
    }
  }
}

class Store : public SearchStore {
 public:
  Store(std::string path, std::unique_ptr<Database> database, const SearchPlan& plan,
        FinishedTests finished)
      : path_(std::move(path)),
        database_(std::move(database)),
        plan_(plan),
        finished_(std::move(finished)),
        insert_(*database_,
                "INSERT INTO search_tests (geom, run, number, form, input, error, simulated_s, "
                "measures, fitness, failed, candidates, invalid, generation_s, execution_s, "
                "signature, refused) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)") {
    for (const std::vector<TestRow>& tests : finished_) had_ += tests.size();
  }

  [[nodiscard]] const std::vector<TestRow>& finished(std::size_t search) const override {
    return finished_[search];
  }
  [[nodiscard]] std::size_t had() const override { return had_; }

  Continue add(std::size_t search, std::size_t number, const TestRow& row) override {
    const std::scoped_lock lock(mutex_);
    const ExecutedTest& test = row.test;
    std::vector<unsigned char> line;
    std::optional<Blob> geometry;
    if (test.failed) {
      const SutModel& model = plan_.model_of(plan_.generators[search / plan_.repetitions]);
      const TestInput points = model.space().as_points(test.input);
      if (model.road_space() != nullptr) line = line_blob(points.values);
      if (!line.empty()) geometry = Blob{line};
    }
    insert_.run(geometry, static_cast<std::uint64_t>(search), static_cast<std::uint64_t>(number),
                name(test.input.form), Json(test.input.values).dump(), test.outcome.error,
                test.outcome.simulated_s, Json(test.outcome.measures).dump(), test.fitness,
                test.failed ? 1 : 0, row.candidates, row.invalid, row.generation_s, row.execution_s,
                Json(test.outcome.signature).dump(), test.outcome.refused);
    return database_->failure() ? Continue::no : Continue::yes;
  }

  std::optional<std::string> finish(const SearchResults& results) override {
    for (std::size_t i = 0; i < results.runs.size(); ++i) {
      database_->execute(fmt::format("UPDATE search_runs SET complete = {} WHERE id = {}",
                                     results.runs[i].complete ? 1 : 0, i));
    }
    return finish_log(*database_, path_);
  }

 private:
  std::string path_;
  std::unique_ptr<Database> database_;
  const SearchPlan& plan_;
  FinishedTests finished_;
  std::size_t had_ = 0;
  std::mutex mutex_;  // guards the database
  Statement insert_;
};

/// The options that follow the experiment's text (experiment.cpp puts them there).
SearchOptions options_in(std::string& origin) {
  SearchOptions options;
  constexpr std::string_view kSet = "--set ";
  constexpr std::string_view kGenerators = "--generators ";
  while (true) {
    const std::size_t line = origin.rfind('\n');
    if (line == std::string::npos) break;
    const std::string_view last = std::string_view(origin).substr(line + 1);
    if (last.starts_with(kSet)) {
      options.sets.emplace(options.sets.begin(), last.substr(kSet.size()));
    } else if (last.starts_with(kGenerators)) {
      options.generators.emplace(options.generators.begin(), last.substr(kGenerators.size()));
    } else {
      break;
    }
    origin.resize(line);
  }
  return options;
}

}  // namespace

bool is_search_store(const std::string& path) { return is_store(path, search_store()); }

Result<StoredSearches> read_search_store(const std::string& path) {
  auto opened = open_to_read(path, search_store(), Scrutiny::header);
  if (!opened) return std::move(opened.diagnostics());
  Database& database = *opened.value();
  const auto damaged = [&] { return store_error(path, std::string(kDamaged)); };
  const auto name = database.text("SELECT name FROM search_experiment");
  auto origin = database.text("SELECT origin FROM search_experiment");
  const auto seed = database.text("SELECT seed FROM search_experiment");
  const auto repetitions = database.number("SELECT repetitions FROM search_experiment");
  const std::vector<StoredInput> inputs = read_inputs(database);
  if (database.failure()) return store_error(path, trouble_with(database));
  if (!name || !origin || !seed || !repetitions) return damaged();
  if (auto why = damage_of(inputs)) return store_error(path, std::move(*why));
  SearchOptions options = options_in(*origin);
  options.files = copies_of(inputs);
  // The store's author chose the commands that the experiment names: none of them is run.
  options.sut_check = SutCheck::omitted;
  auto experiment = parse_search(std::make_shared<const Source>(*name, *origin), options);
  if (!experiment) return std::move(experiment.diagnostics());
  StoredSearches stored{.experiment = std::move(experiment).value(), .results = {}};
  SearchPlan& plan = stored.experiment.plan;
  plan.seed = std::strtoull(seed->c_str(), nullptr, 10);
  if (*repetitions < 1 || *repetitions > kMostRepetitions) return damaged();
  plan.repetitions = static_cast<std::uint32_t>(*repetitions);
  stored.results.complete = true;
  Statement runs(database, "SELECT generator, repetition, complete FROM search_runs ORDER BY id");
  while (runs.step()) {
    stored.results.runs.push_back({.generator = runs.text(0),
                                   .repetition = runs.integer<std::uint32_t>(1),
                                   .complete = runs.number(2) != 0});
    stored.results.complete = stored.results.complete && runs.number(2) != 0;
    const std::size_t place = (stored.results.runs.size() - 1) / plan.repetitions;
    if (place >= plan.generators.size() ||
        plan.generators[place].name != stored.results.runs.back().generator) {
      return damaged();
    }
  }
  auto finished = read_finished(database, plan);
  if (database.failure()) return store_error(path, trouble_with(database));
  if (!finished || stored.results.runs.size() != finished->size()) return damaged();
  for (std::size_t run = 0; run < finished->size(); ++run) {
    stored.results.runs[run].tests = std::move((*finished)[run]);
  }
  return stored;
}

Result<std::unique_ptr<SearchStore>> SearchStore::open(const std::string& path, Mode mode,
                                                       const SearchExperiment& experiment) {
  std::error_code error;
  const bool exists = std::filesystem::exists(std::filesystem::symlink_status(path, error));
  if (exists && mode == Mode::create) {
    return store_error(path, "the file exists",
                       "--resume continues a store; otherwise choose another name");
  }
  if (!exists) {
    const auto fill = [&](Database& database) {
      create_tables(database);
      write_experiment(database, experiment);
    };
    if (auto failure = create_store_file(path, fill)) return std::move(*failure);
  }
  auto opened = open_to_write(path, search_store());
  if (!opened) return std::move(opened.diagnostics());
  Database& database = *opened.value();
  if (auto why = mismatch(database, experiment); why && !database.failure()) {
    return store_error(path, std::move(*why),
                       "the experiment, its options and the seed must be the same as before");
  }
  auto finished = read_finished(database, experiment.plan);
  if (!finished) database.fail(std::string(kDamaged));
  start_log(database);
  if (database.failure()) return store_error(path, trouble_with(database));
  return std::unique_ptr<SearchStore>(std::make_unique<Store>(
      path, std::move(opened).value(), experiment.plan, std::move(*finished)));
}

}  // namespace jaywalk::search
