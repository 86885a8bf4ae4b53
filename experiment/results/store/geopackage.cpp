// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/geopackage.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "experiment/scenario/files/program_text.h"

namespace jaywalk {
namespace {

// As OGC 12-128r18 has them, word by word.
constexpr std::string_view kTables = R"sql(
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
  ('Undefined Cartesian SRS', -1, 'NONE', -1, 'undefined', NULL),
  ('Undefined geographic SRS', 0, 'NONE', 0, 'undefined', 'undefined geographic coordinates'),
  ('WGS 84 geodetic', 4326, 'EPSG', 4326,
   'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563,'
   || 'AUTHORITY["EPSG","7030"]],AUTHORITY["EPSG","6326"]],PRIMEM["Greenwich",0,'
   || 'AUTHORITY["EPSG","8901"]],UNIT["degree",0.0174532925199433,AUTHORITY["EPSG","9122"]],'
   || 'AXIS["Latitude",NORTH],AXIS["Longitude",EAST],AUTHORITY["EPSG","4326"]]',
   'longitude and latitude in degrees');
CREATE TABLE versions (
  id INTEGER PRIMARY KEY NOT NULL, subject TEXT NOT NULL UNIQUE,
  version TEXT NOT NULL);
)sql";

constexpr std::array kListed = {
    ListedTable{"versions", "of the store's tables and of the program that wrote it"},
    ListedTable{"inputs", "every file that the tests were made from"},
};

bool has_table(Database& database, std::string_view name) {
  Statement found(database, "SELECT 1 FROM sqlite_master WHERE name = ?");
  found.bind(name);
  return found.step();
}

constexpr std::string_view kObjects =
    "SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY name";

/// The kind of object that the SQL text creates, whatever the row calls it.
std::string_view kind_of(std::string_view sql) {
  for (const std::string_view kind : {"TABLE", "VIEW", "TRIGGER", "VIRTUAL TABLE", "INDEX"}) {
    if (sql.starts_with(fmt::format("CREATE {} ", kind))) return kind;
  }
  return "";
}

/// The objects of the database by name, with the SQL that creates them.
std::map<std::string, std::string> objects_of(Database& database) {
  std::map<std::string, std::string> objects;
  Statement row(database, kObjects);
  while (row.step()) objects.emplace(row.text(1), row.text(2));
  return objects;
}

std::map<std::string, std::string> objects_by(const StoreKind& kind) {
  Database wanted("", Database::Mode::memory);
  kind.create(wanted);
  return objects_of(wanted);
}

std::string_view in_words(std::string_view kind) {
  if (kind == "VIEW") return "view";
  if (kind == "TRIGGER") return "trigger";
  if (kind == "VIRTUAL TABLE") return "virtual table";
  return kind == "INDEX" ? "index" : "object";
}

std::optional<std::string> foreign_object(Database& database, const StoreKind& kind) {
  const auto own = objects_by(kind);
  Statement row(database, kObjects);
  while (row.step()) {
    const std::string sql = row.text(2);
    const std::string_view made = kind_of(sql);
    if (made == "TABLE" && row.text(0) == "table") continue;
    const auto found = own.find(row.text(1));
    if (found != own.end() && found->second == sql) continue;
    return fmt::format("not a store as jaywalk writes it: it has the {} '{}'", in_words(made),
                       row.text(1));
  }
  return std::nullopt;
}

/// Why its tables have another version.
std::optional<std::string> version_difference(Database& database, const StoreKind& kind) {
  std::string version = "unknown";
  if (has_table(database, "versions")) {
    version =
        database.text("SELECT version FROM versions WHERE subject = 'store'").value_or(version);
  }
  if (database.failure() || version == fmt::format("{}", kind.version)) return std::nullopt;
  return fmt::format("its tables have version {}, this jaywalk knows version {}", version,
                     kind.version);
}

std::optional<std::string> table_difference(Database& database, const StoreKind& kind) {
  const auto version = database.number("PRAGMA user_version");
  if (!database.failure() && version != kGeoPackageVersion) {
    return fmt::format("not a {}: its user_version is {}, that of a GeoPackage {}", kind.name,
                       version.value_or(0), kGeoPackageVersion);
  }
  const auto there = objects_of(database);
  if (database.failure()) return std::nullopt;
  for (const auto& [name, sql] : objects_by(kind)) {
    if (name.starts_with("sqlite_") || kind_of(sql) != "TABLE") continue;
    const auto found = there.find(name);
    if (found == there.end())
      return fmt::format("the store is damaged: it has no table '{}'", name);
    if (found->second != sql) {
      return fmt::format("the store is damaged: its table '{}' has not the columns that it should",
                         name);
    }
  }
  return std::nullopt;
}

}  // namespace

void create_geopackage(Database& database, std::string_view plane) {
  database.execute(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {};",
                               kGeoPackageId, kGeoPackageVersion));
  database.execute(std::string(kTables));
  database.execute(std::string(kInputsTable));
  Statement(database, "UPDATE gpkg_spatial_ref_sys SET description = ? WHERE srs_id = -1")
      .run(plane);
  list_tables(database, kListed, -1);
}

void list_tables(Database& database, std::span<const ListedTable> tables, int srs_id) {
  Statement contents(database,
                     "INSERT INTO gpkg_contents (table_name, data_type, identifier, description, "
                     "srs_id) VALUES (?1, ?2, ?1, ?3, ?4)");
  Statement geometry(database, "INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, 0, 0)");
  for (const ListedTable& each : tables) {
    const bool layer = !each.geometry.empty();
    contents.run(each.name, layer ? "features" : "attributes", each.description,
                 layer ? std::optional(srs_id) : std::nullopt);
    if (layer) geometry.run(each.name, each.geometry, srs_id);
  }
}

void write_versions(Database& database, std::int64_t store, std::string_view jaywalk) {
  Statement version(database, "INSERT INTO versions (subject, version) VALUES (?, ?)");
  version.run("store", fmt::format("{}", store));
  version.run("jaywalk", jaywalk);
}

bool is_store(Database& database, const StoreKind& kind) { return has_table(database, kind.table); }

std::optional<std::string> objection(Database& database, const StoreKind& kind) {
  if (!is_store(database, kind)) {
    if (database.failure()) return std::nullopt;
    return fmt::format("not a {}: a GeoPackage with other tables", kind.name);
  }
  if (auto why = foreign_object(database, kind)) return why;
  if (auto why = version_difference(database, kind)) return why;
  return table_difference(database, kind);
}

StoredInput stored_input(const Source& source) {
  return {
      .path = source.name(), .text = std::string(source.text()), .sha256 = sha256(source.text())};
}

std::vector<StoredInput> stored_inputs(std::span<const SourcePtr> sources) {
  std::vector<StoredInput> inputs;
  for (const SourcePtr& source : sources) inputs.push_back(stored_input(*source));
  return inputs;
}

SourceFiles copies_of(std::span<const StoredInput> inputs) {
  std::vector<SourcePtr> copies;
  for (const StoredInput& input : inputs) {
    copies.push_back(std::make_shared<const Source>(input.path, input.text));
  }
  return SourceFiles(copies);
}

void write_inputs(Database& database, std::span<const StoredInput> inputs) {
  Statement input(database, "INSERT INTO inputs (path, sha256, text) VALUES (?, ?, ?)");
  for (const StoredInput& each : inputs) input.run(each.path, each.sha256, each.text);
}

std::vector<StoredInput> read_inputs(Database& database) {
  std::vector<StoredInput> inputs;
  Statement input(database, "SELECT path, sha256, text FROM inputs ORDER BY id");
  while (input.step()) {
    inputs.push_back({.path = input.text(0), .text = input.text(2), .sha256 = input.text(1)});
  }
  return inputs;
}

std::optional<std::string> damage_of(std::span<const StoredInput> inputs) {
  const auto changed = std::ranges::find_if(
      inputs, [](const StoredInput& stored) { return sha256(stored.text) != stored.sha256; });
  if (changed == inputs.end()) return std::nullopt;
  return fmt::format("the store is damaged: the text of '{}' is not the one whose hash it has",
                     changed->path);
}

}  // namespace jaywalk
