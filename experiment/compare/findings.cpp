#include "experiment/compare/findings.h"

#include <algorithm>

namespace jaywalk {
namespace {

AssessmentVerdict stored(Verdict verdict) {
  switch (verdict) {
    case Verdict::vacuous:
      return AssessmentVerdict::vacuous;
    case Verdict::pass:
      return AssessmentVerdict::pass;
    case Verdict::fail:
      return AssessmentVerdict::fail;
    case Verdict::unavoidable:
      return AssessmentVerdict::unavoidable;
  }
  return AssessmentVerdict::none;
}

Verdict verdict_of(AssessmentVerdict verdict) {
  switch (verdict) {
    case AssessmentVerdict::pass:
      return Verdict::pass;
    case AssessmentVerdict::fail:
      return Verdict::fail;
    case AssessmentVerdict::unavoidable:
      return Verdict::unavoidable;
    case AssessmentVerdict::none:
    case AssessmentVerdict::vacuous:
      break;
  }
  return Verdict::vacuous;
}

}  // namespace

std::vector<std::string> ids_of(const Inquiry& inquiry) {
  std::vector<std::string> ids;
  for (const Assertion& assertion : inquiry.assertions) ids.push_back(assertion.id);
  return ids;
}

TestFindings assess(const Inquiry& inquiry, const Recording& recording, const Ground& ground) {
  const TestView view(recording, ground);
  TestFindings findings;
  for (const Assertion& assertion : inquiry.assertions) {
    findings.judgements.push_back(judge(assertion, view));
  }
  if (inquiry.metrics) findings.metrics = measured_all(view);
  return findings;
}

std::vector<Assessment> to_assessments(const Inquiry& inquiry, const TestFindings& findings) {
  std::vector<Assessment> rows;
  for (std::size_t i = 0; i < findings.judgements.size(); ++i) {
    const Judgement& judgement = findings.judgements[i];
    Assessment row{.id = inquiry.assertions[i].id,
                   .tick = judgement.tick,
                   .robustness = judgement.robustness,
                   .verdict = stored(judgement.verdict)};
    if (!judgement.witnesses.empty()) row.actor = judgement.witnesses.front();
    rows.push_back(std::move(row));
  }
  for (std::size_t i = 0; i < findings.metrics.size(); ++i) {
    if (!findings.metrics[i]) continue;
    const MetricValue& value = *findings.metrics[i];
    rows.push_back({.id = std::string(metrics()[i].name),
                    .value = value.value,
                    .tick = value.tick,
                    .actor = value.actor});
  }
  return rows;
}

TestFindings from_assessments(std::span<const Assessment> rows,
                              std::span<const std::string> assertions) {
  TestFindings findings;
  for (const std::string& id : assertions) {
    Judgement& judgement = findings.judgements.emplace_back();
    const auto row = std::ranges::find(rows, id, &Assessment::id);
    if (row == rows.end()) continue;
    judgement.verdict = verdict_of(row->verdict);
    judgement.robustness = row->robustness;
    judgement.tick = row->tick;
    if (row->actor) judgement.witnesses = {*row->actor};
  }
  std::vector<std::optional<MetricValue>> values;
  bool any = false;
  for (const Metric& metric : metrics()) {
    const auto row = std::ranges::find(rows, metric.name, &Assessment::id);
    values.emplace_back();
    if (row == rows.end() || !row->value) continue;
    values.back() = {*row->value, row->tick.value_or(0), row->actor.value_or(0)};
    any = true;
  }
  if (any) findings.metrics = std::move(values);
  return findings;
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

FindingsTable::FindingsTable(const Inquiry& inquiry, const ExperimentPlan& plan)
    : assertions_(inquiry.assertions.size()),
      agents_(plan.agents),
      cells_(plan.behaviours.size() * plan.agents.size(),
             {.verdicts = std::vector<VerdictCounts>(assertions_)}),
      values_(first_column(cells_.size())) {}

std::size_t FindingsTable::cell_index(std::size_t behaviour, std::uint32_t agents) const {
  const auto column =
      static_cast<std::size_t>(std::ranges::find(agents_, agents) - agents_.begin());
  return behaviour * agents_.size() + column;
}

std::size_t FindingsTable::first_column(std::size_t cell) const {
  return cell * (assertions_ + metrics().size());
}

void FindingsTable::add(const TestCase& test, const TestFindings& findings) {
  const std::size_t index = cell_index(test.behaviour, test.agents);
  const std::size_t first = first_column(index);
  const std::lock_guard lock(mutex_);
  Cell& cell = cells_[index];
  for (std::size_t i = 0; i < findings.judgements.size(); ++i) {
    const Judgement& judgement = findings.judgements[i];
    ++cell.verdicts[i].tests[static_cast<std::size_t>(judgement.verdict)];
    if (judgement.robustness) values_.add(first + i, *judgement.robustness);
  }
  if (!findings.metrics.empty()) cell.measured = true;
  for (std::size_t i = 0; i < findings.metrics.size(); ++i) {
    if (findings.metrics[i]) values_.add(first + assertions_ + i, findings.metrics[i]->value);
  }
}

FindingsSummary FindingsTable::summary(std::size_t behaviour, std::uint32_t agents) const {
  const std::size_t index = cell_index(behaviour, agents);
  const std::size_t first = first_column(index);
  const std::lock_guard lock(mutex_);
  FindingsSummary result{.verdicts = cells_[index].verdicts};
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
