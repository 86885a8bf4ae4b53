#include "experiment/results/store/store_tables.h"

#include <map>
#include <string_view>

#include <fmt/format.h>

namespace jaywalk {
namespace {

constexpr std::string_view kObjects =
    "SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY name";

/// What SQLite makes of the text, whatever the row calls it.
std::string_view kind_of(std::string_view sql) {
  for (const std::string_view kind : {"TABLE", "VIEW", "TRIGGER", "VIRTUAL TABLE", "INDEX"}) {
    if (sql.starts_with(fmt::format("CREATE {} ", kind))) return kind;
  }
  return "";
}

/// What there is, by name, and the text that makes it.
std::map<std::string, std::string> objects_of(Database& database) {
  std::map<std::string, std::string> objects;
  Statement row(database, kObjects);
  while (row.step()) objects.emplace(row.text(1), row.text(2));
  return objects;
}

std::map<std::string, std::string> objects_by(const CreateTables& create) {
  Database wanted("", Database::Mode::memory);
  create(wanted);
  return objects_of(wanted);
}

std::string_view in_words(std::string_view kind) {
  if (kind == "VIEW") return "view";
  if (kind == "TRIGGER") return "trigger";
  if (kind == "VIRTUAL TABLE") return "virtual table";
  return kind == "INDEX" ? "index" : "object";
}

}  // namespace

std::optional<std::string> foreign_object(Database& database, const CreateTables& create) {
  const auto own = objects_by(create);
  Statement row(database, kObjects);
  while (row.step()) {
    const std::string sql = row.text(2);
    const std::string_view kind = kind_of(sql);
    if (kind == "TABLE" && row.text(0) == "table") continue;
    const auto found = own.find(row.text(1));
    if (found != own.end() && found->second == sql) continue;
    return fmt::format("not a store as jaywalk writes it: it has the {} '{}'", in_words(kind),
                       row.text(1));
  }
  return std::nullopt;
}

std::optional<std::string> table_difference(Database& database, const CreateTables& create) {
  const auto version = database.number("PRAGMA user_version");
  if (!database.failure() && version != kGeoPackageVersion) {
    return fmt::format("not a results store: its user_version is {}, that of a GeoPackage {}",
                       version.value_or(0), kGeoPackageVersion);
  }
  const auto there = objects_of(database);
  if (database.failure()) return std::nullopt;
  for (const auto& [name, sql] : objects_by(create)) {
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

}  // namespace jaywalk
