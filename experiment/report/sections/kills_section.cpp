// SPDX-License-Identifier: Apache-2.0
// Which behaviours expose which defects of the AV.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/compare/kills/kills.h"
#include "experiment/compare/kills/predictors.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

std::string name_of(const KillRow& row) {
  return fmt::format("{} ({})", escaped(row.behaviour), row.agents);
}

std::string limited(std::optional<std::uint64_t> count, std::uint64_t tests) {
  return count ? grouped(*count) : fmt::format("&gt; {}", grouped(tests));
}

/// A cell of the matrix: the share, on a ground that is the stronger the greater it is.
std::string heat_cell(const KillCell& cell) {
  if (cell.tests == 0) return "–";
  if (cell.kills == 0) return "<span class=\"note\">0</span>";
  const double share = static_cast<double>(cell.kills) / static_cast<double>(cell.tests);
  const ConfidenceInterval interval = wilson_interval(cell.kills, cell.tests);
  return fmt::format(
      "<span class=\"share\" style=\"--share:{:.2f}\" title=\"{} of {} tests ({:.1f} to {:.1f} %), "
      "first kill after {}\">{:.1f}</span>",
      std::max(0.08, share), cell.kills, cell.tests, 100 * interval.low, 100 * interval.high,
      limited(first_kill_median(cell), cell.tests), 100 * share);
}

std::string matrix_table(const KillMatrix& matrix) {
  Table table;
  table.column("defect", Align::left);
  for (const KillRow& row : matrix.rows) table.column(name_of(row));
  for (std::size_t defect = 0; defect < matrix.defects.size(); ++defect) {
    std::vector<std::string> cells{escaped(matrix.defects[defect])};
    for (const KillRow& row : matrix.rows) cells.push_back(heat_cell(row.cells[defect]));
    table.row(std::move(cells));
  }
  return table.html();
}

std::string summary_table(const Comparison& comparison) {
  Table table;
  table.column("behaviour (agents)", Align::left);
  table.columns({"accuracy, %", "score", "kills", "kill %", "defects killed", "first kill",
                 "healthy to blame"});
  for (const KillRow& row : comparison.kills.rows) {
    const Summary* summary =
        row.kills_alone ? nullptr : find_summary(comparison, row.behaviour, row.agents);
    if ((summary == nullptr && !row.kills_alone) || row.tests() == 0) continue;
    const auto measured = [&](std::string_view measure) {
      return summary == nullptr ? std::string("–")
                                : decimal(find_measure(measure)->estimate(*summary).value, 1);
    };
    table.row({name_of(row), measured("accuracy"), measured("score"), grouped(row.kills()),
               decimal(kill_pct(row), 2), fmt::format("{} of {}", row.killed(), row.cells.size()),
               limited(first_kill_median(row), row.tests_of_each()),
               row.kills_alone ? std::string("–") : grouped(row.healthy_failures)});
  }
  return table.html();
}

/// Some numbers of tests from 1 to all, closer together where the curves are steep.
std::vector<std::uint64_t> budgets(std::uint64_t tests) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t number = 1; number < tests; number += std::max<std::uint64_t>(1, number / 6)) {
    numbers.push_back(number);
  }
  numbers.push_back(tests);
  return numbers;
}

std::string mutation_scores(const KillMatrix& matrix, const std::vector<std::string>& behaviours,
                            std::uint32_t agents) {
  std::vector<PlotSeries> all;
  double longest = 2;
  for (const KillRow& row : matrix.rows) {
    const std::uint64_t tests = row.tests_of_each();
    if (row.agents != agents || tests == 0 || row.kills_alone) continue;
    PlotSeries series{.name = row.behaviour,
                      .number = static_cast<std::size_t>(
                          std::ranges::find(behaviours, row.behaviour) - behaviours.begin())};
    for (const std::uint64_t budget : budgets(tests)) {
      series.points.push_back(
          {.x = static_cast<double>(budget), .y = 100 * mutation_score(row, budget)});
    }
    longest = std::max(longest, static_cast<double>(tests));
    all.push_back(std::move(series));
  }
  if (all.empty()) return {};
  return figure(fmt::format("defects killed, %, {}", plural(agents, "agent")),
                curves({.x_title = "tests",
                        .y_title = "expected share of defects killed, %",
                        .least = 0,
                        .most = 100,
                        .x_most = longest},
                       all));
}

std::string team_text(const KillMatrix& matrix) {
  std::string names;
  for (const std::size_t row : smallest_team(matrix)) {
    names += (names.empty() ? "" : ", ") + name_of(matrix.rows[row]);
  }
  return names.empty() ? "nobody kills any" : names;
}

std::string survivors_text(const KillMatrix& matrix) {
  std::string names;
  for (const std::size_t defect : survivors(matrix)) {
    names += (names.empty() ? "" : ", ") + escaped(matrix.defects[defect]);
  }
  return names.empty() ? "none" : names;
}

std::string predictor_table(const Comparison& comparison) {
  const std::vector<Predictor> all = predictors(comparison);
  if (all.empty()) return {};
  Table table;
  table.column("agents");
  table.column("measure", Align::left);
  table.columns({"behaviours", "rank correlation"});
  for (const Predictor& each : all) {
    table.row({std::to_string(each.agents), escaped(each.measure->name),
               std::to_string(each.behaviours), decimal(each.rank_correlation, 2)});
  }
  return "<h3>Which cheap measure predicts kills</h3>\n" +
         paragraph(
             "Spearman’s rank correlation of a measure with the share of kills, over the "
             "behaviours of one number of agents.") +
         table.html();
}

}  // namespace

std::string section::kills(const ReportData& data) {
  const Comparison& comparison = data.comparison;
  const KillMatrix& matrix = comparison.kills;
  if (matrix.empty()) return {};
  const std::vector<std::string> behaviours = behaviours_of(comparison);
  std::string curves;
  for (const std::uint32_t agents : agents_of(comparison)) {
    curves += mutation_scores(matrix, behaviours, agents);
  }
  return paragraph(
             "A test kills a defect if with the same seed and agents the healthy AV breaks no "
             "assertion and the defective one fails one; what no driver could have avoided blames "
             "nobody. First kill: how many tests it takes for a chance of a half, over all orders "
             "of these tests; of a behaviour, the median over the defects. Accuracy and score are "
             "of the healthy AV. A search’s first kill is the median over its repetitions; of rows "
             "that were read from a file of kills, nothing else is known.") +
         summary_table(comparison) + "<h3>Kill matrix, % of the tests</h3>\n" +
         matrix_table(matrix) + "<h3>Mutation score against the number of tests</h3>\n" +
         legend(behaviours) + gallery(curves) +
         terms(term("Smallest team that kills all that anybody kills", team_text(matrix)) +
               term("Killed by nobody", survivors_text(matrix))) +
         predictor_table(comparison);
}

}  // namespace jaywalk::reporting
