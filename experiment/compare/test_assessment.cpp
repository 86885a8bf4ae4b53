// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/test_assessment.h"

#include <algorithm>
#include <array>

namespace jaywalk {
namespace {

constexpr std::array<std::string_view, 5> kStoredVerdicts = {"none", "vacuous", "pass", "fail",
                                                             "unavoidable"};

StoredVerdict stored(Verdict verdict) {
  switch (verdict) {
    case Verdict::vacuous:
      return StoredVerdict::vacuous;
    case Verdict::pass:
      return StoredVerdict::pass;
    case Verdict::fail:
      return StoredVerdict::fail;
    case Verdict::unavoidable:
      return StoredVerdict::unavoidable;
  }
  return StoredVerdict::none;
}

Verdict verdict_of(StoredVerdict verdict) {
  switch (verdict) {
    case StoredVerdict::pass:
      return Verdict::pass;
    case StoredVerdict::fail:
      return Verdict::fail;
    case StoredVerdict::unavoidable:
      return Verdict::unavoidable;
    case StoredVerdict::none:
    case StoredVerdict::vacuous:
      break;
  }
  return Verdict::vacuous;
}

}  // namespace

std::string_view name(StoredVerdict verdict) {
  return kStoredVerdicts[static_cast<std::size_t>(verdict)];
}

std::optional<StoredVerdict> parse_stored_verdict(std::string_view text) {
  const auto found = std::ranges::find(kStoredVerdicts, text);
  if (found == kStoredVerdicts.end()) return std::nullopt;
  return static_cast<StoredVerdict>(found - kStoredVerdicts.begin());
}

std::vector<std::string> ids_of(const Criteria& criteria) {
  std::vector<std::string> ids;
  for (const Assertion& assertion : criteria.assertions) ids.push_back(assertion.id);
  return ids;
}

TestAssessment assess(const Criteria& criteria, const Recording& recording, const Ground& ground) {
  const TestView view(recording, ground);
  TestAssessment assessment;
  for (const Assertion& assertion : criteria.assertions) {
    assessment.judgements.push_back(judge(assertion, view));
  }
  if (criteria.metrics) assessment.metrics = measured_all(view);
  return assessment;
}

std::vector<AssessmentRow> to_rows(const Criteria& criteria, const TestAssessment& assessment) {
  std::vector<AssessmentRow> rows;
  for (std::size_t i = 0; i < assessment.judgements.size(); ++i) {
    const Judgement& judgement = assessment.judgements[i];
    AssessmentRow row{.id = criteria.assertions[i].id,
                      .tick = judgement.tick,
                      .robustness = judgement.robustness,
                      .verdict = stored(judgement.verdict)};
    if (!judgement.witnesses.empty()) row.actor = judgement.witnesses.front();
    rows.push_back(std::move(row));
  }
  for (std::size_t i = 0; i < assessment.metrics.size(); ++i) {
    if (!assessment.metrics[i]) continue;
    const MetricValue& value = *assessment.metrics[i];
    rows.push_back({.id = std::string(metrics()[i].name),
                    .value = value.value,
                    .tick = value.tick,
                    .actor = value.actor});
  }
  return rows;
}

TestAssessment from_rows(std::span<const AssessmentRow> rows,
                         std::span<const std::string> assertions) {
  TestAssessment assessment;
  for (const std::string& id : assertions) {
    Judgement& judgement = assessment.judgements.emplace_back();
    const auto row = std::ranges::find(rows, id, &AssessmentRow::id);
    if (row == rows.end()) continue;
    judgement.verdict = verdict_of(row->verdict);
    judgement.robustness = row->robustness;
    judgement.tick = row->tick;
    if (row->actor) judgement.witnesses = {*row->actor};
  }
  std::vector<std::optional<MetricValue>> values;
  bool any = false;
  for (const Metric& metric : metrics()) {
    const auto row = std::ranges::find(rows, metric.name, &AssessmentRow::id);
    values.emplace_back();
    if (row == rows.end() || !row->value) continue;
    values.back() = {*row->value, row->tick.value_or(0), row->actor.value_or(0)};
    any = true;
  }
  if (any) assessment.metrics = std::move(values);
  return assessment;
}

std::uint64_t VerdictCounts::exercised() const { return all() - of(Verdict::vacuous); }

std::uint64_t VerdictCounts::all() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : tests) sum += count;
  return sum;
}

double exercised_pct(const VerdictCounts& counts) {
  if (counts.all() == 0) return 0;
  return 100 * static_cast<double>(counts.exercised()) / static_cast<double>(counts.all());
}

AssessmentTable::AssessmentTable(const Criteria& criteria, const ExperimentPlan& plan)
    : assertions_(criteria.assertions.size()),
      agents_(plan.agents),
      cells_(plan.behaviours.size() * plan.agents.size(),
             {.verdicts = std::vector<VerdictCounts>(assertions_)}),
      values_(first_column(cells_.size())) {}

std::size_t AssessmentTable::cell_index(std::size_t behaviour, std::uint32_t agents) const {
  const auto column =
      static_cast<std::size_t>(std::ranges::find(agents_, agents) - agents_.begin());
  return behaviour * agents_.size() + column;
}

std::size_t AssessmentTable::first_column(std::size_t cell) const {
  return cell * (assertions_ + metrics().size());
}

void AssessmentTable::add(const TestKey& test, const TestAssessment& assessment) {
  const std::size_t index = cell_index(test.behaviour, test.agents);
  const std::size_t first = first_column(index);
  const std::lock_guard lock(mutex_);
  Cell& cell = cells_[index];
  for (std::size_t i = 0; i < assessment.judgements.size(); ++i) {
    const Judgement& judgement = assessment.judgements[i];
    ++cell.verdicts[i].tests[static_cast<std::size_t>(judgement.verdict)];
    if (judgement.robustness) values_.add(first + i, *judgement.robustness);
  }
  if (!assessment.metrics.empty()) cell.measured = true;
  for (std::size_t i = 0; i < assessment.metrics.size(); ++i) {
    if (assessment.metrics[i]) values_.add(first + assertions_ + i, assessment.metrics[i]->value);
  }
}

AssessmentSummary AssessmentTable::summary(std::size_t behaviour, std::uint32_t agents) const {
  const std::size_t index = cell_index(behaviour, agents);
  const std::size_t first = first_column(index);
  const std::lock_guard lock(mutex_);
  AssessmentSummary result{.verdicts = cells_[index].verdicts};
  for (std::size_t i = 0; i < assertions_; ++i) {
    result.robustness.push_back(values_.distribution(first + i));
  }
  const std::size_t measured = cells_[index].measured ? metrics().size() : 0;
  for (std::size_t i = 0; i < measured; ++i) {
    result.metrics.push_back(values_.distribution(first + assertions_ + i));
  }
  return result;
}

}  // namespace jaywalk
