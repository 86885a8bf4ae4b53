#include "experiment/results/excerpt.h"

#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "experiment/results/database.h"

namespace jaywalk {
namespace {

/// The tables whose rows belong to a test.
std::vector<std::string> tables_of_tests(Database& database) {
  std::vector<std::string> tables;
  Statement rows(database,
                 "SELECT m.name FROM sqlite_master m JOIN pragma_table_info(m.name) p "
                 "ON p.name = 'test_id' WHERE m.type = 'table' ORDER BY m.name");
  while (rows.step()) tables.emplace_back(rows.text(0));
  return tables;
}

}  // namespace

std::optional<std::string> copy_tests(const std::string& from, const std::string& to,
                                      std::span<const std::int64_t> ids) {
  std::error_code error;
  std::filesystem::copy_file(from, to, error);
  if (error) return error.message();
  Database database(to, Database::Mode::write);
  database.execute("BEGIN; CREATE TEMP TABLE kept (id INTEGER PRIMARY KEY)");
  {
    Statement keep(database, "INSERT OR IGNORE INTO kept VALUES (?)");
    for (const std::int64_t id : ids) keep.run(id);
  }
  for (const std::string& table : tables_of_tests(database)) {
    database.execute(
        fmt::format("DELETE FROM {} WHERE test_id NOT IN (SELECT id FROM kept)", table));
  }
  database.execute("DELETE FROM tests WHERE id NOT IN (SELECT id FROM kept); COMMIT");
  return database.failure();
}

}  // namespace jaywalk
