// SPDX-License-Identifier: Apache-2.0
// A store says the same in SQL as its recordings do.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sqlite3.h>
#include <sstream>

#include <gtest/gtest.h>

#include "experiment/results/reader.h"
#include "experiment/results/store/geometry.h"
#include "tests/unit/experiment_results/experiment_runs.h"

namespace jaywalk {
namespace {

/// The query of the README that begins with this text.
std::string query_of_the_readme(const std::string& beginning) {
  std::ifstream file(JAYWALK_SOURCE_DIR "/docs/reference/store.md");
  std::stringstream text;
  text << file.rdbuf();
  const auto from = text.str().find("    " + beginning);
  return text.str().substr(from, text.str().find(';', from) + 1 - from);
}

std::map<std::int64_t, double> rows_of(const std::string& path, const std::string& sql) {
  std::map<std::int64_t, double> rows;
  sqlite3* connection = nullptr;
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_open_v2(path.c_str(), &connection, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  EXPECT_EQ(sqlite3_prepare_v2(connection, sql.c_str(), -1, &statement, nullptr), SQLITE_OK)
      << sqlite3_errmsg(connection) << "\n"
      << sql;
  while (sqlite3_step(statement) == SQLITE_ROW) {
    rows[sqlite3_column_int64(statement, 0)] = sqlite3_column_double(statement, 1);
  }
  sqlite3_finalize(statement);
  sqlite3_close(connection);
  return rows;
}

double least_distance(const Recording& recording, std::size_t actor) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    const auto scene = recording.scene(tick);
    least = std::min(least, distance_m(box(recording.actors()[0], scene[0]),
                                       box(recording.actors()[actor], scene[actor])));
  }
  return least;
}

TEST_F(StoreTest, GivesTheSameDistancesInSqlAsTheMetric) {
  write(file("a.gpkg"), description(StoreLevel::all), cases());
  const std::string sql = query_of_the_readme("SELECT p.actor, min(sqrt(");
  const auto store = ResultsReader::open(file("a.gpkg"));
  int compared = 0;
  for (std::int64_t id = 1; id <= 48; ++id) {
    std::string of_test = sql;
    of_test.replace(of_test.find("p.test_id = 1"), 13, "p.test_id = " + std::to_string(id));
    const Recording recording = store.value()->recording(id).value();
    const auto rows = rows_of(file("a.gpkg"), of_test);
    ASSERT_EQ(rows.size() + 1, recording.actors().size());
    for (const auto& [actor, distance] : rows) {
      EXPECT_NEAR(distance, least_distance(recording, static_cast<std::size_t>(actor)), 1e-9)
          << "test " << id << ", actor " << actor;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 2 * 12 * (1 + 3));
}

TEST_F(StoreTest, IsCompletedEvenIfItWasKilledAtTheVeryEnd) {
  write(file("a.gpkg"), description(), cases());
  const std::string extents = "SELECT rowid, max_y FROM gpkg_contents WHERE data_type = 'features'";
  const auto wanted = rows_of(file("a.gpkg"), extents);
  ASSERT_GT(wanted.begin()->second, 0);
  sqlite3* connection = nullptr;
  ASSERT_EQ(sqlite3_open(file("a.gpkg").c_str(), &connection), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(connection,
                         "DROP INDEX observations_of_test; UPDATE gpkg_contents SET max_y = NULL",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(connection);
  write(file("a.gpkg"), description(), cases());
  EXPECT_EQ(rows_of(file("a.gpkg"), extents), wanted);
  EXPECT_EQ(
      rows_of(file("a.gpkg"), "SELECT 1, 1 FROM sqlite_master WHERE name = 'observations_of_test'")
          .size(),
      1U);
}

TEST_F(StoreTest, LiesWhereItsAnchorSays) {
  const Anchor anchor{
      .epsg = 32630, .easting_m = 530'000, .northing_m = 5'700'000, .bearing_deg = 90};
  // The AV drives east, so what is to its right is south.
  const auto [east, north] = Placement(anchor).place(2, 10);
  EXPECT_NEAR(east, 530'010, 1e-6);
  EXPECT_NEAR(north, 5'699'998, 1e-6);

  ExperimentDescription anchored = description(StoreLevel::all);
  anchored.anchor = anchor;
  write(file("plain.gpkg"), description(StoreLevel::all), cases());
  write(file("a.gpkg"), anchored, cases());
  EXPECT_EQ(ResultsReader::open(file("a.gpkg")).value()->description().anchor, anchor);
  EXPECT_EQ(ResultsReader::open(file("a.gpkg")).value()->recording(7).value(),
            ResultsReader::open(file("plain.gpkg")).value()->recording(7).value());
  const auto extent = [&](const std::string& name, const std::string& column) {
    return rows_of(file(name), "SELECT 1, " + column +
                                   " FROM gpkg_contents WHERE table_name = 'observations'")[1];
  };
  EXPECT_NEAR(extent("a.gpkg", "max_x") - 530'000, extent("plain.gpkg", "max_y"), 1e-6);
  EXPECT_NEAR(5'700'000 - extent("a.gpkg", "min_y"), extent("plain.gpkg", "max_x"), 1e-6);
  EXPECT_EQ(rows_of(file("a.gpkg"), "SELECT 1, srs_id FROM gpkg_geometry_columns")[1], 32630);
}

TEST_F(StoreTest, TellsWhereThePreconditionWasMet) {
  write(file("a.gpkg"), description(StoreLevel::summary), cases());
  const auto found =
      rows_of(file("a.gpkg"), "SELECT test_id, y FROM events WHERE kind = 'precondition'");
  const auto successes =
      rows_of(file("a.gpkg"), "SELECT id, ticks FROM tests WHERE met_precondition");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.size(), successes.size());
  const auto store = ResultsReader::open(file("a.gpkg"));
  for (const auto& [test, y] : found) {
    const Recording recording = store.value()->recording(test).value();
    const auto last = std::find_if(recording.events().rbegin(), recording.events().rend(),
                                   [](const auto& each) { return each.kind == "precondition"; });
    ASSERT_NE(last, recording.events().rend());
    const RecordedEvent& event = *last;
    EXPECT_EQ(y, recording.scene(event.tick)[*event.actor].y_m);
    EXPECT_EQ(event.tick, successes.at(test));
  }
}

}  // namespace
}  // namespace jaywalk
