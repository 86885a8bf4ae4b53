// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/comparison/compare_results.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "env/grid/start_cells.h"
#include "experiment/compare/kills/kills_file.h"
#include "experiment/export/comparison_files.h"
#include "experiment/report/stored_coverage.h"
#include "experiment/results/reader.h"
#include "tools/jaywalk/comparison/reporting.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::command::compare {
namespace {

/// The start cells of all tests of the largest number of agents.
std::string start_cells_csv(const ComparisonRequest& request) {
  const std::uint32_t agents = *std::ranges::max_element(request.plan.agents);
  return print_start_cells(
      start_cells(request.prepared->scenario(), agents, request.seed, request.plan.tests));
}

/// The single tests, of the store if there is one; false after reporting why not.
bool write_per_test_csv(const Request& request, const ComparisonResults& results,
                        const TextSink& sink, Console& console) {
  if (results.per_test != nullptr) {
    sink(results.per_test->csv());
    return true;
  }
  const auto store = ResultsReader::open(request.comparison.store->path);
  const auto failure =
      store.ok() ? write_per_test_table(*store.value(), sink) : store.diagnostics();
  if (failure) console.report(*failure);
  return !failure;
}

std::optional<std::string> report_of(const Request& request, const ComparisonResults& results,
                                     const reporting::FactsTable& facts, Console& console) {
  if (!request.options.wants_page()) return render_svg(results.comparison);
  if (request.comparison.store) {
    return stored_report(request.comparison.store->path, *request.options.report, ReplayPages::none,
                         Commands::refused, console, request.other_kills);
  }
  return unstored_report({.comparison = results.comparison,
                          .description = results.description,
                          .prepared = request.comparison.prepared,
                          .criteria = request.comparison.criteria,
                          .facts = facts});
}

}  // namespace

bool write_files(const Arguments& arguments, const Request& request,
                 const ComparisonResults& results, const reporting::FactsTable& facts,
                 Console& console) {
  const Comparison& comparison = results.comparison;
  const std::array files = {
      OutputFile{option::kCsv, [&] { return to_csv(comparison); }},
      OutputFile{option::kKills, [&] { return to_kills_csv(comparison.kills); }},
      OutputFile{.option = option::kPerTest,
                 .text = nullptr,
                 .pieces =
                     [&](const TextSink& sink) {
                       return write_per_test_csv(request, results, sink, console);
                     }},
      OutputFile{option::kJson, [&] { return to_json(comparison); }},
      OutputFile{option::kJunit, [&] { return to_junit(comparison); }},
      OutputFile{option::kStarts, [&] { return start_cells_csv(request.comparison); }},
      OutputFile{option::kReport, [&] { return report_of(request, results, facts, console); }},
  };
  return write_outputs(arguments, files, console);
}

std::string situations_of(const Request& request, const ComparisonResults& results) {
  std::vector<SituationRow> rows;
  const ReachableBins& reachable = request.comparison.prepared->scenario().experiment.reachable;
  for (std::size_t row = 0; row < results.situations.size(); ++row) {
    const Summary& summary = results.comparison.summaries[row];
    rows.push_back({summary.behaviour, summary.agents, results.situations[row],
                    reachable_with(reachable, summary.agents)});
  }
  return situation_text(rows);
}

std::string interruption(const Request& request, const ComparisonResults& results) {
  std::string text = fmt::format(
      "interrupted after {} of {} tests; the rows shown and written are finished, {} of {}.\n",
      results.progress.done, results.progress.total, results.comparison.summaries.size(),
      request.comparison.plan.rows());
  if (!request.comparison.store) {
    return text +
           "To get the others, run the same command again (--behaviours and --agents leave out "
           "rows).";
  }
  return text + fmt::format(
                    "All finished tests are in '{}'; the same command with --resume runs "
                    "the others.",
                    request.comparison.store->path);
}

}  // namespace jaywalk::command::compare
