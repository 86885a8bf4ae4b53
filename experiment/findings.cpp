#include "experiment/findings.h"

#include <algorithm>
#include <cmath>

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

/// Of ascending values.
double quantile(const std::vector<double>& values, double part) {
  const double at = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double rest = at - static_cast<double>(below);
  if (rest == 0 || values[below] == values[above]) return values[below];
  return values[below] + rest * (values[above] - values[below]);
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

Distribution distribution(std::vector<double> values) {
  Distribution result{.count = values.size()};
  if (values.empty()) return result;
  std::ranges::sort(values);
  for (const double value : values) result.mean += value;
  result.mean /= static_cast<double>(values.size());
  result.least = values.front();
  result.lower_quartile = quantile(values, 0.25);
  result.median = quantile(values, 0.5);
  result.upper_quartile = quantile(values, 0.75);
  result.greatest = values.back();
  return result;
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
      tests_(plan.tests),
      cells_(plan.behaviours.size() * plan.agents.size()) {}

std::size_t FindingsTable::cell_index(std::size_t behaviour, std::uint32_t agents) const {
  const auto column =
      static_cast<std::size_t>(std::ranges::find(agents_, agents) - agents_.begin());
  return behaviour * agents_.size() + column;
}

void FindingsTable::add(const TestCase& test, const TestFindings& findings) {
  Cell& cell = cells_[cell_index(test.behaviour, test.agents)];
  std::call_once(cell.started, [&] { cell.tests.resize(tests_); });
  Row& row = cell.tests[test.number];
  row = {};
  for (const Judgement& judgement : findings.judgements) {
    row.verdicts.push_back(judgement.verdict);
    row.robustness.push_back(judgement.robustness);
  }
  for (const auto& value : findings.metrics) {
    row.metrics.push_back(value ? std::optional(value->value) : std::nullopt);
  }
}

FindingsSummary FindingsTable::summary(std::size_t behaviour, std::uint32_t agents) const {
  FindingsSummary result;
  result.verdicts.resize(assertions_);
  std::vector<std::vector<double>> values;
  std::vector<std::vector<double>> robustness(assertions_);
  for (const Row& row : cells_[cell_index(behaviour, agents)].tests) {
    for (std::size_t i = 0; i < row.verdicts.size(); ++i) {
      ++result.verdicts[i].tests[static_cast<std::size_t>(row.verdicts[i])];
      if (row.robustness[i]) robustness[i].push_back(*row.robustness[i]);
    }
    values.resize(std::max(values.size(), row.metrics.size()));
    for (std::size_t i = 0; i < row.metrics.size(); ++i) {
      if (row.metrics[i]) values[i].push_back(*row.metrics[i]);
    }
  }
  for (std::vector<double>& each : values) result.metrics.push_back(distribution(std::move(each)));
  for (std::vector<double>& each : robustness) {
    result.robustness.push_back(distribution(std::move(each)));
  }
  return result;
}

}  // namespace jaywalk
