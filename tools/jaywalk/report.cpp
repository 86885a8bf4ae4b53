// `jaywalk report`: a page of what a store has.

#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

#include "experiment/results/merge.h"
#include "tools/jaywalk/command.h"
#include "tools/jaywalk/output_files.h"
#include "tools/jaywalk/reporting.h"

namespace jaywalk::command::report {
namespace {

namespace fs = std::filesystem;

/// A store for as long as the report is made; its file goes with it.
class TemporaryStore {
 public:
  TemporaryStore()
      : path_((fs::temp_directory_path() / fmt::format("jaywalk-report-{}.gpkg", ::getpid()))
                  .string()) {}
  ~TemporaryStore() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryStore(const TemporaryStore&) = delete;
  TemporaryStore& operator=(const TemporaryStore&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// `runs.gpkg` becomes `runs.html`.
std::string beside(const std::string& store) {
  return fs::path(store).replace_extension(".html").string();
}

}  // namespace

CommandHelp help() {
  return {.usage = "STORE.gpkg... [OPTIONS]",
          .description =
              "Writes a page of what a store has: the paper's figures beside the published ones,\n"
              "significance, where preconditions were met, verdicts, metrics, how to reproduce.\n"
              "The page needs nothing beside it and no network; nothing is run. The stores of an\n"
              "experiment's shards make one page. Of a store of searches, the searches' page.\n",
          .options =
              {
                  {"html", "FILE", "the page's name (default: the store's, ending in .html)",
                   Written::file},
                  {"replays", "",
                   "run the tests that the page names again and link pages that\n"
                   "play them, in a folder beside it"},
              },
          .examples =
              "  jaywalk report paper.gpkg\n"
              "  jaywalk report 1.gpkg 2.gpkg 3.gpkg 4.gpkg --html paper.html\n"
              "  jaywalk report paper.gpkg --html paper.html --replays\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const auto& stores = arguments.operands();
  if (stores.empty()) {
    console.error("expected a store, found none", "jaywalk report --help shows how to write it");
    return ExitCode::usage;
  }
  const std::string html = arguments.text("html").value_or(beside(stores.front()));
  const TemporaryStore together;
  if (stores.size() > 1) {
    const auto merged = merge_stores(together.path(), stores);
    if (!merged) {
      console.report(merged.diagnostics());
      return ExitCode::usage;
    }
  }
  const auto page =
      stored_report(stores.size() > 1 ? together.path() : stores.front(), html,
                    arguments.has("replays") ? ReplayPages::beside : ReplayPages::none, console);
  if (!page) return ExitCode::usage;
  if (!write_output(html, *page, console)) return ExitCode::failed;
  if (!arguments.has("html")) console.print(html + '\n');
  return ExitCode::success;
}

}  // namespace jaywalk::command::report
