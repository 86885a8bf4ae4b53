// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/merge.h"

#include <algorithm>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "experiment/results/store/database.h"
#include "experiment/results/store/schema.h"
#include "experiment/results/store/store_file.h"

namespace jaywalk {
namespace {

struct Part {
  std::string path;
  ExperimentDescription description;
};

/// The parts in an order that depends on their content, not on their names.
Result<std::vector<Part>> read_parts(const std::vector<std::string>& inputs) {
  Diagnostics diagnostics;
  std::vector<Part> parts;
  for (const std::string& input : inputs) {
    auto store = described(open_to_read(input, results_store(), Scrutiny::all), input);
    if (store) {
      parts.push_back({.path = input, .description = std::move(store.value().description)});
    } else {
      diagnostics.append(std::move(store.diagnostics()));
    }
  }
  if (diagnostics.has_errors()) return diagnostics;
  std::ranges::sort(parts, [](const Part& left, const Part& right) {
    return std::tie(left.description.shard.index, left.path) <
           std::tie(right.description.shard.index, right.path);
  });
  return parts;
}

Diagnostics differences(const std::vector<Part>& parts) {
  Diagnostics diagnostics;
  const Part& first = parts.front();
  for (const Part& part : parts) {
    std::string why = difference(first.description, part.description);
    if (why.empty() && first.description.level != part.description.level) {
      why = fmt::format("the levels are {} and {}", name(first.description.level),
                        name(part.description.level));
    }
    if (why.empty()) continue;
    diagnostics.error(part.path,
                      fmt::format("not of the same experiment as '{}': {}", first.path, why));
  }
  return diagnostics;
}

/// A test that both have and that came out differently.
std::optional<std::int64_t> contradiction(Database& database) {
  return database.number(
      "SELECT a.id FROM main.tests AS a JOIN part.tests AS b ON a.id = b.id "
      "WHERE a.met_precondition <> b.met_precondition OR a.ticks <> b.ticks OR a.score <> b.score "
      "ORDER BY a.id LIMIT 1");
}

void copy_tests(Database& database, const Part& part) {
  Statement(database, "ATTACH ? AS part").run(file_uri(part.path, "mode=ro"));
  database.execute("BEGIN");
  if (const auto test = contradiction(database)) {
    database.fail(
        fmt::format("test {} of '{}' came out otherwise in another part", *test, part.path));
  }
  // The tests themselves come last: until then they show which rows are there already.
  const bool overlapping = database.number(
                               "SELECT EXISTS (SELECT 1 FROM part.tests WHERE id IN "
                               "(SELECT id FROM main.tests))") == 1;
  for (auto table = kTablesOfTests.rbegin(); table != kTablesOfTests.rend(); ++table) {
    const std::string_view key = *table == "tests" ? "id" : "test_id";
    const std::string unless =
        overlapping ? fmt::format("WHERE {} NOT IN (SELECT id FROM main.tests)", key) : "";
    database.execute(
        fmt::format("INSERT INTO main.{0} SELECT * FROM part.{0} {1} ORDER BY id", *table, unless));
  }
  database.execute("COMMIT");
  database.execute("DETACH part");
}

}  // namespace

Result<MergeOutcome> merge_stores(const std::string& output,
                                  const std::vector<std::string>& inputs) {
  auto parts = read_parts(inputs);
  if (!parts) return std::move(parts.diagnostics());
  if (parts.value().empty()) return store_error(output, "there is nothing to merge");
  Diagnostics wrong = differences(parts.value());
  if (wrong.has_errors()) return wrong;

  ExperimentDescription whole = parts.value().front().description;
  whole.shard = {};
  MergeOutcome outcome;
  outcome.planned = cells(whole) * whole.tests;
  const auto fill = [&](Database& database) {
    const Placement placement(whole.anchor);
    create_tables(database, placement);
    write_description(database, whole);
    database.execute("COMMIT");
    // Parts are interleaved: enough memory for the pages where the next rows go.
    database.execute("PRAGMA cache_size = -8000");
    for (const Part& part : parts.value()) copy_tests(database, part);
    outcome.tests =
        static_cast<std::uint64_t>(database.number("SELECT count(*) FROM tests").value_or(0));
    database.execute("BEGIN");
    note_extents(database, placement);
    if (outcome.tests == outcome.planned) complete_tables(database);
  };
  if (auto failure = create_store_file(output, fill)) return std::move(*failure);
  return outcome;
}

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
