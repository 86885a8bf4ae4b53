// SPDX-License-Identifier: Apache-2.0
// `jaywalk search`: generators look for inputs under which a system under test fails.

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiment/compare/kills/kills_file.h"
#include "experiment/report/tables/tables.h"
#include "interpreter/support/text.h"
#include "search/export/exports.h"
#include "search/report/search_page.h"
#include "search/search_experiment.h"
#include "search/search_kills.h"
#include "search/store/search_store.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/progress_line.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/options/store_options.h"
#include "tools/jaywalk/programs/program_check.h"

namespace jaywalk::command::search {
namespace {

namespace js = jaywalk::search;

/// Whether the options for outputs fit the experiment; false after reporting why not.
bool outputs_make_sense(const Arguments& arguments, const js::SearchExperiment& experiment,
                        Console& console) {
  Diagnostics diagnostics;
  if (experiment.defects.empty()) {
    if (arguments.has(option::kKills)) {
      diagnostics.error(option::kKills.dashed(), "has no meaning without defects",
                        "--defects names them, or all; jaywalk list defects shows them");
    }
  } else {
    for (const OptionName option : {option::kReport, option::kExport}) {
      if (!arguments.has(option)) continue;
      diagnostics.error(option.dashed(), "shows searches of one AV, not of its defects",
                        "--kills FILE keeps what they kill; `compare --with-kills FILE --report` "
                        "shows it beside what behaviours do");
    }
  }
  console.report(diagnostics);
  return !diagnostics.has_errors();
}

std::optional<js::SearchExperiment> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  const auto file =
      only_input(arguments, "search", "experiment", std::array{InputKind::search}, diagnostics);
  const auto seed = arguments.number(option::kSeed, 0, diagnostics);
  const auto repetitions = arguments.number(option::kRepetitions, 1, diagnostics, 100'000);
  const unsigned threads = read_threads(arguments, diagnostics);
  std::vector<std::string> sets = arguments.texts(option::kSet);
  std::ranges::copy(limit_sets(arguments, diagnostics, "sut.limits"), std::back_inserter(sets));
  if (std::vector<std::string> policies = arguments.texts(option::kPolicy); !policies.empty()) {
    // The key's paths are relative to the experiment's folder, the option's to this one.
    for (std::string& policy : policies) policy = std::filesystem::absolute(policy).string();
    sets.push_back(fmt::format("sut.policy={}", nlohmann::json(policies).dump()));
  }
  report_repeated_keys(sets, diagnostics);
  if (arguments.has(option::kResume) && !arguments.has(option::kStore)) {
    diagnostics.error(option::kResume.dashed(), "there is no --store to go on with");
  }
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return std::nullopt;
  }
  auto include_path = read_include_path(arguments, console);
  if (!include_path) return std::nullopt;
  Result<js::SearchExperiment> experiment = js::read_search(
      *file, {.sets = std::move(sets),
              .defects = arguments.text(option::kDefects),
              .generators = listed(arguments, option::kGenerators),
              .files = std::move(include_path->files),
              .include = {std::move(include_path->folders), std::move(include_path->mapped)}});
  if (!experiment.ok()) {
    console.report(experiment.diagnostics());
    return std::nullopt;
  }
  if (!outputs_make_sense(arguments, experiment.value(), console)) return std::nullopt;
  const Scenario* const scenario = experiment.value().plan.model->scenario();
  if (scenario != nullptr && !arguments.has(option::kNoCheck)) {
    Diagnostics warnings = scenario->warnings;
    Checked checked;
    check_programs(*scenario, checked, warnings);
    console.report(warnings);
  }
  js::SearchPlan& plan = experiment.value().plan;
  if (seed) plan.seed = *seed;
  if (repetitions) plan.repetitions = static_cast<std::uint32_t>(*repetitions);
  plan.threads = threads;
  return std::move(experiment).value();
}

/// The kill matrix needs no tests once they are counted.
enum class Keep { tests, counts };

js::SearchResults run(const js::SearchExperiment& experiment, js::TestLog* log, Console& console,
                      const InterruptGuard& interrupt, js::SearchKills* kills, Keep keep) {
  constexpr std::size_t kShownErrors = 20;
  ProgressLine line(console);
  std::uint64_t errored = 0;
  std::set<std::string> errors;
  js::SearchObserver observer;
  observer.progress = [&](const js::SearchProgress& now) {
    line.show(now);
    return interrupt.interrupted() ? js::Continue::no : js::Continue::yes;
  };
  observer.error = [&](const std::string& generator, std::uint32_t repetition, std::size_t test,
                       const std::string& error) {
    ++errored;
    if (errors.size() == kShownErrors || !errors.insert(error).second) return;
    line.clear();
    console.note(fmt::format("{}, repetition {}, test {}: no result: {}", generator, repetition,
                             test, error));
    if (errors.size() == kShownErrors) console.note("other errors are only counted");
  };
  observer.finished = [&](std::size_t search, js::SearchRun& finished) {
    if (kills == nullptr) return;
    kills->add(search, finished);
    if (keep == Keep::counts) finished.tests = {};
  };
  js::SearchResults results = js::run_searches(experiment.plan, log, observer);
  line.clear();
  if (errored > errors.size())
    console.note(fmt::format("{} had no result", counted(errored, "test")));
  return results;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "EXPERIMENT.yaml [OPTIONS]",
      .description =
          "Looks for test inputs under which a system under test fails: generators are\n"
          "asked for an input, the system executes it, the generator receives its fitness,\n"
          "until the budget is spent. Prints a table of what each generator found, means\n"
          "over the repetitions. The results do not depend on --threads.\n",
      .options =
          {
              {option::kGenerators, "LIST",
               "these generators: names of the experiment's or of the table,\n"
               "separated by commas; repeatable"},
              {option::kRepetitions, "N", "searches of each generator"},
              {option::kThreads, "N", "threads (default: as many as cores)"},
              {option::kSet, "KEY=VALUE",
               "another value for a key of the experiment, as a dotted path\n"
               "(budget.tests=100); repeatable"},
              {option::kSeed, "N", "the seed from which all chance derives"},
              {option::kDefects, "LIST",
               "search the AV with each of these defects (jaywalk list defects),\n"
               "as latency,short-range=12, or all: which generator kills which?"},
              {option::kKills, "FILE",
               "write that as CSV, which compare --with-kills puts beside what\n"
               "behaviours kill",
               Written::file},
              {option::kCsv, "FILE", "write a row for each search as CSV", Written::file},
              {option::kJson, "FILE", "write everything, each test with it, as JSON",
               Written::file},
              {option::kStore, "FILE.gpkg", "keep every finished test in a GeoPackage",
               Written::file},
              {option::kResume, "", "go on with the store where an earlier process ended"},
              {option::kReport, "FILE.html", "write a page with tables and pictures",
               Written::file},
              {option::kExport, "FOLDER",
               "write the failing roads as OpenDRIVE with OpenSCENARIO and as\n"
               "the SBST competition's JSON",
               Written::folder},
              {option::kQuiet, "", "print no table"},
              kPolicyOption,
              kNoCheckOption,
          },
      .examples =
          "  jaywalk search scenarios/search/lane-keeping.yaml\n"
          "  jaywalk search scenarios/search/lane-keeping.yaml --generators random,graft "
          "--repetitions 5\n"
          "  jaywalk search scenarios/search/lane-keeping.yaml --set sut.controller=stanley\n"
          "  jaywalk search scenarios/search/defects-search.yaml --defects latency --kills "
          "kills.csv\n"};
  help.options.insert(help.options.end(), kLimitOptions.begin(), kLimitOptions.end());
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  return help;
}

namespace {

/// Null if no store is asked for; nothing if it cannot be opened.
std::optional<std::unique_ptr<js::SearchStore>> open_store(const Arguments& arguments,
                                                           const js::SearchExperiment& experiment,
                                                           const InterruptGuard& interrupt,
                                                           Console& console) {
  const auto path = arguments.text(option::kStore);
  if (!path) return std::unique_ptr<js::SearchStore>();
  const PromptEnd end(interrupt);
  const auto mode = arguments.has(option::kResume) ? js::SearchStore::Mode::resume
                                                   : js::SearchStore::Mode::create;
  auto store = js::SearchStore::open(*path, mode, experiment);
  if (!store.ok()) {
    console.report(store.diagnostics());
    return std::nullopt;
  }
  if (store.value()->had() > 0) {
    console.note(fmt::format("going on after {} finished tests", store.value()->had()));
  }
  return std::move(store).value();
}

}  // namespace

/// Says which generators have no test with a result; false if there is one.
bool have_results(const js::SearchResults& results, Console& console) {
  std::map<std::string, std::pair<std::size_t, std::size_t>> tests;  // all, executed
  for (const js::SearchRun& run : results.runs) {
    for (const js::TestRow& row : run.tests) {
      if (!row.test.outcome.refused.empty()) continue;
      ++tests[run.generator].first;
      if (row.test.outcome.executed()) ++tests[run.generator].second;
    }
  }
  bool all_have = true;
  for (const auto& [generator, counts] : tests) {
    if (counts.second > 0) continue;
    console.error(
        fmt::format("{}: none of {} has a result", generator, counted(counts.first, "test")));
    all_have = false;
  }
  return all_have;
}

/// For each row, the test or the two tests that kill most defects.
std::string best_tests(const js::SearchExperiment& experiment, const js::SearchKills& kills,
                       const KillMatrix& matrix) {
  std::string text;
  for (std::size_t row = 0; row < matrix.rows.size(); ++row) {
    const js::GeneratorSpec& spec = experiment.plan.generators[row * matrix.defects.size()];
    const js::SearchSpace& space = experiment.plan.model_of(spec).space();
    for (const js::SearchKills::Team& team : kills.best_tests(row)) {
      text += fmt::format("{}: {} of {} defects are killed by {}\n", matrix.rows[row].behaviour,
                          team.killed, matrix.defects.size(),
                          team.tests.size() == 1 ? "the test" : "the two tests");
      for (const js::TestInput& test : team.tests) {
        text += fmt::format("  {}\n", space.describe(test));
      }
    }
  }
  return text.empty() ? text : '\n' + text;
}

/// Says which rows of a search for defects have no test with a result; false if there is one.
bool have_results(const KillMatrix& matrix, const js::SearchResults& results, Console& console) {
  if (!results.complete) return true;
  bool all_have = true;
  for (const KillRow& row : matrix.rows) {
    if (row.tests() > 0) continue;
    console.error(fmt::format("{}: no test has a result", row.behaviour));
    all_have = false;
  }
  return all_have;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  const std::optional<js::SearchExperiment> experiment = read_request(arguments, console);
  if (!experiment) return ExitCode::usage;
  // From here on an interrupt keeps all finished tests in the store.
  const InterruptGuard interrupt;
  const auto store = open_store(arguments, *experiment, interrupt, console);
  if (!store) return ExitCode::usage;
  std::optional<js::SearchKills> kills;
  if (!experiment->defects.empty()) kills.emplace(*experiment);
  const bool needs_tests = !kills || arguments.has(option::kCsv) || arguments.has(option::kJson);
  const js::SearchResults results =
      run(*experiment, store->get(), console, interrupt, kills ? &*kills : nullptr,
          needs_tests ? Keep::tests : Keep::counts);
  const auto unkept = *store ? (*store)->finish(results) : std::nullopt;
  std::optional<PromptEnd> end;  // the long work from here on does not poll for interrupts
  if (!interrupt.interrupted()) end.emplace(interrupt);
  std::vector<js::GeneratorResults> generators;
  if (needs_tests) generators = js::group(*experiment, results);
  const KillMatrix matrix = kills ? kills->matrix() : KillMatrix{};
  bool well = !results.trouble.has_errors();
  console.report(results.trouble);
  if (!is_kept(unkept, arguments.text(option::kStore).value_or(""), console)) well = false;
  if (const auto folder = arguments.text(option::kExport)) {
    if (const auto why = js::export_failures(*folder, *experiment, results)) {
      console.error(fmt::format("cannot write the failing roads: {}", *why));
      well = false;
    } else {
      console.wrote(*folder);
    }
  }
  const std::array outputs = {
      OutputFile{option::kCsv, [&] { return js::to_csv(generators); }},
      OutputFile{option::kKills, [&] { return to_kills_csv(matrix); }},
      OutputFile{option::kJson, [&] { return js::to_json(*experiment, generators); }},
      OutputFile{option::kReport, [&] { return js::to_html(*experiment, generators); }},
  };
  if (!write_outputs(arguments, outputs, console)) well = false;
  if (prints_table(arguments)) {
    console.print(kills ? render_kills(matrix) + best_tests(*experiment, *kills, matrix)
                        : js::render_table(generators));
  }
  if (!(kills ? have_results(matrix, results, console) : have_results(results, console)))
    well = false;
  if (!well) return ExitCode::failed;
  if (results.complete || !interrupt.interrupted()) return ExitCode::success;
  console.note(arguments.has(option::kStore)
                   ? "interrupted; the table has the finished searches. The same command with "
                     "--resume goes on"
                   : "interrupted; the table has the finished searches. With --store, --resume "
                     "goes on after an interruption");
  return ExitCode::interrupted;
}

}  // namespace jaywalk::command::search
