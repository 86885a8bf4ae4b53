// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/per_test.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "experiment/judge/csv_line.h"

namespace jaywalk {

PerTestLines::PerTestLines(const ExperimentPlan& plan, std::vector<std::string> assertions)
    : plan_(plan), assertions_(std::move(assertions)) {}

std::string PerTestLines::header() const {
  std::string text = "behaviour,agents,";
  if (plan_.vehicles.size() > 1) text += "vehicle,";
  text += "test,ended_by,ticks,precondition_ticks,collision,impact_mps";
  for (const std::string& id : assertions_) text += ',' + id;
  return text + '\n';
}

std::string PerTestLines::line(const TestKey& test, const TestOutcome& outcome,
                               std::span<const Verdict> verdicts) const {
  std::string text =
      fmt::format("{},{}", csv_quoted(plan_.behaviours[test.behaviour]), test.agents);
  if (plan_.vehicles.size() > 1) text += ',' + csv_quoted(plan_.vehicles[test.vehicle]);
  text += fmt::format(",{},{},{},", test.number, csv_quoted(outcome.ended_by), outcome.ticks);
  if (outcome.precondition_ticks) text += std::to_string(*outcome.precondition_ticks);
  text += outcome.impact_mps ? ",1" : ",0";
  add_csv_field(text, outcome.impact_mps);
  for (const Verdict verdict : verdicts) text += fmt::format(",{}", name(verdict));
  // An errored test is not judged.
  for (std::size_t i = verdicts.size(); i < assertions_.size(); ++i) text += ',';
  return text + '\n';
}

std::vector<Verdict> verdicts_of(const TestAssessment& assessment) {
  std::vector<Verdict> verdicts;
  for (const Judgement& judgement : assessment.judgements) verdicts.push_back(judgement.verdict);
  return verdicts;
}

PerTestTable::PerTestTable(const ExperimentPlan& plan, std::vector<std::string> assertions)
    : plan_(plan), lines_(plan, std::move(assertions)) {}

void PerTestTable::add(const TestKey& test, const TestOutcome& outcome,
                       const TestAssessment& assessment) {
  const std::lock_guard lock(mutex_);
  rows_.push_back({.test = test, .outcome = outcome, .verdicts = verdicts_of(assessment)});
}

std::string PerTestTable::csv() const {
  std::vector<const Row*> rows;
  for (const Row& row : rows_) rows.push_back(&row);
  std::ranges::sort(rows, {}, [&](const Row* row) {
    return std::pair(plan_.cell_of(row->test), row->test.number);
  });
  std::string text = lines_.header();
  for (const Row* row : rows) text += lines_.line(row->test, row->outcome, row->verdicts);
  return text;
}

}  // namespace jaywalk
