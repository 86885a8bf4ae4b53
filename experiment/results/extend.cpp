#include "experiment/results/extend.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "experiment/results/store/schema.h"

namespace jaywalk {
namespace {

/// Adds `shift` to the ids of the tests from `first` to `last`, and to those of the rows that
/// belong to them. They become negative until all are moved, so that none meets another.
void move_rows(Database& database, std::string_view table, std::int64_t first, std::int64_t last,
               std::int64_t shift) {
  if (table == "tests") {
    database.execute(fmt::format("UPDATE tests SET id = -(id + {}) WHERE id BETWEEN {} AND {}",
                                 shift, first, last));
    return;
  }
  database.execute(fmt::format(
      "UPDATE {} SET id = -(id + {}), test_id = test_id + {} WHERE id >= {} AND id < {}", table,
      row_id(shift, 0), shift, row_id(first, 0), row_id(last + 1, 0)));
}

}  // namespace

void extend_store(Database& database, const ExperimentDescription& before, std::uint64_t tests) {
  const std::uint64_t cells = jaywalk::cells(before);
  database.execute("BEGIN");
  // It is no longer complete; the index comes again when it is.
  database.execute("DROP INDEX IF EXISTS observations_of_test");
  for (const std::string_view table : kTablesOfTests) {
    for (std::uint64_t cell = 1; cell < cells; ++cell) {
      const auto first = static_cast<std::int64_t>(cell * before.tests + 1);
      const auto last = static_cast<std::int64_t>((cell + 1) * before.tests);
      const auto shift = static_cast<std::int64_t>(cell * (tests - before.tests));
      move_rows(database, table, first, last, shift);
    }
    database.execute(fmt::format("UPDATE {} SET id = -id WHERE id < 0", table));
  }
  database.execute(fmt::format("UPDATE experiment SET tests = {}", tests));
  database.execute("COMMIT");
}

}  // namespace jaywalk
