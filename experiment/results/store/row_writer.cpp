// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/row_writer.h"

#include <cmath>

#include <fmt/format.h>

#include "experiment/results/store/schema.h"
#include "experiment/results/stored_rows.h"

namespace jaywalk {
namespace {

/// How many ticks' time texts are cached; making one takes as long as writing a row.
constexpr std::size_t kTimesKept = 10'000;

/// A comparison has no NaN, and SQLite would make it NULL, which some columns do not take.
double number(double value) { return std::isnan(value) ? 0 : value; }

}  // namespace

RowWriter::RowWriter(Database& database, const ExperimentDescription& description)
    : database_(database),
      description_(description),
      placement_(description.anchor),
      test_(database, "INSERT INTO tests VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      actor_(database, "INSERT INTO actors VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      observation_(database, "INSERT INTO observations VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      event_(database, "INSERT INTO events VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      drop_(database, "INSERT INTO drops VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      assessment_(database, "INSERT INTO assessments VALUES (?, ?, ?, ?, ?, ?, ?, ?)") {}

void RowWriter::write(const TestRecord& record) {
  const std::int64_t id = test_id(description_, record.test);
  const Recording& recording = record.recording;
  const bool scenes = description_.level == StoreLevel::all ||
                      (description_.level == StoreLevel::found && record.result.succeeded);
  const std::size_t rows = recording.scenes() * recording.actors().size();
  if (rows > static_cast<std::size_t>(kMaxRows)) {
    database_.fail(
        fmt::format("a test with {} observations; at most {} can be kept", rows, kMaxRows));
    return;
  }
  const TestResult& result = record.result;
  const TestOutcome& outcome = record.outcome;
  test_.run(id, description_.behaviours[record.test.behaviour].name, record.test.agents,
            description_.vehicles[record.test.vehicle], record.test.number, description_.seed,
            outcome.ended_by, outcome.ticks, result.succeeded ? 1 : 0, outcome.precondition_ticks,
            outcome.impact_mps ? 1 : 0, outcome.impact_mps, number(result.score),
            number(result.cpu_us), number(result.wall_us),
            scenes ? recording.scenes() : std::size_t{0});
  write_actors(id, record);
  if (scenes) write_scenes(id, recording);
  write_events(id, recording);
  write_drops(id, record.drops);
  write(id, record.assessments);
}

void RowWriter::write_actors(std::int64_t test_id, const TestRecord& record) {
  const std::span<const Actor> actors = record.recording.actors();
  for (std::size_t i = 0; i < actors.size(); ++i) {
    std::optional<double> cost, reward;
    std::optional<std::uint32_t> actions;
    if (i > 0 && i <= record.scores.size()) {
      cost = number(record.scores[i - 1].cost);
      reward = number(record.scores[i - 1].reward);
      actions = record.scores[i - 1].actions;
    }
    actor_.run(row_id(test_id, static_cast<std::int64_t>(i)), test_id, i, actors[i].name,
               name(actors[i].kind), actors[i].length_m, actors[i].width_m, cost, reward, actions);
  }
}

void RowWriter::write_scenes(std::int64_t test_id, const Recording& recording) {
  std::int64_t row = row_id(test_id, 0);
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    const std::string& time = time_of(tick);
    std::size_t actor = 0;
    for (const ActorState& state : recording.scene(tick)) {
      const PointBlob point = point_of(state);
      observation_.run(row++, test_id, tick, actor++, time, state.x_m, state.y_m, state.speed_mps,
                       state.heading_rad, Blob{point});
    }
  }
}

void RowWriter::write_events(std::int64_t test_id, const Recording& recording) {
  std::int64_t row = row_id(test_id, 0);
  for (const RecordedEvent& event : recording.events()) {
    std::optional<double> x, y;
    std::optional<Blob> geometry;
    PointBlob point{};
    if (event.actor && event.tick < recording.scenes()) {
      const ActorState& state = recording.scene(event.tick)[*event.actor];
      x = state.x_m;
      y = state.y_m;
      point = point_of(state);
      geometry = Blob{point};
    }
    event_.run(row++, test_id, event.tick, event.actor, time_of(event.tick), event.kind, event.text,
               x, y, geometry);
  }
}

void RowWriter::write_drops(std::int64_t test_id, std::span<const AgentDrop> drops) {
  std::int64_t row = row_id(test_id, 0);
  for (const AgentDrop& drop : drops) {
    const DropCause& cause = drop.cause;
    drop_.run(row++, test_id, drop.actor, cause.error, cause.file, cause.line, cause.column,
              cause.formula, cause.message, cause.goals, cause.times);
  }
}

void RowWriter::write(std::int64_t test_id, std::span<const AssessmentRow> assessments) {
  std::int64_t row = row_id(test_id, 0);
  for (const AssessmentRow& each : assessments) {
    assessment_.run(row++, test_id, each.id, name(each.verdict), each.value, each.tick, each.actor,
                    each.robustness);
  }
}

PointBlob RowWriter::point_of(const ActorState& state) const {
  const auto [x, y] = placement_.place(state.x_m, state.y_m);
  return point_blob(x, y, placement_.srs_id());
}

const std::string& RowWriter::time_of(std::size_t tick) {
  const auto moment = [&](std::size_t t) {
    return time_text(static_cast<double>(t) * description_.tick_s);
  };
  if (tick >= kTimesKept) return late_time_ = moment(tick);
  while (times_.size() <= tick) times_.push_back(moment(times_.size()));
  return times_[tick];
}

AssessmentSpool::AssessmentSpool() : database_({}, Database::Mode::temporary) {
  create_tables(database_, Placement(std::nullopt));
  rows_.emplace(database_, description_);
  database_.execute("BEGIN");
}

void AssessmentSpool::for_each(
    const std::function<void(std::int64_t test_id, const std::vector<AssessmentRow>& assessments)>&
        callback) {
  read_all_assessments(database_, callback);
}

}  // namespace jaywalk
