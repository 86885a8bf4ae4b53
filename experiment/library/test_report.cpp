// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "experiment/compare/measures/measures.h"
#include "experiment/export/comparison_files.h"
#include "experiment/judge/metrics/metrics.h"
#include "experiment/library/library.h"

namespace jaywalk {
namespace {

std::vector<ActorTrack> tracks_of(const Recording& recording) {
  std::vector<ActorTrack> tracks;
  for (const Actor& actor : recording.actors()) {
    tracks.push_back({.name = actor.name,
                      .kind = name(actor.kind),
                      .length_m = actor.length_m,
                      .width_m = actor.width_m,
                      .moments = {}});
  }
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    const std::span<const ActorState> scene = recording.scene(tick);
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      tracks[i].moments.push_back({.x_m = scene[i].x_m,
                                   .y_m = scene[i].y_m,
                                   .speed_mps = scene[i].speed_mps,
                                   .heading_rad = scene[i].heading_rad});
    }
  }
  return tracks;
}

void add_judgements(const Recording& recording, const Criteria& criteria, const Ground& ground,
                    TestReport& report) {
  const TestAssessment found = assess(criteria, recording, ground);
  for (std::size_t i = 0; i < found.judgements.size(); ++i) {
    report.verdicts.push_back({.assertion = criteria.assertions[i].id,
                               .verdict = found.judgements[i].verdict,
                               .robustness = found.judgements[i].robustness,
                               .tick = found.judgements[i].tick});
  }
  for (std::size_t i = 0; i < found.metrics.size(); ++i) {
    const Metric& metric = metrics()[i];
    MetricReading reading{.metric = metric.name, .unit = metric.unit, .value = {}};
    if (found.metrics[i]) reading.value = found.metrics[i]->value;
    report.metrics.push_back(reading);
  }
}

ComparisonRow row_of(const Summary& summary) {
  ComparisonRow row{.behaviour = summary.behaviour,
                    .agents = summary.agents,
                    .tests = summary.tests,
                    .successes = summary.successes,
                    .errored = summary.errored,
                    .measures = {},
                    .verdicts = {}};
  for (const Measure& measure : measures()) row.measures.push_back(measure.estimate(summary));
  return row;
}

std::vector<KillTally> kills_of(const KillMatrix& matrix) {
  std::vector<KillTally> kills;
  for (const KillRow& row : matrix.rows) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const KillCell& cell = row.cells[i];
      if (cell.tests + cell.errored == 0) continue;
      kills.push_back({.behaviour = row.behaviour,
                       .agents = row.agents,
                       .defect = matrix.defects[i],
                       .tests = cell.tests,
                       .kills = cell.kills,
                       .healthy_failures = row.healthy_failures,
                       .first_kill_median = first_kill_median(cell)});
    }
  }
  return kills;
}

}  // namespace

TestReport report_of(const Recording& recording, const Criteria& criteria, const Ground& ground) {
  TestReport report;
  report.tick_s = recording.tick_s();
  report.actors = tracks_of(recording);
  for (const RecordedEvent& event : recording.events()) {
    report.events.push_back(
        {.tick = event.tick,
         .actor = event.actor ? recording.actors()[*event.actor].name : std::string(),
         .kind = event.kind,
         .text = event.text});
  }
  if (criteria.metrics || !criteria.assertions.empty()) {
    add_judgements(recording, criteria, ground, report);
  }
  return report;
}

ComparisonReport report_of(const Comparison& comparison) {
  ComparisonReport report;
  for (std::size_t i = 0; i < comparison.summaries.size(); ++i) {
    ComparisonRow row = row_of(comparison.summaries[i]);
    for (std::size_t k = 0; k < comparison.assertions.size() && i < comparison.assessments.size();
         ++k) {
      row.verdicts.push_back({.assertion = comparison.assertions[k],
                              .tests = comparison.assessments[i].verdicts[k].tests});
    }
    report.rows.push_back(std::move(row));
  }
  report.kills = kills_of(comparison.kills);
  report.is_complete = comparison.complete;
  report.csv = to_csv(comparison);
  report.json = to_json(comparison);
  return report;
}

std::vector<MeasureInfo> measure_list() {
  std::vector<MeasureInfo> list;
  for (const Measure& measure : measures()) {
    list.push_back({.name = measure.name, .summary = measure.summary});
  }
  return list;
}

Estimate ComparisonRow::measure(std::string_view name) const {
  const auto found = std::ranges::find(jaywalk::measures(), name, &Measure::name);
  if (found == jaywalk::measures().end()) return {};
  return measures[static_cast<std::size_t>(found - jaywalk::measures().begin())];
}

}  // namespace jaywalk
