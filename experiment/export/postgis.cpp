// SPDX-License-Identifier: Apache-2.0
// Tests in a PostGIS database, in a schema of their own: GDAL's ogr2ogr knows how, if it is there.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "experiment/export/exporter.h"
#include "experiment/results/merge.h"
#include "experiment/scenario/files/temporary.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

/// The most characters of a name that PostgreSQL keeps.
constexpr std::size_t kLongestName = 63;

bool begins_name(char c) { return is_lower(c) || c == '_'; }

/// A name that PostgreSQL takes without quotes, of its own words apart.
bool is_schema_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName && begins_name(name.front()) &&
         !name.starts_with("pg_") &&
         std::ranges::all_of(name, [](char c) { return begins_name(c) || is_digit(c); });
}

/// The store's file name as such a name: `Runs of May.gpkg` is `runs_of_may`.
std::string default_schema(const std::string& store) {
  std::string name = std::filesystem::path(store).stem().string();
  for (char& c : name) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!begins_name(c) && !is_digit(c)) c = '_';
  }
  if (name.empty() || is_digit(name.front()) || name.starts_with("pg_")) name.insert(0, "_");
  return name.substr(0, kLongestName);
}

/// As ogr2ogr takes it: with `PG:` before it.
std::string dataset(std::string_view connection) {
  const bool has_prefix = connection.size() >= 3 &&
                          (connection[0] == 'P' || connection[0] == 'p') &&
                          (connection[1] == 'G' || connection[1] == 'g') && connection[2] == ':';
  return fmt::format("PG:{}", has_prefix ? connection.substr(3) : connection);
}

/// Whether one of GDAL's programs failed; adds an error if so.
bool failed(std::string_view program, int status, Diagnostics& diagnostics) {
  if (status == 0) return false;
  if (status == 127) {
    diagnostics.error(std::string(program), "is not installed",
                      "it is in Debian's package gdal-bin");
  } else {
    diagnostics.error(std::string(program), fmt::format("failed with exit status {}", status),
                      "its own message says why");
  }
  return true;
}

/// Whether the database has a schema of that name; empty if it could not be asked.
std::optional<bool> has_schema(const std::string& database, const std::string& schema,
                               Diagnostics& diagnostics) {
  std::string answer;
  const std::string query =
      fmt::format("SELECT count(*) AS found FROM pg_namespace WHERE nspname = '{}'", schema);
  const int status = run_program({"ogrinfo", "-ro", "-q", "-sql", query, database}, &answer);
  if (failed("ogrinfo", status, diagnostics)) return std::nullopt;
  return answer.find("= 1") != std::string::npos;
}

int copy(const std::string& store, const std::string& database, const std::string& schema,
         bool overwrite) {
  std::vector<std::string> words{"ogr2ogr", "-f", "PostgreSQL", "-update"};
  // Replaces the store's tables in that schema; others of its tables stay.
  if (overwrite) words.emplace_back("-overwrite");
  const std::string_view create = overwrite ? "CREATE SCHEMA IF NOT EXISTS" : "CREATE SCHEMA";
  for (std::string word :
       {database, store, std::string("-doo"),
        fmt::format("PRELUDE_STATEMENTS=SET client_min_messages=warning; {} \"{}\"", create,
                    schema),
        std::string("-doo"), "ACTIVE_SCHEMA=" + schema, std::string("-doo"), "SCHEMAS=" + schema,
        std::string("-lco"), "SCHEMA=" + schema, std::string("-lco"),
        std::string("GEOMETRY_NAME=geom")}) {
    words.push_back(std::move(word));
  }
  return run_program(std::move(words));
}

}  // namespace

ExportedFiles export_postgis(const ExportRequest& request) {
  Diagnostics diagnostics;
  if (request.connection.empty()) {
    diagnostics.error("--connection", "says which database the tables go to",
                      "as ogr2ogr wants it, 'dbname=tests host=localhost'");
    return diagnostics;
  }
  const std::string database = dataset(request.connection);
  const std::string schema =
      request.schema.empty() ? default_schema(request.store.path()) : request.schema;
  if (!is_schema_name(schema)) {
    diagnostics.error("--schema", fmt::format("'{}' is no name of a schema", schema),
                      "small letters, digits and _, not pg_ at its beginning");
    return diagnostics;
  }
  const std::optional<bool> exists = has_schema(database, schema, diagnostics);
  if (!exists) return diagnostics;
  if (*exists && !request.overwrite) {
    diagnostics.error("--schema", fmt::format("the database has a schema '{}' already", schema),
                      "--schema gives another one, --overwrite replaces the store's tables in it");
    return diagnostics;
  }
  const TemporaryFolder folder;
  const std::string excerpt = folder.path() + "/tests.gpkg";
  std::string store = request.store.path();
  if (request.tests.size() < request.store.count()) {
    if (const auto why = copy_tests(store, excerpt, request.tests)) {
      diagnostics.error(excerpt, fmt::format("cannot be written: {}", *why));
      return diagnostics;
    }
    store = excerpt;
  }
  if (failed("ogr2ogr", copy(store, database, schema, request.overwrite), diagnostics)) {
    return diagnostics;
  }
  return Exported{.files = {fmt::format("{} schema {}", database, schema)}, .warnings = {}};
}

}  // namespace jaywalk
