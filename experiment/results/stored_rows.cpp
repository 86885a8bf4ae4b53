// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/stored_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "experiment/results/store/schema.h"

namespace jaywalk {
namespace {

constexpr std::string_view kTestColumns =
    "SELECT id, met_precondition, coalesce(precondition_ticks, ticks) AS ticks, score, cpu_us, "
    "wall_us, "
    "scenes, ticks, precondition_ticks, ended_by, impact_mps, behaviour, agents, vehicle, number "
    "FROM tests ";

void damaged(Database& database, std::string_view what, std::int64_t test_id) {
  database.fail(fmt::format("the store is damaged: {} of test {}", what, test_id));
}

std::optional<std::uint32_t> count_or_null(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return row.count(column);
}

std::optional<double> real_or_null(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return row.real(column);
}

/// A value that may be infinite, such as the braking needed once two boxes overlap.
std::optional<double> any_real_or_null(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return row.any_real(column);
}

/// Whether the columns of kTestColumns say the same as the test's id.
bool is_of(const Statement& row, const ExperimentDescription& description, const TestKey& test) {
  return row.text(11) == description.behaviours[test.behaviour].name &&
         row.number(12) == test.agents && row.text(13) == description.vehicles[test.vehicle] &&
         row.integer<std::uint64_t>(14) == test.number && description.shard.has(test.number);
}

StoredTest test_of(Database& database, const ExperimentDescription& description,
                   const Statement& row) {
  StoredTest test{.id = row.number(0)};
  const auto found = find_test(description, test.id);
  if (found && is_of(row, description, *found)) {
    test.test = *found;
  } else {
    damaged(database, "the number", test.id);
  }
  test.result = {.succeeded = row.number(1) != 0,
                 .ticks = row.count(2),
                 .score = row.real(3),
                 .cpu_us = row.real(4),
                 .wall_us = row.real(5)};
  test.scenes = row.count(6);
  test.outcome = {.ticks = row.count(7),
                  .precondition_ticks = count_or_null(row, 8),
                  .ended_by = row.label(9),
                  .impact_mps = real_or_null(row, 10)};
  test.result.errored = test.outcome.ended_by == kErrored;
  return test;
}

std::optional<ActorKind> parse_kind(std::string_view text) {
  for (const ActorKind kind :
       {ActorKind::vehicle, ActorKind::pedestrian, ActorKind::cyclist, ActorKind::signal}) {
    if (name(kind) == text) return kind;
  }
  return std::nullopt;
}

/// A statement about the rows of one test, by their numbers.
Statement rows_of(Database& database, std::int64_t test_id, std::string_view columns,
                  std::string_view table) {
  Statement statement(database, fmt::format("SELECT {} FROM {} WHERE id >= ? AND id < ? "
                                            "ORDER BY id",
                                            columns, table));
  statement.bind(row_id(test_id, 0), row_id(test_id + 1, 0));
  return statement;
}

constexpr std::string_view kAssessmentColumns = "name, value, tick, actor, robustness, verdict";

AssessmentRow assessment_of(Database& database, std::int64_t test_id, const Statement& row) {
  const auto verdict = parse_stored_verdict(row.text(5));
  if (!verdict) damaged(database, "a verdict", test_id);
  return {.id = row.identifier(0),
          .value = any_real_or_null(row, 1),
          .tick = count_or_null(row, 2),
          .actor = count_or_null(row, 3),
          .robustness = any_real_or_null(row, 4),
          .verdict = verdict.value_or(StoredVerdict::none)};
}

/// The ids that the tests of a vehicle, a behaviour, a number of agents have.
std::pair<std::int64_t, std::int64_t> ids_of(const ExperimentDescription& description,
                                             const TestFilter& filter) {
  // Ids follow the plan: vehicles, then behaviours, then numbers of agents, then tests
  // (description.h).
  if (!filter.vehicle) return {0, kMaxTestId};
  const auto tests = static_cast<std::int64_t>(description.tests);
  std::int64_t width = tests * static_cast<std::int64_t>(description.agents.size());
  std::int64_t first = 1;
  const std::int64_t of_vehicle = width * static_cast<std::int64_t>(description.behaviours.size());
  first += static_cast<std::int64_t>(*filter.vehicle) * of_vehicle;
  if (!filter.behaviour) return {first, first + of_vehicle - 1};
  first += static_cast<std::int64_t>(*filter.behaviour) * width;
  // A number of agents that is not in the plan needs no check here: the WHERE clause excludes it.
  const auto column = std::ranges::find(description.agents, filter.agents.value_or(0));
  if (column != description.agents.end()) {
    first += (column - description.agents.begin()) * tests;
    width = tests;
  }
  return {first, first + width - 1};
}

void read_scenes(Database& database, std::int64_t test_id, Recording& recording) {
  std::vector<ActorState> scene;
  Statement row = rows_of(database, test_id, "x, y, speed, heading, tick, actor", "observations");
  while (row.step()) {
    // Rows are taken by their order: one that is missing must not shift the others.
    if (row.count(4) != recording.scenes() || row.count(5) != scene.size()) {
      return damaged(database, "the observations", test_id);
    }
    scene.push_back({.x_m = row.real(0),
                     .y_m = row.real(1),
                     .speed_mps = row.real(2),
                     .heading_rad = row.real(3)});
    if (scene.size() < recording.actors().size()) continue;
    recording.add(scene);
    scene.clear();
  }
  if (!scene.empty()) damaged(database, "the observations", test_id);
}

}  // namespace

void read_tests(Database& database, const ExperimentDescription& description,
                const TestFilter& filter,
                const std::function<Proceed(const StoredTest&)>& callback) {
  std::string sql(kTestColumns);
  sql +=
      "WHERE id >= ?1 AND id <= ?2 AND (?3 IS NULL OR agents = ?3) "
      "AND (?4 IS NULL OR met_precondition = ?4) "
      "AND (?6 IS NULL OR (ended_by = 'errored') = ?6) ORDER BY id LIMIT ?5";
  const auto [first, last] = ids_of(description, filter);
  std::optional<int> succeeded;
  if (filter.succeeded) succeeded = *filter.succeeded ? 1 : 0;
  std::optional<int> errored;
  if (filter.errored) errored = *filter.errored ? 1 : 0;
  Statement row(database, sql);
  row.bind(first, last, filter.agents, succeeded,
           // To SQLite a negative limit is none.
           filter.limit ? static_cast<std::int64_t>(*filter.limit) : std::int64_t{-1}, errored);
  while (row.step() && callback(test_of(database, description, row)) == Proceed::yes) {
  }
}

std::optional<StoredTest> read_test(Database& database, const ExperimentDescription& description,
                                    std::int64_t id) {
  Statement row(database, std::string(kTestColumns) + "WHERE id = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  return test_of(database, description, row);
}

std::vector<AgentScore> read_scores(Database& database, std::int64_t test_id) {
  std::vector<AgentScore> scores;
  Statement row = rows_of(database, test_id, "cost, reward, actions", "actors");
  while (row.step()) {
    // The AV and the other actors have no costs and rewards.
    if (row.is_null(0)) continue;
    scores.push_back({.cost = row.real(0), .reward = row.real(1), .actions = row.count(2)});
  }
  return scores;
}

std::vector<Actor> read_actors(Database& database, std::int64_t test_id) {
  std::vector<Actor> actors;
  Statement row = rows_of(database, test_id, "name, kind, length_m, width_m, actor", "actors");
  while (row.step()) {
    const auto kind = parse_kind(row.text(1));
    if (!kind || row.count(4) != actors.size() || row.real(2) < 0 || row.real(3) < 0) {
      damaged(database, "an actor", test_id);
    }
    actors.push_back({.name = row.label(0),
                      .kind = kind.value_or(ActorKind::pedestrian),
                      .length_m = row.real(2),
                      .width_m = row.real(3)});
  }
  return actors;
}

namespace {

/// Calls back for each test that dropped intentions, in their order, with nothing else.
void read_drops(Database& database, std::int64_t first, std::int64_t last,
                const std::function<void(std::int64_t, const TestTroubles&)>& callback) {
  Statement drop(database,
                 "SELECT test_id, actor, error, file, line, \"column\", formula, message, goals, "
                 "times FROM drops WHERE id >= ? AND id < ? ORDER BY id");
  drop.bind(row_id(first, 0), row_id(last + 1, 0));
  TestTroubles test;
  std::int64_t id = 0;
  while (drop.step()) {
    // Rows are sorted by test: with the next test's first row the one before is whole.
    if (drop.number(0) != id && !test.drops.empty()) {
      callback(id, test);
      test.drops.clear();
    }
    id = drop.number(0);
    test.drops.push_back({.actor = drop.count(1),
                          .cause = {.error = drop.text(2),
                                    .file = drop.text(3),
                                    .line = drop.count(4),
                                    .column = drop.count(5),
                                    .formula = drop.text(6),
                                    .message = drop.text(7),
                                    .goals = drop.text(8),
                                    .times = drop.integer<std::uint64_t>(9)}});
  }
  if (!test.drops.empty()) callback(id, test);
}

}  // namespace

Troubles read_troubles(Database& database, std::int64_t first, std::int64_t last) {
  // One row sums the actors of all tests of the range; actor 0 is the AV, which is no agent.
  TroublesSum sum;
  Statement actors(database,
                   "SELECT count(*), count(actions), sum(actions = 0) FROM actors "
                   "WHERE id >= ? AND id < ? AND actor > 0");
  actors.bind(row_id(first, 0), row_id(last + 1, 0));
  if (actors.step()) {
    sum.add(0, {.agents = actors.integer<std::uint64_t>(0),
                .pedestrians = actors.integer<std::uint64_t>(1),
                .idle = actors.is_null(2) ? 0 : actors.integer<std::uint64_t>(2)});
  }
  read_drops(database, first, last, [&](std::int64_t id, const TestTroubles& test) {
    sum.add(static_cast<std::uint64_t>(id), test);
  });
  // Tests are known by their numbers there.
  Statement error(database,
                  "SELECT number, text FROM events JOIN tests ON tests.id = test_id "
                  "WHERE events.id >= ? AND events.id < ? AND kind = 'errored' "
                  "ORDER BY events.id");
  error.bind(row_id(first, 0), row_id(last + 1, 0));
  while (error.step()) sum.add(error.integer<std::uint64_t>(0), {.error = error.text(1)});
  return sum.sum();
}

std::vector<AssessmentRow> read_assessments(Database& database, std::int64_t test_id) {
  std::vector<AssessmentRow> assessments;
  Statement row = rows_of(database, test_id, kAssessmentColumns, "assessments");
  while (row.step()) assessments.push_back(assessment_of(database, test_id, row));
  return assessments;
}

void read_all_assessments(
    Database& database,
    const std::function<void(std::int64_t test_id, const std::vector<AssessmentRow>&)>& callback) {
  std::vector<AssessmentRow> assessments;
  std::int64_t test_id = 0;
  Statement row(database, fmt::format("SELECT {}, test_id, id FROM assessments ORDER BY id",
                                      kAssessmentColumns));
  while (row.step()) {
    // Each test comes once: sums rely on it.
    if (row.number(7) >> kRowBits != row.number(6)) damaged(database, "a verdict", row.number(6));
    if (row.number(6) != test_id && !assessments.empty()) {
      callback(test_id, assessments);
      assessments.clear();
    }
    test_id = row.number(6);
    assessments.push_back(assessment_of(database, test_id, row));
  }
  if (!assessments.empty()) callback(test_id, assessments);
}

std::vector<std::string> read_assertion_ids(Database& database) {
  std::vector<std::string> ids;
  Statement row(database, fmt::format("SELECT name FROM assessments WHERE verdict <> 'none' "
                                      "GROUP BY name ORDER BY min(id % {}), name",
                                      kMaxRows));
  // A test's rows are in the order of the assertions, so the least row number sorts them.
  while (row.step()) ids.push_back(row.identifier(0));
  return ids;
}

void read_places(
    Database& database, std::string_view kind,
    const std::function<void(std::int64_t test_id, double x_m, double y_m)>& callback) {
  Statement row(database,
                "SELECT test_id, x, y FROM events WHERE kind = ? AND x IS NOT NULL AND y IS NOT "
                "NULL ORDER BY id");
  row.bind(kind);
  while (row.step()) callback(row.number(0), row.real(1), row.real(2));
}

std::string read_event(Database& database, std::int64_t test_id, std::string_view kind) {
  Statement row = rows_of(database, test_id, "kind, text", "events");
  std::string text;
  while (row.step()) {
    if (row.text(0) == kind) text = row.text(1);
  }
  return text;
}

Recording read_recording(Database& database, double tick_s, const StoredTest& test) {
  Recording recording(tick_s, read_actors(database, test.id));
  if (recording.actors().size() <= test.test.agents) {
    damaged(database, "the actors", test.id);
    return recording;
  }
  read_scenes(database, test.id, recording);
  if (recording.scenes() != test.scenes) damaged(database, "the observations", test.id);
  Statement row = rows_of(database, test.id, "tick, actor, kind, text", "events");
  while (row.step()) {
    RecordedEvent event{.tick = row.count(0),
                        .actor = count_or_null(row, 1),
                        .kind = row.label(2),
                        .text = row.text(3)};
    // Callers use the actor and the tick as indices, so check them here.
    if (event.actor.value_or(0) >= recording.actors().size() || event.tick >= recording.scenes()) {
      damaged(database, "an event", test.id);
    } else {
      recording.add(std::move(event));
    }
  }
  return recording;
}

}  // namespace jaywalk
