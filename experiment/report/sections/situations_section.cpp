// SPDX-License-Identifier: Apache-2.0
// Which situations the tests have covered, and how that grew.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/report/charts/plot.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "experiment/report/stored_coverage.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

/// Tests of each behaviour and number of agents whose situations are shown. Few, so that a report
/// is made quickly: tests without stored scenes have to run again.
constexpr std::uint64_t kTests = 50;

std::vector<PlotPoint> growth(const SituationCoverage& coverage) {
  std::vector<PlotPoint> points;
  for (const std::uint64_t tests : {1U, 2U, 5U, 10U, 20U, 35U, 50U, 75U, 100U, 150U, 200U}) {
    if (tests > coverage.tests()) break;
    points.push_back(
        {.x = static_cast<double>(tests), .y = static_cast<double>(coverage.covered_after(tests))});
  }
  return points;
}

std::string growth_of(const std::vector<SituationRow>& rows,
                      const std::vector<std::string>& behaviours, std::uint32_t agents) {
  std::vector<PlotSeries> series;
  for (const SituationRow& row : rows) {
    const auto place = std::ranges::find(behaviours, row.behaviour);
    if (row.agents != agents || place == behaviours.end()) continue;
    series.push_back({.name = row.behaviour,
                      .number = static_cast<std::size_t>(place - behaviours.begin()),
                      .points = growth(row.coverage)});
  }
  std::uint64_t bins = 0;
  for (const SituationRow& row : rows) {
    if (row.agents == agents) bins = std::max(bins, row.bins());
  }
  return figure(fmt::format("Growth with {}", plural(agents, "agent")),
                curves({.x_title = "tests",
                        .y_title = "bins covered",
                        .least = 0,
                        .most = static_cast<double>(bins)},
                       series));
}

std::string totals(const std::vector<SituationRow>& rows) {
  Table table;
  table.columns({"agents", "tests", "bins covered", "of", "%"});
  const std::string* behaviour = nullptr;
  for (const SituationRow& row : rows) {
    if (behaviour == nullptr || *behaviour != row.behaviour) table.heading(row.behaviour);
    behaviour = &row.behaviour;
    const double share =
        100.0 * static_cast<double>(row.coverage.covered()) / static_cast<double>(row.bins());
    table.row({std::to_string(row.agents), grouped(row.coverage.tests()),
               grouped(row.coverage.covered()), grouped(row.bins()), decimal(share, 1)});
  }
  return table.html();
}

std::string bins_of(const std::vector<SituationRow>& rows, std::size_t item) {
  Table table;
  table.column("bin", Align::left);
  table.column("tests");
  const SituationItem& described = situation_items()[item];
  for (std::size_t bin = 0; bin < described.bins.size(); ++bin) {
    std::uint64_t times = 0;
    bool can_be = false;
    for (const SituationRow& row : rows) {
      times += row.coverage.counts()[item][bin];
      can_be = can_be || row.reachable.empty() || row.reachable[item][bin];
    }
    const std::string missing = can_be ? "<b>hole</b>" : "never";
    table.row({escaped(described.bins[bin]), times == 0 ? missing : grouped(times)});
  }
  return table.html();
}

}  // namespace

std::string section::situations(const ReportData& data) {
  if (data.store == nullptr) {
    return paragraph(
        "Situations are counted from a store: <code>--store FILE</code> keeps one, and "
        "<code>jaywalk compare --situations</code> prints them.");
  }
  const auto found = stored_situations(*data.store, {.tests = kTests},
                                       [](const Progress&) { return Proceed::yes; });
  if (!found.ok() || found.value().empty()) return {};
  const std::vector<SituationRow>& rows = found.value();
  const std::vector<std::string> behaviours = behaviours_of(data.comparison);
  const std::vector<std::uint32_t> agents = agents_of(data.comparison);
  if (agents.empty()) return {};
  std::string figures = growth_of(rows, behaviours, agents.front());
  if (agents.size() > 1) figures += growth_of(rows, behaviours, agents.back());
  std::string items;
  for (std::size_t i = 0; i < situation_items().size(); ++i) {
    const SituationItem& item = situation_items()[i];
    items += details(fmt::format("{}: {}", item.name, item.summary), bins_of(rows, i));
  }
  return paragraph(fmt::format(
             "Where, when and how the precondition was met, in bins, seen from the agent that "
             "met it first; of each behaviour with each number of agents the first {} tests. "
             "<code>jaywalk coverage {}</code> counts all of them.",
             kTests, escaped(data.store_path))) +
         legend(behaviours) + gallery(figures) + details("Bins covered, as a table", totals(rows)) +
         "<h3>The bins, of all these tests together</h3>\n" + items;
}

}  // namespace jaywalk::reporting
