// SPDX-License-Identifier: Apache-2.0
// `jaywalk merge`: the stores of an experiment's shards become one.

#include "experiment/results/merge.h"

#include <array>
#include <span>

#include <fmt/format.h>

#include "experiment/export/comparison_files.h"
#include "experiment/results/reader.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::command::merge {
namespace {

/// The summary of the store, shown and written as `compare` does.
ExitCode show(const std::string& path, const Arguments& arguments, const OutputOptions& output,
              Console& console) {
  auto store = ResultsReader::open(path);
  if (!store) {
    console.report(store.diagnostics());
    return ExitCode::usage;
  }
  const auto comparison = store.value()->comparison();
  if (!comparison) {
    console.report(comparison.diagnostics());
    return ExitCode::usage;
  }
  const std::array outputs = {
      OutputFile{option::kCsv, [&] { return to_csv(comparison.value()); }},
      OutputFile{option::kJson, [&] { return to_json(comparison.value()); }},
  };
  const bool written = write_outputs(arguments, outputs, console);
  show_comparison(output, comparison.value(), console);
  // Rows that lack tests, which was said, may be finished later.
  const bool all_have =
      comparison.value().summaries.empty() || have_results(comparison.value(), console);
  return all_have && written ? ExitCode::success : ExitCode::failed;
}

}  // namespace

CommandHelp help() {
  return {.usage = "OUT.gpkg IN.gpkg... [OPTIONS]",
          .description =
              "Puts the stores of an experiment's shards (compare --shard) together into a new\n"
              "one, in any order, and prints the table. A test that two of them have is taken\n"
              "once. What no shard has can be run with compare --resume on the new store.\n",
          .options =
              {
                  {option::kCsv, "FILE", "write the results as CSV", Written::file},
                  {option::kJson, "FILE", "write the results as JSON, the published ones with them",
                   Written::file},
                  kFormatOption,
                  {option::kQuiet, "", "print no table"},
              },
          .examples =
              "  jaywalk merge all.gpkg 1.gpkg 2.gpkg 3.gpkg 4.gpkg\n"
              "  jaywalk merge all.gpkg shards/*.gpkg --csv all.csv --quiet\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().size() < 2) {
    console.error(fmt::format("expected a new store and those to merge, found {}",
                              arguments.operands().size()),
                  "jaywalk merge --help shows how to write it");
    return ExitCode::usage;
  }
  Diagnostics wrong;
  const OutputOptions output = read_output_options(arguments, wrong);
  const auto parts = input_files(std::span(arguments.operands()).subspan(1), kStores, wrong);
  if (wrong.has_errors()) {
    console.report(wrong);
    return ExitCode::usage;
  }
  const InterruptGuard interrupt;
  const PromptEnd end(interrupt);
  const std::string& path = arguments.operands().front();
  auto outcome = merge_stores(path, parts);
  if (!outcome) {
    console.report(outcome.diagnostics());
    return ExitCode::usage;
  }
  console.wrote(path);
  if (outcome.value().tests < outcome.value().planned) {
    console.note(fmt::format("{} of {} tests are missing; compare --store '{}' --resume runs them",
                             outcome.value().planned - outcome.value().tests,
                             outcome.value().planned, path));
  }
  return show(path, arguments, output, console);
}

}  // namespace jaywalk::command::merge
