// SPDX-License-Identifier: Apache-2.0
// Files that are no stores, or not whole ones: a clear message, and not a byte of them is changed.

#include <fstream>
#include <functional>
#include <iterator>
#include <sqlite3.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/results/reader.h"
#include "experiment/results/writer.h"
#include "tests/unit/experiment_results/experiment_runs.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void run_sql(const std::string& path, const char* sql) {
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &connection), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(connection, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sql;
  sqlite3_close(connection);
}

class Damage : public StoreTest {
 protected:
  /// The file is neither opened nor changed.
  void expect_refused(const std::string& path, const std::string& why) {
    const std::string before = read_bytes(path);
    EXPECT_THAT(message_of(ResultsReader::open(path)), HasSubstr(why));
    EXPECT_THAT(message_of(ResultsWriter::resume(path, description())), HasSubstr(why));
    EXPECT_THAT(message_of(AssessmentWriter::open(path)), HasSubstr(why));
    EXPECT_TRUE(read_bytes(path) == before) << path << " was changed";
  }

  /// Writes `damaged.gpkg`: the store `a.gpkg` after a change.
  void damage(const char* sql) {
    std::filesystem::copy_file(file("a.gpkg"), file("damaged.gpkg"),
                               std::filesystem::copy_options::overwrite_existing);
    run_sql(file("damaged.gpkg"), sql);
  }
};

TEST_F(Damage, OfFilesThatAreNoStores) {
  write_bytes(file("text.gpkg"), "not a store");
  expect_refused(file("text.gpkg"), "it is no SQLite file");
  write_bytes(file("empty.gpkg"), "");
  expect_refused(file("empty.gpkg"), "it is no SQLite file");
  run_sql(file("sqlite.gpkg"), "CREATE TABLE t (x)");
  expect_refused(file("sqlite.gpkg"), "a SQLite file, but no GeoPackage");
  run_sql(file("other.gpkg"), "CREATE TABLE t (x); PRAGMA application_id = 0x47504B47");
  expect_refused(file("other.gpkg"), "a GeoPackage with other tables");
}

TEST_F(Damage, OfStoresOfAnotherVersion) {
  write(file("a.gpkg"), description(), cases());
  run_sql(file("a.gpkg"), "UPDATE versions SET version = '99' WHERE subject = 'store'");
  expect_refused(file("a.gpkg"), "its tables have version 99, this jaywalk knows version 3");
}

TEST_F(Damage, OfATestThatThePlanDoesNotHave) {
  write(file("a.gpkg"), description(), cases());
  for (const char* sql :
       {"UPDATE tests SET id = 49 WHERE id = 48", "UPDATE tests SET id = -1 WHERE id = 48"}) {
    damage(sql);
    const std::string before = read_bytes(file("damaged.gpkg"));
    EXPECT_THAT(message_of(ResultsWriter::resume(file("damaged.gpkg"), description())),
                HasSubstr("the store is damaged: it has a test"));
    EXPECT_TRUE(read_bytes(file("damaged.gpkg")) == before);
    (void)ResultsReader::open(file("damaged.gpkg")).value()->comparison();
  }
}

TEST_F(Damage, OfAStoreThatIsCutOff) {
  write(file("a.gpkg"), description(), cases());
  const std::string whole = read_bytes(file("a.gpkg"));
  for (const std::size_t size : {whole.size() - 1, whole.size() / 2, std::size_t{4096}}) {
    write_bytes(file("cut.gpkg"), whole.substr(0, size));
    expect_refused(file("cut.gpkg"), "it is cut off");
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{50}}) {
    write_bytes(file("cut.gpkg"), whole.substr(0, size));
    expect_refused(file("cut.gpkg"), "it is no SQLite file");
  }
}

TEST_F(Damage, AnywhereIsNoticedBeforeAStoreIsContinued) {
  write(file("a.gpkg"), description(StoreLevel::all), cases());
  const std::string whole = read_bytes(file("a.gpkg"));
  // Whole pages of other bytes: the root page of some table, or one further down.
  constexpr std::size_t kPage = 16384;
  for (std::size_t page = 1; page < whole.size() / kPage; page += 3) {
    std::string bytes = whole;
    bytes.replace(page * kPage, kPage, kPage, '\x5A');
    write_bytes(file("damaged.gpkg"), bytes);
    EXPECT_NE(message_of(ResultsWriter::resume(file("damaged.gpkg"), description(StoreLevel::all))),
              "")
        << "page " << page;
    EXPECT_TRUE(read_bytes(file("damaged.gpkg")) == bytes) << page;
    // A reader gets values or a message.
    if (auto reader = ResultsReader::open(file("damaged.gpkg"))) {
      (void)reader.value()->comparison();
      for (std::int64_t id = 1; id <= 48; ++id) {
        (void)reader.value()->recording(id);
        (void)reader.value()->assessments(id);
      }
    }
  }
}

TEST_F(Damage, OfADescriptionThatMakesNoSense) {
  write(file("a.gpkg"), description(), cases());
  for (const char* sql :
       {"UPDATE experiment SET tests = 4611686018427387904", "UPDATE experiment SET shard = 9",
        "UPDATE experiment SET level = 'much'", "DELETE FROM experiment", "DELETE FROM behaviours",
        "UPDATE experiment SET tick_s = 0"}) {
    damage(sql);
    expect_refused(file("damaged.gpkg"), "its description makes no sense");
  }
  damage("UPDATE experiment SET tests = -1");
  expect_refused(file("damaged.gpkg"), "its column 'tests' has a number out of range");
}

TEST_F(Damage, OfRowsIsTold) {
  struct Case {
    const char* sql;
    const char* message;
  };
  write(file("a.gpkg"), description(StoreLevel::all), cases());
  for (const Case& each : {
           Case{"UPDATE events SET actor = 9", "an event of test"},
           Case{"UPDATE events SET tick = 2000000000", "an event of test"},
           Case{"UPDATE events SET tick = 2147483648", "'tick' has a number out of range"},
           Case{"UPDATE tests SET ticks = 2147483648", "'ticks' has a number out of range"},
           Case{"UPDATE tests SET scenes = -1 WHERE id = 2", "'scenes' has a number out of range"},
           Case{"UPDATE actors SET kind = 'ghost'", "an actor of test"},
           Case{"UPDATE actors SET actor = actor + 1", "an actor of test"},
           Case{"UPDATE actors SET width_m = -1", "an actor of test"},
           Case{"DELETE FROM actors", "the actors of test"},
           Case{"DELETE FROM actors WHERE actor = (SELECT max(actor) FROM actors)",
                "the actors of test"},
           Case{"DELETE FROM observations", "the observations of test"},
           Case{"UPDATE observations SET tick = tick + 1", "the observations of test"},
           Case{"UPDATE tests SET scenes = scenes + 1", "the observations of test"},
           Case{"DELETE FROM observations WHERE actor = 0 AND tick = 2",
                "the observations of test"},
       }) {
    damage(each.sql);
    const auto store = ResultsReader::open(file("damaged.gpkg"));
    std::string messages;
    for (std::int64_t id = 1; id <= 48; ++id) messages += message_of(store.value()->recording(id));
    EXPECT_THAT(messages, HasSubstr(each.message)) << each.sql;
  }
}

/// A copy of a file as a process leaves it that is killed while it writes: with the journal by
/// which its changes are undone.
void copy_while_written(const std::string& path, const char* sql, const std::string& copy) {
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &connection), SQLITE_OK);
  // Without room in memory, changes go to the file at once.
  const std::string begin = std::string("PRAGMA cache_size = 1; BEGIN; ") + sql;
  ASSERT_EQ(sqlite3_exec(connection, begin.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  std::filesystem::copy_file(path, copy);
  std::filesystem::copy_file(path + "-journal", copy + "-journal");
  sqlite3_close(connection);
}

TEST_F(Damage, ByAKillInTheMidstOfAChangeIsUndone) {
  write(file("a.gpkg"), description(StoreLevel::all), cases());
  const char* change = "UPDATE observations SET x = x + 1; UPDATE tests SET ticks = 0";
  copy_while_written(file("a.gpkg"), change, file("read.gpkg"));
  ASSERT_TRUE(read_bytes(file("read.gpkg")) != read_bytes(file("a.gpkg")));
  auto store = ResultsReader::open(file("read.gpkg"));
  ASSERT_EQ(message_of(ResultsReader::open(file("read.gpkg"))), "");
  for (std::int64_t id = 1; id <= 48; ++id) {
    const TestKey test = store.value()->test(id).value().test;
    EXPECT_EQ(store.value()->recording(id).value(), run(test).recording);
  }
  copy_while_written(file("a.gpkg"), change, file("resume.gpkg"));
  EXPECT_EQ(message_of(ResultsWriter::resume(file("resume.gpkg"), description(StoreLevel::all))),
            "");
}

TEST_F(Damage, ByAKillIsNotUndoneInFilesThatAreNoStores) {
  run_sql(file("other.gpkg"),
          "CREATE TABLE t (x); PRAGMA application_id = 0x47504B47;"
          "WITH RECURSIVE n(i) AS (VALUES (1) UNION ALL SELECT i + 1 FROM n LIMIT 20000)"
          "INSERT INTO t SELECT i FROM n");
  copy_while_written(file("other.gpkg"), "UPDATE t SET x = x + 1", file("hot.gpkg"));
  expect_refused(file("hot.gpkg"), "cannot be undone");
}

TEST_F(Damage, OfAnotherExperimentIsNotDone) {
  write(file("a.gpkg"), description(), cases());
  const std::string before = read_bytes(file("a.gpkg"));
  ExperimentDescription other = description();
  other.seed = 99;
  EXPECT_EQ(message_of(ResultsWriter::resume(file("a.gpkg"), other)),
            "the store holds another experiment: the seeds are 5 and 99");
  EXPECT_EQ(message_of(ResultsWriter::resume(file("a.gpkg"), description(StoreLevel::all))),
            "the store's level is found, not all");
  EXPECT_EQ(message_of(ResultsWriter::create(file("a.gpkg"), description())), "the file exists");
  EXPECT_TRUE(read_bytes(file("a.gpkg")) == before);
}

TEST_F(Damage, ByTwoWritersIsPrevented) {
  auto first = ResultsWriter::create(file("a.gpkg"), description());
  ASSERT_TRUE(first.ok());
  EXPECT_EQ(message_of(ResultsWriter::resume(file("a.gpkg"), description())),
            "another process is writing the store");
  EXPECT_EQ(message_of(ResultsReader::open(file("a.gpkg"))),
            "another process is writing the store");
  first.value()->add(run(cases().front()));
  EXPECT_EQ(first.value()->finish(), std::nullopt);
  EXPECT_EQ(message_of(ResultsReader::open(file("a.gpkg"))), "");
}

TEST_F(Damage, ByAFolderThatIsNotThere) {
  EXPECT_THAT(message_of(ResultsWriter::create(file("none/a.gpkg"), description())),
              HasSubstr("No such file or directory"));
  EXPECT_THAT(message_of(ResultsReader::open(file("none/a.gpkg"))), HasSubstr("no such file"));
}

}  // namespace
}  // namespace jaywalk
