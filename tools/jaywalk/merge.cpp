// `jaywalk merge`: the stores of an experiment's shards become one.

#include "experiment/results/merge.h"

#include <array>
#include <functional>

#include <fmt/format.h>

#include "experiment/export/csv.h"
#include "experiment/export/json.h"
#include "experiment/export/write_file.h"
#include "experiment/report/table.h"
#include "experiment/report/verdict_table.h"
#include "experiment/results/reader.h"
#include "tools/jaywalk/command.h"

namespace jaywalk::command::merge {
namespace {

bool write_outputs(const Arguments& arguments, const Comparison& comparison, Console& console) {
  struct Output {
    std::string_view option;
    std::function<std::string(const Comparison&)> text;
  };
  const std::array outputs = {Output{"csv", to_csv}, Output{"json", to_json}};
  bool written = true;
  for (const Output& output : outputs) {
    const auto path = arguments.text(output.option);
    if (!path) continue;
    console.flush();  // in case it is /dev/stdout
    if (const auto why = write_file(*path, output.text(comparison))) {
      console.error(fmt::format("cannot write '{}': {}", *path, *why));
      written = false;
    }
  }
  return written;
}

std::string tables(const Comparison& comparison) {
  std::string text = render_table(comparison);
  for (const std::string& more : {render_verdicts(comparison), render_metrics(comparison)}) {
    if (!more.empty()) text += '\n' + more;
  }
  return text;
}

/// What the store comes to, shown and written as `compare` does.
ExitCode show(const std::string& path, const Arguments& arguments, Console& console) {
  auto store = ResultsReader::open(path);
  if (!store) {
    console.report(store.diagnostics());
    return ExitCode::failed;
  }
  const auto comparison = store.value()->comparison();
  if (!comparison) {
    console.error(fmt::format("cannot read '{}'", path));
    return ExitCode::failed;
  }
  const bool written = write_outputs(arguments, comparison.value(), console);
  if (!arguments.has("quiet")) console.print(tables(comparison.value()));
  return written ? ExitCode::success : ExitCode::failed;
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
                  {"csv", "FILE", "write the results as CSV"},
                  {"json", "FILE", "write the results as JSON, the published ones with them"},
                  {"quiet", "", "print no table"},
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
  const std::string& path = arguments.operands().front();
  auto outcome = merge_stores(path, {arguments.operands().begin() + 1, arguments.operands().end()});
  if (!outcome) {
    console.report(outcome.diagnostics());
    return ExitCode::usage;
  }
  if (outcome.value().tests < outcome.value().planned) {
    console.note(fmt::format("{} of {} tests are missing; compare --store '{}' --resume runs them",
                             outcome.value().planned - outcome.value().tests,
                             outcome.value().planned, path));
  }
  return show(path, arguments, console);
}

}  // namespace jaywalk::command::merge
