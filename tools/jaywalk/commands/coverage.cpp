// SPDX-License-Identifier: Apache-2.0
// `jaywalk coverage`: the plans and situations that a store's tests have covered.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "experiment/report/stored_coverage.h"
#include "experiment/scenario/files/portable_names.h"
#include "experiment/scenario/number_list.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/progress_line.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/coverage_options.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/stored_test.h"

namespace jaywalk::command::coverage {
namespace {

struct Options {
  CoverageWanted wanted;
  unsigned threads = 1;
};

std::optional<Options> read_options(const Arguments& arguments, const ResultsReader& store,
                                    Console& console) {
  Diagnostics diagnostics;
  Options options;
  options.threads = read_threads(arguments, diagnostics);
  options.wanted.behaviour = arguments.text(option::kBehaviour);
  const auto agents = arguments.number(option::kAgents, 1, diagnostics, kMaxAgents);
  if (agents) {
    const auto& known = store.description().agents;
    if (std::ranges::find(known, *agents) == known.end()) {
      diagnostics.error(option::kAgents.dashed(),
                        fmt::format("the store has no tests with {}", counted(*agents, "agent")));
    }
    options.wanted.agents = static_cast<std::uint32_t>(*agents);
  }
  std::vector<std::string> names;
  for (const auto& behaviour : store.description().behaviours) names.push_back(behaviour.name);
  if (options.wanted.behaviour &&
      std::ranges::find(names, *options.wanted.behaviour) == names.end()) {
    diagnostics.error(option::kBehaviour.dashed(),
                      fmt::format("the store has no behaviour '{}'", *options.wanted.behaviour),
                      did_you_mean(*options.wanted.behaviour, names));
  }
  check_coverage_options(arguments, diagnostics);
  if (!diagnostics.has_errors()) return options;
  console.report(diagnostics);
  return std::nullopt;
}

template <class Value>
ExitCode report_failure(const Result<Value>& result, const InterruptGuard& interrupt,
                        Console& console) {
  if (interrupt.interrupted()) {
    console.note("interrupted");
    return ExitCode::interrupted;
  }
  console.report(result.diagnostics());
  return ExitCode::usage;
}

}  // namespace

CommandHelp help() {
  return {.usage = "STORE [OPTIONS]",
          .description =
              "Shows which situations the tests of a store have covered: in bins of where the\n"
              "pedestrian who met the precondition first started, where and when it did, how\n"
              "long before a collision, and so on, with the holes and how coverage grew from\n"
              "test to test. With --coverage the tests are run again to see which plans,\n"
              "conditions and formulas of the agents' programs they used.\n",
          .options =
              {
                  {option::kBehaviour, "NAME", "of this behaviour's tests"},
                  {option::kAgents, "N", "of the tests with this number of agents"},
                  {option::kCsv, "FILE", "write the situations as CSV", Written::file},
                  {option::kJson, "FILE", "write the situations as JSON, with their growth",
                   Written::file},
                  kCoverageOption,
                  kAllowCommandsOption,
                  {option::kThreads, "N", "threads for --coverage (default: as many as cores)"},
                  {option::kQuiet, "", "print no table"},
              },
          .examples =
              "  jaywalk coverage runs.gpkg\n"
              "  jaywalk coverage runs.gpkg --behaviour election --coverage election.html\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto store = open_results(arguments, "coverage", console);
  if (!store) return ExitCode::usage;
  const auto options = read_options(arguments, *store, console);
  if (!options) return ExitCode::usage;
  const InterruptGuard interrupt;
  ProgressLine line(console);
  const auto progress = [&](const Progress& now) {
    line.show(now);
    return interrupt.interrupted() ? Proceed::no : Proceed::yes;
  };
  store->stop_when([&] { return interrupt.interrupted(); });
  const auto rows = stored_situations(*store, options->wanted, progress);
  line.clear();
  if (!rows.ok()) return report_failure(rows, interrupt, console);
  if (prints_table(arguments)) console.print(situation_text(rows.value()));
  const std::array outputs = {
      OutputFile{option::kCsv, [&] { return situation_csv(rows.value()); }},
      OutputFile{option::kJson, [&] { return situation_json(rows.value()); }},
  };
  bool written = write_outputs(arguments, outputs, console);
  if (arguments.has(option::kCoverage)) {
    const auto plans = stored_plan_coverage(*store, options->wanted, options->threads, progress);
    line.clear();
    if (!plans.ok()) return report_failure(plans, interrupt, console);
    const std::string subject =
        fmt::format("{}, {}", portable_path(arguments.operands().front()),
                    coverage_subject(store->description(), options->wanted));
    written = write_coverage(arguments, plans.value(), subject, console) && written;
  }
  return written ? ExitCode::success : ExitCode::failed;
}

}  // namespace jaywalk::command::coverage
