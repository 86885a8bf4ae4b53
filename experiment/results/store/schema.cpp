// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/schema.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "experiment/results/store/geopackage.h"

namespace jaywalk {
namespace {

constexpr std::string_view kResultsTables = R"sql(
CREATE TABLE experiment (
  id INTEGER PRIMARY KEY NOT NULL, scenario TEXT NOT NULL, seed INTEGER NOT NULL,
  first_test INTEGER NOT NULL, tests INTEGER NOT NULL, tick_s DOUBLE NOT NULL,
  level TEXT NOT NULL, shard INTEGER NOT NULL, shards INTEGER NOT NULL, epsg INTEGER,
  easting DOUBLE, northing DOUBLE, bearing DOUBLE);
CREATE TABLE options (
  id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL);
CREATE TABLE behaviours (
  id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL UNIQUE,
  code_lines INTEGER NOT NULL);
CREATE TABLE parameters (
  id INTEGER PRIMARY KEY NOT NULL, behaviour TEXT NOT NULL, name TEXT NOT NULL,
  value TEXT NOT NULL);
CREATE TABLE agent_numbers (
  id INTEGER PRIMARY KEY NOT NULL, agents INTEGER NOT NULL UNIQUE);
CREATE TABLE vehicles (
  id INTEGER PRIMARY KEY NOT NULL, name TEXT NOT NULL UNIQUE);
CREATE TABLE tests (
  id INTEGER PRIMARY KEY NOT NULL, behaviour TEXT NOT NULL,
  agents INTEGER NOT NULL, vehicle TEXT NOT NULL, number INTEGER NOT NULL, seed INTEGER NOT NULL,
  ended_by TEXT NOT NULL, ticks INTEGER NOT NULL, met_precondition BOOLEAN NOT NULL,
  precondition_ticks INTEGER, collision BOOLEAN NOT NULL, impact_mps DOUBLE, score DOUBLE NOT NULL,
  cpu_us DOUBLE NOT NULL, wall_us DOUBLE NOT NULL, scenes INTEGER NOT NULL);
CREATE TABLE actors (
  id INTEGER PRIMARY KEY NOT NULL, test_id INTEGER NOT NULL,
  actor INTEGER NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, length_m DOUBLE NOT NULL,
  width_m DOUBLE NOT NULL, cost DOUBLE, reward DOUBLE, actions INTEGER);
CREATE TABLE observations (
  id INTEGER PRIMARY KEY NOT NULL, test_id INTEGER NOT NULL,
  tick INTEGER NOT NULL, actor INTEGER NOT NULL, time DATETIME NOT NULL, x DOUBLE NOT NULL,
  y DOUBLE NOT NULL, speed DOUBLE NOT NULL, heading DOUBLE NOT NULL, geom POINT NOT NULL);
CREATE TABLE events (
  id INTEGER PRIMARY KEY NOT NULL, test_id INTEGER NOT NULL,
  tick INTEGER NOT NULL, actor INTEGER, time DATETIME NOT NULL, kind TEXT NOT NULL,
  text TEXT NOT NULL, x DOUBLE, y DOUBLE, geom POINT);
CREATE TABLE drops (
  id INTEGER PRIMARY KEY NOT NULL, test_id INTEGER NOT NULL, actor INTEGER NOT NULL,
  error TEXT NOT NULL, file TEXT NOT NULL, line INTEGER NOT NULL, "column" INTEGER NOT NULL,
  formula TEXT NOT NULL, message TEXT NOT NULL, goals TEXT NOT NULL, times INTEGER NOT NULL);
CREATE TABLE assessments (
  id INTEGER PRIMARY KEY NOT NULL, test_id INTEGER NOT NULL, name TEXT NOT NULL,
  verdict TEXT NOT NULL, value DOUBLE, tick INTEGER, actor INTEGER, robustness DOUBLE);
CREATE VIEW results AS SELECT
  t.id, t.behaviour, t.agents, t.vehicle, t.number AS test, t.seed, t.met_precondition AS succeeded,
  t.ended_by, t.ticks * e.tick_s AS time_s, t.precondition_ticks * e.tick_s AS precondition_s,
  t.collision, t.impact_mps, t.score,
  (SELECT group_concat(name, ' ') FROM assessments WHERE verdict = 'fail' AND id >= t.id << 24
     AND id < t.id + 1 << 24) AS failed,
  (SELECT min(robustness) FROM assessments WHERE id >= t.id << 24 AND id < t.id + 1 << 24)
    AS robustness
  FROM tests AS t, experiment AS e;
)sql";

constexpr std::array kListedResults = {
    ListedTable{"observations", "where each actor was at each tick", "POINT"},
    ListedTable{"events", "what happened to an actor, and where", "POINT"},
    ListedTable{"experiment", "which scenario, seed and tests"},
    ListedTable{"options", "how the command line changed the scenario"},
    ListedTable{"behaviours", "of the plan, in its order"},
    ListedTable{"parameters", "of the behaviours, as the scenario sets them"},
    ListedTable{"agent_numbers", "of the plan, in its order"},
    ListedTable{"vehicles", "that each test was run with: the first is that of the measures"},
    ListedTable{"tests", "each test and what came of it"},
    ListedTable{"actors", "who took part in a test, and the agents' costs, rewards and actions"},
    ListedTable{"drops", "why agents dropped intentions"},
    ListedTable{"assessments", "metrics' values and assertions' verdicts"},
};

void register_reference_system(Database& database, const Placement& placement) {
  Statement system(database,
                   "INSERT INTO gpkg_spatial_ref_sys VALUES (?1, ?2, 'EPSG', ?2, ?3, ?4)");
  system.run(fmt::format("EPSG:{}", placement.srs_id()), placement.srs_id(), placement.definition(),
             "as the scenario's anchor says");
}

}  // namespace

void create_tables(Database& database, const Placement& placement) {
  create_geopackage(database, "metres: x to the right of the AV, y ahead");
  database.execute(std::string(kResultsTables));
  if (placement.srs_id() > 0) register_reference_system(database, placement);
  list_tables(database, kListedResults, placement.srs_id());
}

StoreKind results_store() {
  return {.name = "results store",
          .table = "experiment",
          .version = kStoreVersion,
          .create = [](Database& database) {
            create_tables(database, Placement(std::nullopt));
            complete_tables(database);
          }};
}

std::string time_text(double seconds) {
  using namespace std::chrono;
  // As far as four-digit years go; a test that lasts longer stays at their end.
  constexpr double kLongest = 252'000'000'000;
  const auto passed = milliseconds(std::llround(std::min(seconds, kLongest) * 1000));
  const sys_time<milliseconds> moment = sys_days(year{2000} / January / 1) + passed;
  const sys_days day = floor<days>(moment);
  const year_month_day date(day);
  const hh_mm_ss clock(moment - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

void note_extents(Database& database, const Placement& placement) {
  for (const ListedTable& layer : kListedResults) {
    if (layer.geometry.empty()) continue;
    database.execute(fmt::format(
        "UPDATE gpkg_contents SET (min_x, min_y, max_x, max_y) = (SELECT min({0}), min({1}), "
        "max({0}), max({1}) FROM {2}) WHERE table_name = '{2}'",
        placement.easting_sql(), placement.northing_sql(), layer.name));
  }
}

void complete_tables(Database& database) {
  database.execute("CREATE INDEX IF NOT EXISTS observations_of_test ON observations (test_id)");
}

bool is_completed(Database& database) {
  return database.number("SELECT 1 FROM sqlite_master WHERE name = 'observations_of_test'") == 1;
}

}  // namespace jaywalk
