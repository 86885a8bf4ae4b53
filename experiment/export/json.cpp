// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "experiment/compare/measures/measures.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/compare/published/published.h"
#include "experiment/export/comparison_files.h"

namespace jaywalk {
namespace {

using Json = nlohmann::ordered_json;

void add_number(Json& object, std::string_view name, std::optional<double> value) {
  if (name.empty()) return;
  object[std::string(name)] = value ? Json(*value) : Json(nullptr);
}

void add_estimate(Json& object, const Measure& measure, const Estimate& estimate) {
  if (estimate.is_count && estimate.value) {
    object[std::string(measure.column)] = static_cast<std::uint64_t>(*estimate.value);
    return;
  }
  add_number(object, measure.column, estimate.value);
  add_number(object, measure.low_column, estimate.low);
  add_number(object, measure.high_column, estimate.high);
}

Json to_object(const Distribution& metric) {
  Json object = {{"count", metric.count}};
  if (metric.count == 0) return object;
  add_number(object, "mean", metric.mean);
  add_number(object, "min", metric.least);
  add_number(object, "q1", metric.lower_quartile);
  add_number(object, "median", metric.median);
  add_number(object, "q3", metric.upper_quartile);
  add_number(object, "max", metric.greatest);
  return object;
}

/// Verdicts and metrics, if they were asked for. Infinite values become null.
void add_assessments(Json& object, const Comparison& comparison,
                     const AssessmentSummary& assessment) {
  for (std::size_t i = 0; i < assessment.verdicts.size(); ++i) {
    Json& counts = object["verdicts"][comparison.assertions[i]];
    for (std::size_t verdict = 0; verdict < kVerdictCount; ++verdict) {
      counts[std::string(name(static_cast<Verdict>(verdict)))] =
          assessment.verdicts[i].tests[verdict];
    }
    counts["exercised_pct"] = exercised_pct(assessment.verdicts[i]);
  }
  for (std::size_t i = 0; i < assessment.metrics.size(); ++i) {
    object["metrics"][std::string(metrics()[i].name)] = to_object(assessment.metrics[i]);
  }
}

Json to_object(const Summary& summary, const PublishedRows& rows) {
  Json object = {{"behaviour", summary.behaviour},
                 {"agents", summary.agents},
                 {"tests", summary.tests},
                 {"successes", summary.successes}};
  Json published = Json::object();
  for (const Measure& measure : measures()) {
    add_estimate(object, measure, measure.estimate(summary));
    const auto figure = published_figure(rows, measure, summary.behaviour, summary.agents);
    if (figure) add_estimate(published, measure, *figure);
  }
  if (!published.empty()) object["published"] = std::move(published);
  return object;
}

Json to_object(const SharedCause& shared) {
  const DropCause& cause = shared.cause;
  return {{"error", cause.error},   {"file", cause.file},       {"line", cause.line},
          {"column", cause.column}, {"formula", cause.formula}, {"message", cause.message},
          {"goals", cause.goals},   {"agents", shared.agents},  {"times", cause.times}};
}

Json to_object(const Troubles& troubles) {
  Json causes = Json::array();
  for (const SharedCause& each : troubles.causes) causes.push_back(to_object(each));
  Json object = {{"agents", troubles.agents},
                 {"dropped_an_intention", troubles.dropping},
                 {"pedestrians", troubles.pedestrians},
                 {"never_acted", troubles.idle},
                 {"causes", std::move(causes)}};
  for (const SharedError& each : troubles.errors) {
    object["errors"].push_back(
        {{"message", each.message}, {"tests", each.tests}, {"first_test", each.first_test}});
  }
  return object;
}

Json to_object(const KillCell& cell, const std::string& defect) {
  const ConfidenceInterval interval = wilson_interval(cell.kills, cell.tests);
  Json object = {{"defect", defect}, {"tests", cell.tests}, {"kills", cell.kills}};
  if (cell.errored > 0) object["errored"] = cell.errored;
  add_number(object, "low", 100 * interval.low);
  add_number(object, "high", 100 * interval.high);
  object["first_kill"] = cell.first ? Json(*cell.first) : Json(nullptr);
  const auto median = first_kill_median(cell);
  object["first_kill_median"] = median ? Json(*median) : Json(nullptr);
  return object;
}

Json to_object(const KillRow& row, const KillMatrix& matrix) {
  Json cells = Json::array();
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    if (row.cells[i].tests > 0) cells.push_back(to_object(row.cells[i], matrix.defects[i]));
  }
  const auto median = first_kill_median(row);
  return {{"behaviour", row.behaviour},
          {"agents", row.agents},
          {"kills", row.kills()},
          {"kill_pct", kill_pct(row)},
          {"defects_killed", row.killed()},
          {"first_kill_median", median ? Json(*median) : Json(nullptr)},
          {"healthy_failures", row.healthy_failures},
          {"defects", std::move(cells)}};
}

Json to_object(const AvCell& cell, const std::string& av, bool judged) {
  Json object = {{"av", av},
                 {"tests", cell.tests},
                 {"errored", cell.errored},
                 {"successes", cell.successes},
                 {"collisions", cell.collisions}};
  if (judged) {
    object["avoidable"] = cell.avoidable;
    object["unavoidable"] = cell.unavoidable;
  }
  const auto impact = cell.mean_impact_mps();
  object["mean_impact_mps"] = impact ? Json(*impact) : Json(nullptr);
  return object;
}

Json to_object(const AvRanking& ranking) {
  Json rank = Json::array();
  for (const RankedAv& av : ranked(ranking)) {
    rank.push_back(to_object(av.all, av.name, ranking.judged));
  }
  Json rows = Json::array();
  for (const AvRow& row : ranking.rows) {
    Json cells = Json::array();
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].tests == 0) continue;
      cells.push_back(to_object(row.cells[i], ranking.avs[i], ranking.judged));
    }
    rows.push_back(
        {{"behaviour", row.behaviour}, {"agents", row.agents}, {"avs", std::move(cells)}});
  }
  return {{"rank", std::move(rank)}, {"rows", std::move(rows)}};
}

Json to_object(const KillMatrix& matrix) {
  Json rows = Json::array();
  for (const KillRow& row : matrix.rows) rows.push_back(to_object(row, matrix));
  Json team = Json::array();
  for (const std::size_t row : smallest_team(matrix)) {
    team.push_back(
        {{"behaviour", matrix.rows[row].behaviour}, {"agents", matrix.rows[row].agents}});
  }
  Json alive = Json::array();
  for (const std::size_t defect : survivors(matrix)) alive.push_back(matrix.defects[defect]);
  return {{"defects", matrix.defects},
          {"rows", std::move(rows)},
          {"smallest_team", std::move(team)},
          {"survivors", std::move(alive)}};
}

}  // namespace

std::string to_json(const Comparison& comparison) {
  Json results = Json::array();
  for (std::size_t row = 0; row < comparison.summaries.size(); ++row) {
    results.push_back(to_object(comparison.summaries[row], comparison.published));
    if (!comparison.assessments.empty()) {
      add_assessments(results.back(), comparison, comparison.assessments[row]);
    }
    if (row < comparison.troubles.size()) {
      results.back()["what_happened_to_agents"] = to_object(comparison.troubles[row]);
    }
  }
  Json document = {{"scenario", comparison.scenario},
                   {"seed", comparison.seed},
                   {"tests", comparison.tests},
                   {"complete", comparison.complete}};
  if (!comparison.published.left_out.empty()) {
    document["published_left_out"] = comparison.published.left_out;
  }
  document["results"] = std::move(results);
  if (!comparison.avs.empty()) document["avs"] = to_object(comparison.avs);
  if (!comparison.kills.empty()) document["kills"] = to_object(comparison.kills);
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace jaywalk
