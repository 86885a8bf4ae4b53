#include "experiment/results/store/store_tables.h"

#include <map>
#include <string_view>

#include <fmt/format.h>

#include "experiment/results/store/geopackage.h"

namespace jaywalk {
namespace {

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

}  // namespace jaywalk
