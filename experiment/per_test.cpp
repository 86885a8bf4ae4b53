#include "experiment/per_test.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "experiment/export/csv_fields.h"

namespace jaywalk {

PerTestTable::PerTestTable(const ExperimentPlan& plan, std::vector<std::string> assertions)
    : plan_(plan), assertions_(std::move(assertions)) {}

void PerTestTable::add(const TestCase& test, const TestOutcome& outcome,
                       const TestFindings& findings) {
  Row row{.test = test, .outcome = outcome, .verdicts = {}};
  for (const Judgement& judgement : findings.judgements) row.verdicts.push_back(judgement.verdict);
  const std::lock_guard lock(mutex_);
  rows_.push_back(std::move(row));
}

std::string PerTestTable::line(const Row& row, std::uint64_t first_test) const {
  std::string text =
      fmt::format("{},{}", csv_quoted(plan_.behaviours[row.test.behaviour]), row.test.agents);
  if (plan_.vehicles.size() > 1) text += ',' + plan_.vehicles[row.test.vehicle];
  const TestOutcome& outcome = row.outcome;
  text += fmt::format(",{},{},{},", row.test.number + first_test, outcome.ended_by, outcome.ticks);
  if (outcome.precondition_ticks) text += std::to_string(*outcome.precondition_ticks);
  text += outcome.impact_mps ? ",1" : ",0";
  add_csv_field(text, outcome.impact_mps);
  for (const Verdict verdict : row.verdicts) text += fmt::format(",{}", name(verdict));
  // An errored test is not judged.
  for (std::size_t i = row.verdicts.size(); i < assertions_.size(); ++i) text += ',';
  return text + '\n';
}

std::string PerTestTable::csv(std::uint64_t first_test) const {
  std::string text = "behaviour,agents,";
  if (plan_.vehicles.size() > 1) text += "vehicle,";
  text += "test,ended_by,ticks,precondition_ticks,collision,impact_mps";
  for (const std::string& id : assertions_) text += ',' + id;
  text += '\n';
  std::vector<const Row*> rows;
  for (const Row& row : rows_) rows.push_back(&row);
  std::ranges::sort(rows, {}, [&](const Row* row) {
    return std::pair(plan_.cell_of(row->test), row->test.number);
  });
  for (const Row* row : rows) text += line(*row, first_test);
  return text;
}

}  // namespace jaywalk
