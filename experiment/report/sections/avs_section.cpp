// SPDX-License-Identifier: Apache-2.0
// How models of the AV rank.

#include <fmt/format.h>

#include "experiment/compare/avs/av_ranking.h"
#include "experiment/compare/measures/statistics.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

/// A share of the tests, on a ground that is the stronger the greater it is.
std::string share_cell(std::uint64_t part, const AvCell& cell) {
  if (cell.tests == 0) return "–";
  const ConfidenceInterval interval = wilson_interval(part, cell.tests);
  return fmt::format(
      "<span class=\"share\" style=\"--share:{:.2f}\" title=\"{} of {} tests ({:.1f} to {:.1f} "
      "%)\">{:.2f}</span>",
      share_pct(part, cell) / 100, part, cell.tests, 100 * interval.low, 100 * interval.high,
      share_pct(part, cell));
}

void add_columns(Table& table, bool judged) {
  table.columns({"tests", "accuracy %", "collisions %"});
  if (judged) table.column("avoidable %");
  if (judged) table.column("unavoidable %");
  table.column("mean impact, m/s");
}

void add_values(std::vector<std::string>& cells, const AvCell& cell, bool judged) {
  cells.push_back(grouped(cell.tests));
  cells.push_back(share_cell(cell.successes, cell));
  cells.push_back(share_cell(cell.collisions, cell));
  if (judged) cells.push_back(share_cell(cell.avoidable, cell));
  if (judged) cells.push_back(share_cell(cell.unavoidable, cell));
  cells.push_back(decimal(cell.mean_impact_mps(), 2));
}

std::string rank_table(const AvRanking& ranking) {
  Table table;
  table.column("rank");
  table.column("AV model", Align::left);
  add_columns(table, ranking.judged);
  std::size_t place = 0;
  for (const RankedAv& av : ranked(ranking)) {
    std::vector<std::string> cells{std::to_string(++place), escaped(av.name)};
    add_values(cells, av.all, ranking.judged);
    table.row(std::move(cells));
  }
  return table.html();
}

/// Behaviours by models, one value in each cell.
template <class Text>
std::string matrix(const AvRanking& ranking, Text text) {
  Table table;
  table.column("behaviour", Align::left);
  table.column("agents");
  for (const std::string& av : ranking.avs) table.column(escaped(av));
  for (const AvRow& row : ranking.rows) {
    std::vector<std::string> cells{escaped(row.behaviour), std::to_string(row.agents)};
    for (const AvCell& cell : row.cells) cells.push_back(text(cell));
    table.row(std::move(cells));
  }
  return table.html();
}

}  // namespace

std::string section::avs(const ReportData& data) {
  const AvRanking& ranking = data.comparison.avs;
  if (ranking.empty()) return {};
  const auto shares = [&](std::uint64_t AvCell::*part) {
    return matrix(ranking, [&](const AvCell& cell) { return share_cell(cell.*part, cell); });
  };
  std::string text =
      paragraph(
          "Every test was run with each model: the same behaviours, start cells and seeds. The "
          "ranking is by the share of tests with an avoidable collision, which a careful and "
          "competent driver would not have had, then of collisions, then by their mean impact. "
          "The other sections’ measures are of the first model.") +
      rank_table(ranking) + "<h3>Accuracy, % of the tests</h3>\n" + shares(&AvCell::successes) +
      "<h3>Collisions, % of the tests</h3>\n" + shares(&AvCell::collisions);
  if (ranking.judged) {
    text += "<h3>Avoidable collisions, % of the tests</h3>\n" + shares(&AvCell::avoidable) +
            "<h3>Unavoidable collisions, % of the tests</h3>\n" + shares(&AvCell::unavoidable);
  }
  return text + "<h3>Mean impact speed of the collisions, m/s</h3>\n" +
         matrix(ranking, [](const AvCell& cell) { return decimal(cell.mean_impact_mps(), 2); });
}

}  // namespace jaywalk::reporting
