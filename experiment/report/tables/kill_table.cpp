// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/compare/kills/predictors.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/report/tables/tables.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

std::string row_name(const KillRow& row) {
  return fmt::format("{} ({})", row.behaviour, row.agents);
}

std::size_t name_width(const KillMatrix& matrix) {
  std::size_t width = 0;
  for (const KillRow& row : matrix.rows) width = std::max(width, row_name(row).size());
  for (const std::string& defect : matrix.defects) width = std::max(width, defect.size());
  return width;
}

std::string count_text(std::optional<std::uint64_t> count, std::uint64_t tests) {
  return count ? fmt::format("{}", *count) : fmt::format("> {}", tests);
}

std::string behaviour_lines(const KillMatrix& matrix, std::size_t width) {
  std::string text = fmt::format("{:<{}}  {:>7}  {:>6}  {:>7}  {:>10}  {:>15}\n", "kills", width,
                                 "kills", "kill %", "defects", "first kill", "healthy to blame");
  for (const KillRow& row : matrix.rows) {
    const std::uint64_t tests = row.tests_of_each();
    if (tests == 0) continue;
    text += fmt::format("{:<{}}  {:>7}  {:>6.2f}  {:>3} /{:>3}  {:>10}  {:>15}\n", row_name(row),
                        width, row.kills(), kill_pct(row), row.killed(), row.cells.size(),
                        count_text(first_kill_median(row), tests),
                        row.kills_alone ? "-" : std::to_string(row.healthy_failures));
  }
  return text;
}

std::string defect_line(const KillMatrix& matrix, std::size_t defect, std::size_t width) {
  std::string text = fmt::format("{:<{}}  ", matrix.defects[defect], width);
  const auto best = best_killer(matrix, defect);
  if (!best) return text + "nobody\n";
  const KillRow& row = matrix.rows[*best];
  const KillCell& cell = row.cells[defect];
  const ConfidenceInterval interval = wilson_interval(cell.kills, cell.tests);
  const auto killers = std::ranges::count_if(
      matrix.rows, [&](const KillRow& each) { return each.cells[defect].kills > 0; });
  return text + fmt::format("{} of {}; best {}: {} of {} ({:.1f} to {:.1f} %), first kill {}\n",
                            killers, matrix.rows.size(), row_name(row), cell.kills, cell.tests,
                            100 * interval.low, 100 * interval.high,
                            count_text(first_kill_median(cell), cell.tests));
}

/// Which rows' numbers are of fewer tests.
std::string errored_lines(const KillMatrix& matrix) {
  std::string text;
  for (const KillRow& row : matrix.rows) {
    if (row.errored() == 0) continue;
    text += fmt::format(
        "{}: without {} that ended errored, with the healthy AV or the "
        "defective one\n",
        row_name(row), counted(row.errored(), "test"));
  }
  return text.empty() ? text : '\n' + text;
}

std::string predictor_lines(const Comparison& comparison) {
  std::string text;
  std::uint32_t agents = 0;
  for (const Predictor& each : predictors(comparison)) {
    if (each.agents != agents) {
      text += fmt::format("{}rank correlation with kill %, {}:", text.empty() ? "" : "\n",
                          counted(each.agents, "agent"));
    }
    text += fmt::format("{} {} {:.2f} ({})", each.agents == agents ? "," : "", each.measure->name,
                        each.rank_correlation, each.behaviours);
    agents = each.agents;
  }
  return text.empty() ? text : text + '\n';
}

}  // namespace

std::string render_kills(const KillMatrix& matrix) {
  if (matrix.empty()) return {};
  const std::size_t width = name_width(matrix);
  std::string text = behaviour_lines(matrix, width) + errored_lines(matrix);
  text += fmt::format("\n{:<{}}  killed by\n", "defect", width);
  for (std::size_t i = 0; i < matrix.defects.size(); ++i) text += defect_line(matrix, i, width);
  std::vector<std::string> team;
  for (const std::size_t row : smallest_team(matrix)) team.push_back(row_name(matrix.rows[row]));
  if (team.empty()) return text;
  return text + fmt::format("\nsmallest team that kills all that anybody kills: {}\n",
                            fmt::join(team, ", "));
}

std::string render_kills(const Comparison& comparison) {
  return render_kills(comparison.kills) + predictor_lines(comparison);
}

}  // namespace jaywalk
