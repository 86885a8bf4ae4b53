#include "experiment/report/tables/av_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

std::string line(const std::string& name, std::size_t width, const AvCell& cell, bool judged) {
  const auto share = [&](std::uint64_t part, bool known) {
    return known ? fmt::format("{:.2f}", share_pct(part, cell)) : std::string("-");
  };
  const auto impact = cell.mean_impact_mps();
  return fmt::format("{:<{}}  {:>7}  {:>10}  {:>12}  {:>11}  {:>13}  {:>10}\n", name, width,
                     cell.tests, share(cell.successes, true), share(cell.collisions, true),
                     share(cell.avoidable, judged), share(cell.unavoidable, judged),
                     impact ? fmt::format("{:.2f}", *impact) : "-");
}

}  // namespace

std::string render_avs(const AvRanking& ranking) {
  if (ranking.empty()) return {};
  constexpr std::string_view kIndent = "  ";
  std::size_t width = 10;
  for (const std::string& av : ranking.avs) width = std::max(width, av.size() + kIndent.size());
  for (const AvRow& row : ranking.rows) width = std::max(width, row.behaviour.size() + 6);
  std::string text = fmt::format("{:<{}}  {:>7}  {:>10}  {:>12}  {:>11}  {:>13}  {:>10}\n",
                                 "AV models", width, "tests", "accuracy %", "collisions %",
                                 "avoidable %", "unavoidable %", "impact m/s");
  std::size_t place = 0;
  for (const RankedAv& av : ranked(ranking)) {
    if (av.all.tests == 0) continue;
    text += line(fmt::format("{}. {}", ++place, av.name), width, av.all, ranking.judged);
  }
  for (const AvRow& row : ranking.rows) {
    text += fmt::format("{} ({})\n", row.behaviour, row.agents);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].tests == 0) continue;
      text +=
          line(fmt::format("{}{}", kIndent, ranking.avs[i]), width, row.cells[i], ranking.judged);
    }
  }
  std::uint64_t errored = 0;
  for (const RankedAv& av : ranked(ranking)) errored += av.all.errored;
  if (errored > 0)
    text += fmt::format("\nwithout {} that ended errored\n", counted(errored, "test"));
  return text;
}

}  // namespace jaywalk
