// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/comparison/comparison_output.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/export/comparison_files.h"
#include "experiment/report/tables/tables.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

std::string in_format(Format format, const Comparison& comparison) {
  switch (format) {
    case Format::table:
      return render_tables(comparison);
    case Format::csv:
      return to_csv(comparison);
    case Format::json:
      return to_json(comparison);
    case Format::markdown:
      return to_markdown(comparison);
  }
  return {};
}

/// A behaviour, perhaps with one AV of several, and the numbers of agents with which no test of it
/// has a result.
struct RowWithoutResult {
  std::string what;
  std::vector<std::uint32_t> agents;
};

std::vector<RowWithoutResult> rows_without_result(const Comparison& comparison) {
  std::vector<RowWithoutResult> rows;
  const auto add = [&](std::string what, std::uint32_t agents) {
    const auto same = std::ranges::find(rows, what, &RowWithoutResult::what);
    if (same == rows.end()) {
      rows.push_back({std::move(what), {agents}});
    } else if (std::ranges::find(same->agents, agents) == same->agents.end()) {
      same->agents.push_back(agents);
    }
  };
  for (const Summary& each : comparison.summaries) {
    if (each.tests > 0 && each.judged() == 0) add(each.behaviour, each.agents);
  }
  const auto add_cells = [&](const auto& row, const std::vector<std::string>& vehicles,
                             std::size_t first) {
    for (std::size_t i = first; i < row.cells.size(); ++i) {
      if (row.cells[i].tests > 0 || row.cells[i].errored == 0) continue;
      add(fmt::format("{}, AV {},", row.behaviour, vehicles[i]), row.agents);
    }
  };
  for (const KillRow& row : comparison.kills.rows) {
    // Without a result of the healthy AV there is none with a defect, which need not be said.
    const auto own = std::ranges::find_if(comparison.summaries, [&](const Summary& each) {
      return each.behaviour == row.behaviour && each.agents == row.agents;
    });
    if (own == comparison.summaries.end() || own->judged() > 0) {
      add_cells(row, comparison.kills.defects, 0);
    }
  }
  // The summaries are of the first one.
  for (const AvRow& row : comparison.avs.rows) add_cells(row, comparison.avs.avs, 1);
  return rows;
}

}  // namespace

OutputOptions read_output_options(const Arguments& arguments, Diagnostics& diagnostics) {
  static const std::array<std::string, 4> kFormats = {"table", "csv", "json", "markdown"};
  return {.format = static_cast<Format>(arguments.choice(option::kFormat, kFormats, diagnostics)),
          .shown = prints_table(arguments),
          .strict = arguments.has(option::kStrict)};
}

void show_comparison(const OutputOptions& options, const Comparison& comparison, Console& console) {
  if (options.shown) console.print(in_format(options.format, comparison));
  const std::string troubles = render_troubles(troubles_of(comparison));
  if (troubles.empty()) return;
  if (options.shown && options.format == Format::table) {
    console.print('\n' + troubles);
  } else {
    console.flush();
    console.note(troubles.substr(0, troubles.size() - 1));
  }
}

bool have_results(const Comparison& comparison, Console& console) {
  std::uint64_t tests = 0;
  for (const Summary& summary : comparison.summaries) tests += summary.tests;
  if (const std::uint64_t errored = errored_tests(comparison); errored > 0) {
    console.note(fmt::format(
        "warning: {} of {} tests ended errored; the measures are of the others", errored, tests));
  }
  const std::vector<RowWithoutResult> rows = rows_without_result(comparison);
  for (const auto& [what, agents] : rows) {
    console.error(fmt::format("{} with {} agent{}: no test has a result", what,
                              fmt::join(agents, ", "), agents.back() == 1 ? "" : "s"));
  }
  if (comparison.summaries.empty()) console.error("no row is finished: there is no result");
  return rows.empty() && !comparison.summaries.empty();
}

bool fails_strictly(const OutputOptions& options, const Comparison& comparison, Console& console) {
  if (!options.strict || !is_troubled(troubles_of(comparison))) return false;
  console.error("--strict: agents dropped intentions or never acted, or tests ended errored");
  return true;
}

}  // namespace jaywalk
