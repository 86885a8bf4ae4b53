// SPDX-License-Identifier: Apache-2.0
// `jaywalk report`: a page about the tests of a store.

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "experiment/results/merge.h"
#include "experiment/scenario/files/temporary.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/comparison/reporting.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/stored_test.h"

namespace jaywalk::command::report {
namespace {

namespace fs = std::filesystem;

/// `runs.gpkg` becomes `runs.html`.
std::string beside(const std::string& store) {
  return fs::path(store).replace_extension(".html").string();
}

}  // namespace

CommandHelp help() {
  return {
      .usage = "STORE.gpkg... [OPTIONS]",
      .description =
          "Writes a page of what a store has: measures (in the paper's world beside the\n"
          "published values), significance, where preconditions were met, verdicts, metrics,\n"
          "how to reproduce.\n"
          "The page loads no other file and works without a network. No test is run, except that\n"
          "the first ones of agents with a learned policy are run again for a map of what they\n"
          "choose. The stores of an experiment's shards make one page. Of a store of searches,\n"
          "the searches' page.\n",
      .options =
          {
              {option::kHtml, "FILE", "the page's name (default: the store's, ending in .html)",
               Written::file},
              {option::kReplays, "",
               "run the tests that the page names again and link pages that\n"
               "play them, in a folder beside it"},
              kAllowCommandsOption,
          },
      .examples =
          "  jaywalk report paper.gpkg\n"
          "  jaywalk report 1.gpkg 2.gpkg 3.gpkg 4.gpkg --html paper.html\n"
          "  jaywalk report paper.gpkg --html paper.html --replays\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().empty()) {
    console.error("expected a store, found none", "jaywalk report --help shows how to write it");
    return ExitCode::usage;
  }
  Diagnostics wrong;
  const auto stores = input_files(arguments.operands(), kStores, wrong);
  if (wrong.has_errors()) {
    console.report(wrong);
    return ExitCode::usage;
  }
  const std::string html = arguments.text(option::kHtml).value_or(beside(stores.front()));
  const TemporaryFolder folder;  // for as long as the report is made
  const InterruptGuard interrupt;
  const PromptEnd end(interrupt, [&] {
    std::error_code ignored;
    fs::remove_all(folder.path(), ignored);
  });
  const std::string together = folder.path() + "/together.gpkg";
  if (stores.size() > 1) {
    const auto merged = merge_stores(together, stores);
    if (!merged) {
      console.report(merged.diagnostics());
      return ExitCode::usage;
    }
  }
  const auto page =
      stored_report(stores.size() > 1 ? together : stores.front(), html,
                    arguments.has(option::kReplays) ? ReplayPages::beside : ReplayPages::none,
                    commands_of(arguments), console);
  if (!page) return ExitCode::usage;
  const Links links = arguments.has(option::kHtml) ? Links::followed : Links::replaced;
  return write_output(html, *page, console, links) ? ExitCode::success : ExitCode::failed;
}

}  // namespace jaywalk::command::report
