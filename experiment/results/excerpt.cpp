#include "experiment/results/excerpt.h"

#include <string_view>

#include <fmt/format.h>

#include "experiment/results/store/database.h"
#include "experiment/results/store/schema.h"

namespace jaywalk {

std::optional<std::string> copy_tests(const std::string& from, const std::string& to,
                                      std::span<const std::int64_t> ids) {
  {
    // Not by copying the file: of one that was killed, tests are still in the log beside it.
    Database source(from, Database::Mode::read);
    Statement(source, "VACUUM INTO ?").run(to);
    if (source.failure()) return source.failure();
  }
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
