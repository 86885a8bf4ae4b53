#include "experiment/results/store/schema.h"

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "experiment/results/store/store_tables.h"
#include "experiment/results/store/stored_inputs.h"

namespace jaywalk {
namespace {

// As OGC 12-128r18 has them, word by word.
constexpr std::string_view kGeoPackageTables = R"sql(
CREATE TABLE gpkg_spatial_ref_sys (
  srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE gpkg_contents (
  table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE,
  description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT (strftime('%Y-%m-%dT%H:%M:%fZ','now')),
  min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER,
  CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));
CREATE TABLE gpkg_geometry_columns (
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL,
  CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name),
  CONSTRAINT uk_gc_table_name UNIQUE (table_name),
  CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name),
  CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));
INSERT INTO gpkg_spatial_ref_sys VALUES
  ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined', 'metres: x to the right of the AV, y ahead'),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinates'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326,
   'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,'
   || 'AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,'
   || 'AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],'
   || 'AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]',
   'longitude and latitude in degrees');
)sql";

constexpr std::string_view kTables = R"sql(
CREATE TABLE versions (
  id INTEGER PRIMARY KEY NOT NULL, subject TEXT NOT NULL UNIQUE,
  version TEXT NOT NULL);
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
)sql";

struct Layer {
  std::string_view table;
  std::string_view description;
};

constexpr std::array kLayers = {
    Layer{"observations", "where each actor was at each tick"},
    Layer{"events", "what happened to an actor, and where"},
};

constexpr std::array kAttributes = {
    Layer{"versions", "of the store's tables and of the program that wrote it"},
    Layer{"experiment", "which scenario, seed and tests"},
    Layer{"options", "how the command line changed the scenario"},
    Layer{"behaviours", "of the plan, in its order"},
    Layer{"parameters", "of the behaviours, as the scenario sets them"},
    Layer{"agent_numbers", "of the plan, in its order"},
    Layer{"vehicles", "that each test was run with: the first is that of the measures"},
    Layer{"inputs", "every file that the tests were made from"},
    Layer{"tests", "each test and what came of it"},
    Layer{"actors", "who took part in a test, and the agents' costs, rewards and actions"},
    Layer{"drops", "why agents dropped intentions"},
    Layer{"assessments", "metrics' values and assertions' verdicts"},
};

void register_reference_system(Database& database, const Placement& placement) {
  Statement system(database,
                   "INSERT INTO gpkg_spatial_ref_sys VALUES (?1, ?2, 'EPSG', ?2, ?3, ?4)");
  system.run(fmt::format("EPSG:{}", placement.srs_id()), placement.srs_id(), placement.definition(),
             "as the scenario's anchor says");
}

void register_tables(Database& database, const Placement& placement) {
  Statement contents(database,
                     "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, "
                     "srs_id) VALUES (?1, ?2, ?1, ?3, ?4)");
  Statement geometry(database,
                     "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', 'POINT', ?, 0, 0)");
  for (const Layer& layer : kLayers) {
    contents.run(layer.table, "features", layer.description, placement.srs_id());
    geometry.run(layer.table, placement.srs_id());
  }
  for (const Layer& layer : kAttributes) {
    contents.run(layer.table, "attributes", layer.description, std::nullopt);
  }
}

}  // namespace

void create_tables(Database& database, const Placement& placement) {
  database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};",
                               kGeoPackageId, kGeoPackageVersion));
  database.execute(std::string(kGeoPackageTables));
  database.execute(std::string(kTables));
  database.execute(std::string(kInputsTable));
  if (placement.srs_id() > 0) register_reference_system(database, placement);
  register_tables(database, placement);
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
  for (const Layer& layer : kLayers) {
    database.execute(fmt::format(
        "UPDATE gpkg_contents SET (min_x, min_y, max_x, max_y) = (SELECT min({0}), min({1}), "
        "max({0}), max({1}) FROM {2}) WHERE table_name = '{2}'",
        placement.easting_sql(), placement.northing_sql(), layer.table));
  }
}

void complete_tables(Database& database) {
  database.execute("CREATE INDEX IF NOT EXISTS observations_of_test ON observations (test_id)");
}

bool is_completed(Database& database) {
  return database.number("SELECT 1 FROM sqlite_master WHERE name = 'observations_of_test'") == 1;
}

}  // namespace jaywalk
