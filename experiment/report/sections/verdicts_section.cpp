// SPDX-License-Identifier: Apache-2.0
// The section about assertions: verdicts, robustness, and the tests that violate them most.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

/// As they are stacked, from left to right.
const std::vector<Verdict> kOrder = {Verdict::pass, Verdict::fail, Verdict::unavoidable,
                                     Verdict::vacuous};

std::vector<std::string> classes() {
  std::vector<std::string> names;
  for (const Verdict verdict : kOrder) names.emplace_back(name(verdict));
  return names;
}

std::string key() {
  std::string html = "<p class=\"note\">";
  for (const Verdict verdict : kOrder) {
    html += fmt::format("<span class=\"key part-{0}\"></span>{0} &nbsp; ", name(verdict));
  }
  return html + "</p>\n";
}

/// All numbers of agents together.
std::vector<Bar> bars_of(const Comparison& comparison, std::size_t assertion) {
  std::vector<Bar> bars;
  for (const std::string& behaviour : behaviours_of(comparison)) {
    Bar bar{.name = behaviour, .parts = std::vector<double>(kOrder.size())};
    for (std::size_t row = 0; row < comparison.assessments.size(); ++row) {
      if (comparison.summaries[row].behaviour != behaviour) continue;
      const VerdictCounts& counts = comparison.assessments[row].verdicts[assertion];
      for (std::size_t i = 0; i < kOrder.size(); ++i) {
        bar.parts[i] += static_cast<double>(counts.of(kOrder[i]));
      }
    }
    bars.push_back(std::move(bar));
  }
  return bars;
}

const Assertion* definition(const ReportData& data, const std::string& id) {
  const auto found = std::ranges::find(data.assertions, id, &Assertion::id);
  return found == data.assertions.end() ? nullptr : &*found;
}

std::string caption(const ReportData& data, const std::string& id) {
  const Assertion* assertion = definition(data, id);
  if (assertion == nullptr) return escaped(id);
  std::string said = escaped(assertion->summary);
  if (!assertion->source.empty()) {
    said += fmt::format("{}{}", said.empty() ? "" : " — ", escaped(assertion->source));
  }
  return fmt::format("{}<small>{}, {}</small>", escaped(id), name(assertion->severity), said);
}

std::string verdict_numbers(const Comparison& comparison, std::size_t assertion) {
  Table table;
  table.columns({"agents", "exercised, %", "pass", "fail", "unavoidable", "vacuous",
                 "robustness: least", "median", "greatest"});
  const std::string* behaviour = nullptr;
  for (std::size_t row = 0; row < comparison.assessments.size(); ++row) {
    const Summary& summary = comparison.summaries[row];
    const AssessmentSummary& assessment = comparison.assessments[row];
    const VerdictCounts& counts = assessment.verdicts[assertion];
    if (behaviour == nullptr || *behaviour != summary.behaviour) table.heading(summary.behaviour);
    behaviour = &summary.behaviour;
    std::vector<std::string> cells{std::to_string(summary.agents),
                                   decimal(exercised_pct(counts), 1)};
    for (const Verdict verdict : kOrder) cells.push_back(grouped(counts.of(verdict)));
    const Distribution& robustness = assessment.robustness[assertion];
    for (const double value : {robustness.least, robustness.median, robustness.greatest}) {
      cells.push_back(robustness.count == 0 ? "–" : decimal(value, 3));
    }
    table.row(std::move(cells));
  }
  return table.html();
}

/// The test's number, as a link to the violation's tick on the page that replays the test, if that
/// page was written.
std::string test_cell(const ReportData& data, const Violation& violation) {
  std::string number = std::to_string(violation.test.number);
  const ReplayLink* replay = find_replay(data, violation.test);
  if (replay == nullptr || replay->page.empty()) return number;
  const std::string tick = violation.tick ? fmt::format("#tick={}", *violation.tick) : "";
  return fmt::format("<a href=\"{}{}\">{}</a>", escaped_uri(replay->page), tick, number);
}

std::string violations(const ReportData& data) {
  if (data.violations.empty()) return {};
  Table table;
  table.column("behaviour", Align::left);
  table.columns({"agents", "test", "robustness", "violated at tick"});
  table.column("witness", Align::left);
  const std::string* last = nullptr;
  for (const Violation& violation : data.violations) {
    if (last == nullptr || *last != violation.assertion) table.heading(violation.assertion);
    last = &violation.assertion;
    table.row({escaped(data.description.behaviours[violation.test.behaviour].name),
               std::to_string(violation.test.agents), test_cell(data, violation),
               decimal(violation.robustness, 3),
               violation.tick ? std::to_string(*violation.tick) : "–",
               violation.witness.empty() ? "–" : escaped(violation.witness)});
  }
  return "<h3>Each behaviour’s worst violation</h3>\n" + table.html();
}

}  // namespace

std::string section::verdicts(const ReportData& data) {
  const Comparison& comparison = data.comparison;
  if (comparison.assertions.empty() || comparison.assessments.empty()) {
    return paragraph(
        data.store == nullptr
            ? "None were judged: <code>--assertions FILE</code> judges each test."
            : fmt::format("None are in the store: <code>jaywalk judge {} --assertions FILE "
                          "--write</code> judges its tests and adds the verdicts.",
                          escaped(data.store_path)));
  }
  std::string figures;
  std::string tables;
  for (std::size_t i = 0; i < comparison.assertions.size(); ++i) {
    figures += figure(caption(data, comparison.assertions[i]),
                      stacked_bars(classes(), bars_of(comparison, i)));
    tables += details(comparison.assertions[i], verdict_numbers(comparison, i));
  }
  return paragraph(
             "Shares of the tests, all numbers of agents together. Vacuous: the precondition was "
             "not met, so nothing was asked of the vehicle. Unavoidable: a careful driver could "
             "not have kept the requirement either.") +
         key() + gallery(figures) + violations(data) + "<h3>The same as tables</h3>\n" + tables;
}

}  // namespace jaywalk::reporting
