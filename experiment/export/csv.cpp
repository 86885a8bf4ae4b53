// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/export/comparison_files.h"
#include "experiment/judge/csv_line.h"

namespace jaywalk {
namespace {

std::string findings_heading(const Comparison& comparison) {
  std::string text;
  if (comparison.assessments.empty()) return text;
  for (const std::string& id : comparison.assertions) {
    for (std::size_t i = 0; i < kVerdictCount; ++i) {
      text += fmt::format(",{}_{}", id, name(static_cast<Verdict>(i)));
    }
  }
  if (comparison.assessments.front().metrics.empty()) return text;
  for (const Metric& metric : metrics()) {
    for (const std::string_view column : {"count", "mean", "min", "q1", "median", "q3", "max"}) {
      text += fmt::format(",{}_{}", metric.name, column);
    }
  }
  return text;
}

std::string assessment_fields(const AssessmentSummary& assessment) {
  std::string text;
  for (const VerdictCounts& counts : assessment.verdicts) {
    for (const std::uint64_t count : counts.tests) text += fmt::format(",{}", count);
  }
  for (const Distribution& metric : assessment.metrics) {
    text += fmt::format(",{}", metric.count);
    for (const double value : {metric.mean, metric.least, metric.lower_quartile, metric.median,
                               metric.upper_quartile, metric.greatest}) {
      add_csv_field(text, metric.count > 0 ? std::optional(value) : std::nullopt);
    }
  }
  return text;
}

}  // namespace

std::string to_csv(const Comparison& comparison) {
  std::string text = "behaviour,agents,tests,successes";
  for (const Measure& measure : measures()) {
    for (const auto column : {measure.column, measure.low_column, measure.high_column}) {
      if (!column.empty()) text += fmt::format(",{}", column);
    }
  }
  text += findings_heading(comparison) + '\n';
  for (std::size_t row = 0; row < comparison.summaries.size(); ++row) {
    const Summary& summary = comparison.summaries[row];
    text += fmt::format("{},{},{},{}", csv_quoted(summary.behaviour), summary.agents, summary.tests,
                        summary.successes);
    for (const Measure& measure : measures()) {
      const Estimate estimate = measure.estimate(summary);
      add_csv_field(text, estimate.value);
      if (!measure.low_column.empty()) add_csv_field(text, estimate.low);
      if (!measure.high_column.empty()) add_csv_field(text, estimate.high);
    }
    if (!comparison.assessments.empty()) text += assessment_fields(comparison.assessments[row]);
    text += '\n';
  }
  return text;
}

}  // namespace jaywalk
