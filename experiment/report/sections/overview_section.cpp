// SPDX-License-Identifier: Apache-2.0
// The section with the experiment and its main results in a few lines.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "experiment/report/tables/tables.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

std::string facts_of(const ReportData& data) {
  const Comparison& comparison = data.comparison;
  const std::vector<std::string> behaviours = behaviours_of(comparison);
  std::uint64_t tests = 0;
  for (const Summary& summary : comparison.summaries) tests += summary.tests;
  std::string list = term("scenario", fmt::format("<code>{}</code>", escaped(comparison.scenario)));
  if (data.description.preset) list += term("preset", escaped(*data.description.preset));
  for (const std::string& set : data.description.sets) {
    list += term("set", fmt::format("<code>{}</code>", escaped(set)));
  }
  list += term("behaviours", escaped(fmt::format("{}", fmt::join(behaviours, ", "))));
  list += term("numbers of agents", fmt::format("{}", fmt::join(agents_of(comparison), ", ")));
  list += term("tests", fmt::format("{} for each behaviour and number of agents, {} in all",
                                    grouped(comparison.tests), grouped(tests)));
  if (!comparison.kills.empty()) {
    list += term("AVs", fmt::format("each of these tests with the healthy AV and with {} of it",
                                    plural(comparison.kills.defects.size(), "defect")));
  }
  if (const std::uint64_t errored = errored_tests(comparison); errored > 0) {
    list += term("errored", fmt::format("{}: the measures are of the others, and "
                                        "<a href=\"#agents\">what happened</a> says why",
                                        plural(errored, "test")));
  }
  list += term("seed", std::to_string(comparison.seed));
  const Shard& shard = data.description.shard;
  if (shard.count > 1) list += term("shard", fmt::format("{} of {}", shard.index, shard.count));
  if (!data.store_path.empty()) {
    list += term("store", fmt::format("<code>{}</code>, level {}", escaped(data.store_path),
                                      name(data.description.level)));
  }
  return terms(list);
}

/// A behaviour's best value of a measure, and the number of agents that gave it.
struct Best {
  double value = 0;
  std::uint32_t agents = 0;
};

enum class Wanted { most, least };

std::optional<Best> best_of(const Comparison& comparison, std::string_view behaviour,
                            std::string_view measure, Wanted wanted) {
  std::optional<Best> best;
  for (const Summary& summary : comparison.summaries) {
    if (summary.behaviour != behaviour) continue;
    const auto value = find_measure(measure)->estimate(summary).value;
    if (!value) continue;
    const bool better =
        !best || (wanted == Wanted::most ? *value > best->value : *value < best->value);
    if (better) best = {*value, summary.agents};
  }
  return best;
}

std::string with_agents(const std::optional<Best>& best, int decimals) {
  if (!best) return "–";
  return fmt::format("{} <small>at {}</small>", decimal(best->value, decimals), best->agents);
}

std::string best_table(const Comparison& comparison) {
  Table table;
  table.column("behaviour", Align::left);
  table.columns({"lines of code", "best accuracy, %", "best score"});
  const bool normalised = is_shown(comparison.published, *find_measure("combined_normalised"));
  if (normalised) table.column("best combined_normalised");
  table.columns({"fewest ticks to test", "least CPU time, µs"});
  for (const std::string& behaviour : behaviours_of(comparison)) {
    const Summary* any = nullptr;
    for (const Summary& summary : comparison.summaries) {
      if (summary.behaviour == behaviour) any = &summary;
    }
    std::vector<std::string> cells{escaped(behaviour), std::to_string(any->code_lines)};
    const auto add = [&](std::string_view measure, Wanted wanted, int decimals) {
      cells.push_back(with_agents(best_of(comparison, behaviour, measure, wanted), decimals));
    };
    add("accuracy", Wanted::most, 1);
    add("score", Wanted::most, 2);
    if (normalised) add("combined_normalised", Wanted::most, 3);
    add("ticks_all", Wanted::least, 2);
    add("cpu", Wanted::least, 1);
    table.row(std::move(cells));
  }
  return table.html() +
         "<p class=\"note\">Small print: the number of agents at which it is "
         "reached.</p>\n";
}

}  // namespace

std::string section::overview(const ReportData& data) {
  std::string html;
  if (!data.comparison.complete) {
    html +=
        "<p class=\"warn\">Not all tests were run: rows that are not finished are missing "
        "from this page.</p>\n";
  }
  html += facts_of(data);
  if (data.comparison.summaries.empty()) return html + paragraph("No row is finished yet.");
  return html + best_table(data.comparison);
}

}  // namespace jaywalk::reporting
