// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/report/tables/tables.h"

namespace jaywalk {
namespace {

/// The behaviours in their order, each with its rows of the comparison.
template <class Each>
void for_each_row(const Comparison& comparison, std::string& text, Each each) {
  const std::string* behaviour = nullptr;
  for (std::size_t row = 0; row < comparison.assessments.size(); ++row) {
    const Summary& summary = comparison.summaries[row];
    if (behaviour == nullptr || *behaviour != summary.behaviour) {
      behaviour = &summary.behaviour;
      text += fmt::format("{}\n", *behaviour);
    }
    each(summary, comparison.assessments[row]);
  }
}

std::string names_of(std::span<const ActorIndex> witnesses, std::span<const Actor> actors) {
  std::vector<std::string_view> names;
  for (const ActorIndex actor : witnesses) names.push_back(actors[actor].name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string verdict_line(const Assertion& assertion, const Judgement& judgement,
                         std::span<const Actor> actors) {
  std::string line = fmt::format("{:<22}  {:<11}", assertion.id, name(judgement.verdict));
  if (judgement.robustness) {
    line += fmt::format("  robustness {:.4g}", *judgement.robustness);
  } else {
    line += fmt::format("  precondition missed by {:.4g}", 0 - judgement.exercised);
  }
  if (judgement.tick) line += fmt::format(", violated at tick {}", *judgement.tick);
  if (!judgement.witnesses.empty()) {
    line += fmt::format(" ({})", names_of(judgement.witnesses, actors));
  }
  return line + '\n';
}

}  // namespace

std::string render_verdicts(const Comparison& comparison) {
  if (comparison.assertions.empty() || comparison.assessments.empty()) return {};
  std::string text = fmt::format("{:<22}  {:>6}  {:>11}  {:>7}  {:>7}  {:>11}\n", "verdicts",
                                 "agents", "exercised %", "pass", "fail", "unavoidable");
  for_each_row(comparison, text, [&](const Summary& summary, const AssessmentSummary& assessment) {
    for (std::size_t i = 0; i < assessment.verdicts.size(); ++i) {
      const VerdictCounts& counts = assessment.verdicts[i];
      text += fmt::format("  {:<20}  {:>6}  {:>11.1f}  {:>7}  {:>7}  {:>11}\n",
                          comparison.assertions[i], summary.agents, exercised_pct(counts),
                          counts.of(Verdict::pass), counts.of(Verdict::fail),
                          counts.of(Verdict::unavoidable));
    }
  });
  return text;
}

std::string render_metrics(const Comparison& comparison) {
  if (comparison.assessments.empty() || comparison.assessments.front().metrics.empty()) return {};
  std::string text = fmt::format("{:<19}  {:>6}  {:>6}  {:>8}  {:>8}  {:>8}  {:>8}\n", "metrics",
                                 "agents", "tests", "mean", "min", "median", "max");
  for_each_row(comparison, text, [&](const Summary& summary, const AssessmentSummary& assessment) {
    for (std::size_t i = 0; i < assessment.metrics.size(); ++i) {
      const Distribution& metric = assessment.metrics[i];
      text +=
          fmt::format("  {:<17}  {:>6}  {:>6}", metrics()[i].name, summary.agents, metric.count);
      for (const double value : {metric.mean, metric.least, metric.median, metric.greatest}) {
        text += metric.count > 0 ? fmt::format("  {:>8.3f}", value) : fmt::format("  {:>8}", "-");
      }
      text += '\n';
    }
  });
  return text;
}

std::string render_tables(const Comparison& comparison) {
  std::string text = render_table(comparison);
  for (const std::string& more : {render_verdicts(comparison), render_metrics(comparison),
                                  render_kills(comparison), render_avs(comparison.avs)}) {
    if (!more.empty()) text += '\n' + more;
  }
  return text;
}

std::string render_assessment(const Criteria& criteria, const TestAssessment& assessment,
                              std::span<const Actor> actors) {
  std::string text;
  for (std::size_t i = 0; i < assessment.judgements.size(); ++i) {
    text += verdict_line(criteria.assertions[i], assessment.judgements[i], actors);
  }
  for (std::size_t i = 0; i < assessment.metrics.size(); ++i) {
    if (!assessment.metrics[i]) continue;
    const MetricValue& value = *assessment.metrics[i];
    const std::string_view unit = metrics()[i].unit;
    text += fmt::format("{:<22}  {:.4g}{}{} at tick {} ({})\n", metrics()[i].name, value.value,
                        unit.empty() ? "" : " ", unit, value.tick, actors[value.actor].name);
  }
  return text;
}

}  // namespace jaywalk
