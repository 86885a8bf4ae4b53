#include "search/store/search_store.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/results/store/database.h"
#include "experiment/results/store/store_file.h"
#include "experiment/results/store/store_tables.h"
#include "experiment/results/store/stored_inputs.h"

namespace jaywalk::search {
namespace {

using Json = nlohmann::json;

/// The format's application id, "GPKG", and version (OGC 12-128r17, requirement 2), and the tables
/// that every GeoPackage has. Coordinates are metres of no place on earth: srs -1.
constexpr std::string_view kGeoPackage = R"(
PRAGMA application_id = 0x47504B47;
PRAGMA user_version = 10300;
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL, srs_id INTEGER PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
INSERT INTO gpkg_spatial_ref_sys VALUES
  ('Undefined Cartesian', -1, 'NONE', -1, 'undefined', 'metres'),
  ('Undefined geographic', 0, 'NONE', 0, 'undefined', NULL),
  ('WGS 84', 4326, 'EPSG', 4326,
   'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
   || 'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]', NULL);
CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE,
  description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ', 'now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE,
  srs_id INTEGER REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL,
  PRIMARY KEY (table_name, column_name), UNIQUE (table_name));
)";

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
  simulated_s DOUBLE NOT NULL, measures TEXT NOT NULL, signature TEXT NOT NULL, fitness DOUBLE NOT NULL,
  failed INTEGER NOT NULL, candidates INTEGER NOT NULL, invalid INTEGER NOT NULL,
  generation_s DOUBLE NOT NULL, execution_s DOUBLE NOT NULL, UNIQUE (run, number));
INSERT INTO gpkg_contents (table_name, data_type, identifier, description, srs_id) VALUES
  ('search_experiment', 'attributes', 'search_experiment', 'what was searched', NULL),
  ('inputs', 'attributes', 'inputs', 'every file that the tests were made from', NULL),
  ('search_runs', 'attributes', 'search_runs', 'one generator, one repetition', NULL),
  ('search_tests', 'features', 'search_tests', 'executed tests; failing roads as lines', -1);
INSERT INTO gpkg_geometry_columns VALUES ('search_tests', 'geom', 'LINESTRING', -1, 0, 0);
)";

template <class T>
void append(std::vector<unsigned char>& bytes, T value) {
  std::array<unsigned char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// A GeoPackage line: header without an envelope, little endian, then well-known binary.
std::vector<unsigned char> line_string(const std::vector<double>& xy) {
  std::vector<unsigned char> bytes{'G', 'P', 0, 1};
  append<std::int32_t>(bytes, -1);
  bytes.push_back(1);
  append<std::uint32_t>(bytes, 2);
  append<std::uint32_t>(bytes, static_cast<std::uint32_t>(xy.size() / 2));
  for (const double value : xy) append(bytes, value);
  return bytes;
}

/// A list of finite numbers; nothing if the text is none.
std::optional<std::vector<double>> parse_numbers(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  std::vector<double> numbers;
  for (const Json& each : json) {
    // As JSON has it, `null` stands for what is infinite.
    if (!each.is_number() && !each.is_null()) return std::nullopt;
    numbers.push_back(each.is_null() ? 0 : each.get<double>());
    if (!std::isfinite(numbers.back())) return std::nullopt;
  }
  return numbers;
}

void create_tables(Database& database) {
  database.execute(std::string(kGeoPackage));
  database.execute(std::string(kTables));
  database.execute(std::string(kInputsTable));
}

/// Why the file is no store of searches that can be read.
std::optional<std::string> objection(const std::string& path) {
  if (auto why = why_no_store_file(path)) return why;
  Database database(path, Database::Mode::read);
  const bool ours =
      database.number("SELECT 1 FROM sqlite_master WHERE name = 'search_experiment'") == 1;
  if (database.failure()) return trouble_with(database);
  if (!ours) return "is no store of searches";
  auto why = foreign_object(database, create_tables);
  if (!why) why = table_difference(database, create_tables);
  if (database.failure()) return trouble_with(database);
  return why;
}

Diagnostics wrong(const std::string& path, std::string message, std::string hint = {}) {
  Diagnostics diagnostics;
  diagnostics.error(path, std::move(message), std::move(hint));
  return diagnostics;
}

constexpr std::string_view kRows =
    "SELECT run, form, input, error, simulated_s, measures, fitness, failed, candidates, invalid, "
    "generation_s, execution_s, signature FROM search_tests ORDER BY run, number";

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
  row.test.outcome = {rows.text(3), rows.real(4), std::move(*measures), std::move(*signature)};
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

class Store : public SearchStore {
 public:
  Store(const std::string& path, const SearchExperiment& experiment, bool exists)
      : database_(path, exists ? Database::Mode::write : Database::Mode::create),
        plan_(experiment.plan),
        finished_(experiment.plan.searches()) {
    if (!exists) create(experiment);
  }

  [[nodiscard]] std::optional<std::string> failure() const { return database_.failure(); }

  /// Why the store does not belong to the experiment; empty if it does.
  std::string read(const SearchExperiment& experiment) {
    database_.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
    const auto origin = database_.text("SELECT origin FROM search_experiment");
    const auto seed = database_.text("SELECT seed FROM search_experiment");
    if (database_.failure() || !origin || !seed) return "is no store of searches";
    if (*origin != experiment.origin || *seed != std::to_string(plan_.seed) ||
        database_.number("SELECT repetitions FROM search_experiment") !=
            std::int64_t{plan_.repetitions}) {
      return "holds another experiment";
    }
    if (std::string why = changed_input(experiment); !why.empty()) return why;
    Statement rows(database_, kRows);
    while (rows.step()) {
      const auto run = rows.integer<std::size_t>(0);
      if (run >= finished_.size()) return "is damaged";
      auto row = read_row(rows, plan_.model_of(plan_.generators[run / plan_.repetitions]));
      if (!row) return "is damaged";
      finished_[run].push_back(std::move(*row));
      ++had_;
    }
    return database_.failure().value_or("");
  }

  [[nodiscard]] const std::vector<TestRow>& finished(std::size_t search) const override {
    return finished_[search];
  }
  [[nodiscard]] std::size_t had() const override { return had_; }

  std::string add(std::size_t search, std::size_t number, const TestRow& row) override {
    const std::scoped_lock lock(mutex_);
    if (!insert_) {
      insert_ = std::make_unique<Statement>(
          database_,
          "INSERT INTO search_tests (geom, run, number, form, input, error, simulated_s, measures, "
          "fitness, failed, candidates, invalid, generation_s, execution_s, signature) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    }
    const ExecutedTest& test = row.test;
    std::vector<unsigned char> line;
    std::optional<Blob> geometry;
    if (test.failed) {
      const SutModel& model = plan_.model_of(plan_.generators[search / plan_.repetitions]);
      const TestInput points = model.space().as_points(test.input);
      if (model.road_space() != nullptr) line = line_string(points.values);
      if (!line.empty()) geometry = Blob{line};
    }
    insert_->run(geometry, static_cast<std::uint64_t>(search), static_cast<std::uint64_t>(number),
                 name(test.input.form), Json(test.input.values).dump(), test.outcome.error,
                 test.outcome.simulated_s, Json(test.outcome.measures).dump(), test.fitness,
                 test.failed ? 1 : 0, row.candidates, row.invalid, row.generation_s,
                 row.execution_s, Json(test.outcome.signature).dump());
    return database_.failure().value_or("");
  }

  std::string finish(const SearchResults& results) override {
    insert_.reset();
    for (std::size_t i = 0; i < results.runs.size(); ++i) {
      database_.execute(fmt::format("UPDATE search_runs SET complete = {} WHERE id = {}",
                                    results.runs[i].complete ? 1 : 0, i));
    }
    database_.execute("PRAGMA journal_mode = DELETE");
    return database_.failure().value_or("");
  }

 private:
  /// Files may have other names now: the folder may have been moved.
  std::string changed_input(const SearchExperiment& experiment) {
    const std::vector<StoredInput> before = read_inputs(database_);
    const std::vector<StoredInput> now = stored_inputs(experiment.inputs);
    if (before.size() != now.size()) return "holds another experiment";
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (before[i].sha256 == now[i].sha256) continue;
      return fmt::format("holds tests that were made from another text of '{}'", now[i].path);
    }
    return {};
  }

  void create(const SearchExperiment& experiment) {
    database_.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
    database_.execute("BEGIN");
    create_tables(database_);
    Statement(database_, "INSERT INTO search_experiment VALUES (1, ?, ?, ?, ?, ?, ?, ?)")
        .run(experiment.name, experiment.origin, experiment.sut, experiment.measure,
             plan_.fitness.fails_at, std::to_string(plan_.seed), plan_.repetitions);
    write_inputs(database_, stored_inputs(experiment.inputs));
    Statement insert(database_, "INSERT INTO search_runs VALUES (?, ?, ?, 0)");
    std::uint64_t id = 0;
    for (const GeneratorSpec& generator : plan_.generators) {
      for (std::uint32_t repetition = 0; repetition < plan_.repetitions; ++repetition) {
        insert.run(id++, generator.name, repetition);
      }
    }
    database_.execute("COMMIT");
  }

  Database database_;
  const SearchPlan& plan_;
  std::vector<std::vector<TestRow>> finished_;
  std::size_t had_ = 0;
  std::mutex mutex_;
  std::unique_ptr<Statement> insert_;
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

bool is_search_store(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  Database database(path, Database::Mode::read);
  return database.number("SELECT 1 FROM sqlite_master WHERE name = 'search_experiment'") == 1;
}

Result<StoredSearches> read_search_store(const std::string& path) {
  if (auto why = objection(path)) return wrong(path, std::move(*why));
  Database database(path, Database::Mode::read);
  const auto name = database.text("SELECT name FROM search_experiment");
  auto origin = database.text("SELECT origin FROM search_experiment");
  const auto seed = database.text("SELECT seed FROM search_experiment");
  const auto repetitions = database.number("SELECT repetitions FROM search_experiment");
  if (database.failure() || !name || !origin || !seed || !repetitions) {
    return wrong(path, database.failure().value_or("is no store of searches"));
  }
  const std::vector<StoredInput> inputs = read_inputs(database);
  if (auto why = database.failure()) return wrong(path, std::move(*why));
  if (auto why = damage_of(inputs)) return wrong(path, std::move(*why));
  SearchOptions options = options_in(*origin);
  options.files = copies_of(inputs);
  // Whoever made the store chose what the experiment names: nothing of it is run.
  options.sut_check = SutCheck::omitted;
  auto experiment = parse_search(std::make_shared<const Source>(*name, *origin), options);
  if (!experiment) return std::move(experiment.diagnostics());
  StoredSearches stored{.experiment = std::move(experiment).value(), .results = {}};
  SearchPlan& plan = stored.experiment.plan;
  plan.seed = std::strtoull(seed->c_str(), nullptr, 10);
  if (*repetitions < 1 || *repetitions > kMostRepetitions) return wrong(path, "is damaged");
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
      return wrong(path, "is damaged");
    }
  }
  Statement rows(database, kRows);
  while (rows.step()) {
    const auto run = rows.integer<std::size_t>(0);
    if (run >= stored.results.runs.size()) return wrong(path, "is damaged");
    auto row = read_row(rows, plan.model_of(plan.generators[run / plan.repetitions]));
    if (!row) return wrong(path, "is damaged");
    stored.results.runs[run].tests.push_back(std::move(*row));
  }
  if (database.failure()) return wrong(path, *database.failure());
  return stored;
}

Result<std::unique_ptr<SearchStore>> SearchStore::open(const std::string& path, Mode mode,
                                                       const SearchExperiment& experiment) {
  std::error_code error;
  const bool exists = std::filesystem::exists(path, error);
  if (exists && mode == Mode::create) {
    return wrong(path, "the file exists", "--resume goes on with it");
  }
  if (exists) {
    if (auto why = objection(path)) return wrong(path, std::move(*why));
  }
  auto store = std::make_unique<Store>(path, experiment, exists);
  if (const auto why = store->failure()) return wrong(path, *why);
  if (exists) {
    if (std::string why = store->read(experiment); !why.empty()) {
      return wrong(path, std::move(why),
                   "the experiment, its options and the seed must be the same as before");
    }
  }
  return std::unique_ptr<SearchStore>(std::move(store));
}

}  // namespace jaywalk::search
