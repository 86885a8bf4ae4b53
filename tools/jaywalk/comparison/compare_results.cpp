#include "tools/jaywalk/comparison/compare_results.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "env/grid/start_cells.h"
#include "experiment/compare/kills/kills_csv.h"
#include "experiment/export/comparison_files.h"
#include "experiment/report/stored_coverage.h"
#include "experiment/results/reader.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/comparison/reporting.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::command::compare {
namespace {

/// Summed up from the store, which may have had tests before; nothing after reporting why not.
std::optional<Comparison> stored_comparison(const Request& request, Console& console) {
  const std::string& path = request.store->path;
  auto store = ResultsReader::open(path);
  if (!store) {
    console.report(store.diagnostics());
    return std::nullopt;
  }
  auto comparison = store.value()->comparison();
  if (comparison) return std::move(comparison).value();
  console.report(comparison.diagnostics());
  return std::nullopt;
}

Comparison make_comparison(const Request& request, ExperimentOutcome& outcome) {
  Comparison comparison{.scenario = request.description.scenario,
                        .seed = request.seed,
                        .tests = request.plan.tests,
                        .summaries = std::move(outcome.summaries),
                        .published = published_rows(*request.prepared),
                        .complete = outcome.complete()};
  for (Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(request.prepared->behaviours(), summary.behaviour,
                                             &PreparedBehaviour::name);
    summary.code_lines = behaviour->code_lines;
  }
  return comparison;
}

/// The start cells of all tests of the largest number of agents.
std::string start_cells_csv(const Request& request) {
  const std::uint32_t agents = *std::ranges::max_element(request.plan.agents);
  return print_start_cells(
      start_cells(request.prepared->scenario(), agents, request.seed, request.plan.tests));
}

/// The single tests, of the store if there is one; false after reporting why not.
bool write_per_test_csv(const Request& request, const Collected& collected, const TextSink& sink,
                        Console& console) {
  if (collected.per_test != nullptr) {
    sink(collected.per_test->csv());
    return true;
  }
  const auto store = ResultsReader::open(request.store->path);
  const auto failure =
      store.ok() ? write_per_test_table(*store.value(), sink) : store.diagnostics();
  if (failure) console.report(*failure);
  return !failure;
}

std::optional<std::string> report_of(const Arguments& arguments, const Request& request,
                                     const Comparison& comparison,
                                     const reporting::FactsTable& facts, Console& console) {
  if (!wants_page(arguments)) return render_svg(comparison);
  if (request.store) {
    return stored_report(request.store->path, *arguments.text(option::kReport), ReplayPages::none,
                         Commands::refused, console, request.other_kills);
  }
  return unstored_report({.comparison = comparison,
                          .description = request.description,
                          .prepared = request.prepared,
                          .criteria = request.criteria,
                          .facts = facts});
}

}  // namespace

std::optional<Comparison> comparison_of(const Request& request, const Collected& collected,
                                        ExperimentOutcome& outcome, Console& console) {
  if (request.store) {
    auto stored = stored_comparison(request, console);
    if (stored) add_kills(request.other_kills, stored->kills);
    return stored;
  }
  Comparison comparison = make_comparison(request, outcome);
  add_assessments(request.criteria, collected.assessments, request.plan.behaviours, comparison);
  comparison.kills = collected.kills.matrix();
  add_kills(request.other_kills, comparison.kills);
  comparison.avs = collected.avs.ranking(asks(request.criteria));
  for (const Summary& summary : comparison.summaries) {
    const auto behaviour = std::ranges::find(request.plan.behaviours, summary.behaviour);
    comparison.troubles.push_back(collected.troubles.troubles(
        static_cast<std::size_t>(behaviour - request.plan.behaviours.begin()), summary.agents));
  }
  return comparison;
}

bool wants_page(const Arguments& arguments) {
  const auto report = arguments.text(option::kReport);
  return report && !report->ends_with(".svg");
}

bool write_files(const Arguments& arguments, const Request& request, const Collected& collected,
                 const Comparison& comparison, const reporting::FactsTable& facts,
                 Console& console) {
  const std::array files = {
      OutputFile{option::kCsv, [&] { return to_csv(comparison); }},
      OutputFile{option::kKills, [&] { return to_kills_csv(comparison.kills); }},
      OutputFile{.option = option::kPerTest,
                 .text = nullptr,
                 .pieces =
                     [&](const TextSink& sink) {
                       return write_per_test_csv(request, collected, sink, console);
                     }},
      OutputFile{option::kJson, [&] { return to_json(comparison); }},
      OutputFile{option::kJunit, [&] { return to_junit(comparison); }},
      OutputFile{option::kStarts, [&] { return start_cells_csv(request); }},
      OutputFile{option::kReport,
                 [&] { return report_of(arguments, request, comparison, facts, console); }},
  };
  return write_outputs(arguments, files, console);
}

std::string situations_of(const Request& request, const Comparison& comparison,
                          const SituationTable& table) {
  std::vector<SituationRow> rows;
  const ReachableBins& reachable = request.prepared->scenario().experiment.reachable;
  for (const Summary& summary : comparison.summaries) {
    const auto place = std::ranges::find(request.plan.behaviours, summary.behaviour);
    const auto behaviour = static_cast<std::size_t>(place - request.plan.behaviours.begin());
    rows.push_back({summary.behaviour, summary.agents,
                    table.coverage(behaviour, summary.agents, request.plan.tests),
                    reachable_with(reachable, summary.agents)});
  }
  return situation_text(rows);
}

std::string interruption(const Request& request, const ExperimentOutcome& outcome,
                         const Comparison& comparison) {
  std::string text = fmt::format(
      "interrupted after {} of {} tests; the rows shown and written are finished, {} of {}.\n",
      outcome.progress.done, outcome.progress.total, comparison.summaries.size(),
      request.plan.behaviours.size() * request.plan.agents.size());
  if (!request.store) {
    return text +
           "To get the others, run the same command again (--behaviours and --agents leave out "
           "rows).";
  }
  return text + fmt::format(
                    "All finished tests are in '{}'; the same command with --resume runs "
                    "the others.",
                    request.store->path);
}

}  // namespace jaywalk::command::compare
