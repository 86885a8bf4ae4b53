#include "experiment/results/excerpt.h"

#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "experiment/results/store/database.h"
#include "experiment/results/store/schema.h"

namespace jaywalk {

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
  for (const std::string_view table : kTablesOfTests) {
    database.execute(fmt::format("DELETE FROM {} WHERE {} NOT IN (SELECT id FROM kept)", table,
                                 table == "tests" ? "id" : "test_id"));
  }
  database.execute("COMMIT");
  return database.failure();
}

}  // namespace jaywalk
