// SPDX-License-Identifier: Apache-2.0
// `jaywalk judge`: assertions and metrics over the tests of a store, after the fact.

#include <array>

#include <fmt/format.h>

#include "experiment/export/comparison_files.h"
#include "experiment/report/tables/tables.h"
#include "experiment/results/store/row_writer.h"
#include "experiment/results/writer.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/comparison/comparison_output.h"
#include "tools/jaywalk/comparison/judging.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/console/progress_line.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/stored_test.h"
#include "tools/jaywalk/run/run_files.h"

namespace jaywalk::command::judge {
namespace {

/// Everything that the command line says, and the store.
struct Request {
  std::unique_ptr<ResultsReader> store;
  std::shared_ptr<const PreparedScenario> prepared;
  Criteria criteria;
  std::vector<FailureCondition> conditions;
  std::optional<std::uint64_t> test;
};

std::optional<Request> read_request(const Arguments& arguments, Console& console) {
  Diagnostics diagnostics;
  const auto file = only_input(arguments, "judge", "store", kStores, diagnostics);
  Request request{.conditions = read_conditions(arguments, diagnostics),
                  .test = arguments.number(option::kTest, 1, diagnostics)};
  console.report(diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  auto store = ResultsReader::open(*file, commands_of(arguments));
  if (!store) {
    console.report(store.diagnostics());
    return std::nullopt;
  }
  request.store = std::move(store).value();
  auto prepared = request.store->prepared();
  if (!prepared) {
    console.report(prepared.diagnostics());
    return std::nullopt;
  }
  request.prepared = std::move(prepared).value();
  const auto stored = request.store->assertions();
  if (!stored) {
    console.report(stored.diagnostics());
    return std::nullopt;
  }
  auto criteria = read_criteria(arguments, stored.value(), console);
  if (!criteria) return std::nullopt;
  request.criteria = std::move(*criteria);
  if (!asks(request.criteria)) {
    console.error("there is nothing to judge", "--assertions names a file of assertions");
    return std::nullopt;
  }
  if (!check_conditions(request.conditions, request.criteria, console)) return std::nullopt;
  return request;
}

/// One test, reported in full.
ExitCode judge_one(const Request& request, const Arguments& arguments, Console& console) {
  const auto id = static_cast<std::int64_t>(*request.test);
  const auto recording = request.store->recording(id);
  if (!recording) {
    console.report(recording.diagnostics());
    return ExitCode::usage;
  }
  const auto stored = request.store->test(id);
  if (stored.ok() && stored.value().result.errored) {
    console.error(fmt::format("test {} ended errored: it is not judged", id));
    return ExitCode::failed;
  }
  const TestAssessment assessment =
      assess(request.criteria, recording.value(), request.prepared->scenario().world->ground());
  console.print(render_assessment(request.criteria, assessment, recording.value().actors()));
  if (const auto path = arguments.text(option::kJunit)) {
    const std::string name = fmt::format("test {}", id);
    if (!write_output(*path, to_junit(name, request.criteria, assessment), console)) {
      return ExitCode::failed;
    }
  }
  return ExitCode::success;
}

/// The tables that sum up the tests. `spool` keeps their assessments for --write; null without it.
struct Judged {
  AssessmentTable& table;
  KillTable& kills;
  AssessmentSpool* spool = nullptr;
};

/// One test of many.
void judge_test(const Request& request, const StoredTest& stored, const Ground& on, Judged& judged,
                Diagnostics& trouble) {
  TestKey test = stored.test;
  test.number -= request.store->description().first_test;
  if (stored.result.errored) return judged.kills.add_errored(test);
  const auto recording = request.store->recording(stored.id);
  if (!recording) {
    trouble.append(recording.diagnostics());
    return;
  }
  const TestAssessment assessment = assess(request.criteria, recording.value(), on);
  if (test.vehicle == 0) judged.table.add(test, assessment);
  judged.kills.add(test, blames_the_av(assessment));
  if (judged.spool != nullptr) {
    judged.spool->add(stored.id, to_rows(request.criteria, assessment));
  }
}

/// Looks at every test of the store.
ExitCode judge_all(const Request& request, Judged judged, Console& console) {
  const Ground on = request.prepared->scenario().world->ground();
  const InterruptGuard interrupt;
  ProgressLine line(console);
  Progress progress{.done = 0, .total = request.store->count()};
  Diagnostics trouble;
  request.store->stop_when([&] { return interrupt.interrupted(); });
  const auto failure =
      request.store->for_each_test({.vehicle = std::nullopt}, [&](const StoredTest& stored) {
        constexpr std::uint64_t kBetweenLooks = 256;
        if (progress.done++ % kBetweenLooks == 0) line.show(progress);
        judge_test(request, stored, on, judged, trouble);
        return trouble.has_errors() || interrupt.interrupted() ? Proceed::no : Proceed::yes;
      });
  line.clear();
  request.store->stop_when(nullptr);
  if (interrupt.interrupted()) return ExitCode::interrupted;
  if (failure) trouble.append(*failure);
  if (trouble.has_errors()) {
    console.report(trouble);
    return ExitCode::usage;
  }
  if (judged.spool != nullptr && judged.spool->failure()) {
    console.error(fmt::format("--write: {}", *judged.spool->failure()));
    return ExitCode::failed;
  }
  return ExitCode::success;
}

/// Writes the assessments into the store. REQUIRES: all readers of the store are closed.
bool write_assessments(const std::string& path, const Criteria& criteria, AssessmentSpool& spool,
                       Console& console) {
  auto writer = AssessmentWriter::open(path);
  if (!writer) {
    console.report(writer.diagnostics());
    return false;
  }
  writer.value()->note_judging(criteria.files, criteria.metrics);
  spool.for_each([&](std::int64_t id, const auto& rows) { writer.value()->replace(id, rows); });
  if (spool.failure()) {
    console.error(fmt::format("cannot write '{}': {}", path, *spool.failure()));
    return false;
  }
  if (const auto why = writer.value()->finish()) {
    console.error(fmt::format("cannot write '{}': {}", path, *why));
    return false;
  }
  console.wrote(path);
  return true;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "STORE.gpkg [OPTIONS] | --trace FILE.csv [OPTIONS]",
      .description =
          "Judges the tests of a store by assertions, after the fact, with the verdicts that\n"
          "compare --assertions gives. Tests whose positions the store does not have are run\n"
          "again from their seeds. Without --assertions those count by which the store's tests\n"
          "were judged, as they were then, or else the stored scenario's.\n"
          "\n"
          "With --trace it judges a drive that was recorded or simulated elsewhere: a table with "
          "a\n"
          "row for each actor at each time, times evenly spaced. Its columns are time (s), actor\n"
          "(`av`, or else the first vehicle, is the automated one), kind (vehicle, pedestrian,\n"
          "cyclist, signal), x and y (m, of the middle; y along the way), and if they are there\n"
          "heading (rad from +x), speed (m/s), length and width (m) and event (`collision`; "
          "several\n"
          "with semicolons). jaywalk export --format trace writes such tables.\n",
      .options =
          {
              {option::kTrace, "FILE.csv", "judge this drive instead of a store's tests"},
              {option::kScenario, "FILE.yaml",
               "of a trace: the scenario whose lanes it is on, and whose\n"
               "assertions count (default: the paper's road)"},
              {option::kTest, "N", "report everything about the test of this number in the store"},
              {option::kWrite, "",
               "keep the verdicts and metrics in the store, in place of old ones"},
              {option::kCsv, "FILE", "write the results as CSV", Written::file},
              {option::kJson, "FILE", "write the results as JSON", Written::file},
              {option::kFailOn, "EXPR",
               "exit with 1 if a row meets it: ASSERTION.VERDICT>NUMBER, as\n"
               "collision_avoidance.fail>0, or MEASURE<NUMBER; repeatable"},
              kAllowCommandsOption,
              {option::kQuiet, "", "print no table"},
          },
      .examples =
          "  jaywalk judge paper.gpkg --assertions scenarios/assertions/crossing.yaml\n"
          "  jaywalk judge paper.gpkg --metrics --write\n"
          "  jaywalk judge paper.gpkg --test 17 --metrics\n"
          "  jaywalk judge --trace drive.csv --metrics --scenario scenarios/first.yaml\n"
          "  jaywalk judge paper.gpkg --fail-on 'collision_avoidance.fail>0' --junit out.xml\n"};
  help.options.insert(help.options.begin(), kJudgingOptions.begin(), kJudgingOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (const auto trace = arguments.text(option::kTrace))
    return judge_trace(*trace, arguments, console);
  if (arguments.has(option::kScenario)) {
    console.error("--scenario is about a trace", "a store has its own");
    return ExitCode::usage;
  }
  auto request = read_request(arguments, console);
  if (!request) return ExitCode::usage;
  if (request->test) return judge_one(*request, arguments, console);

  const ExperimentPlan plan = plan_of(request->store->description());
  KillTable kills(plan, tests_in_shard(request->store->description()));
  AssessmentTable table(request->criteria, plan);
  std::optional<AssessmentSpool> spool;
  if (arguments.has(option::kWrite)) spool.emplace();
  const Judged judged{.table = table, .kills = kills, .spool = spool ? &*spool : nullptr};
  const ExitCode code = judge_all(*request, judged, console);
  if (code != ExitCode::success) return code;
  const InterruptGuard interrupt;
  std::optional<PromptEnd> end(std::in_place, interrupt);
  auto comparison = request->store->comparison();
  if (!comparison) {
    console.report(comparison.diagnostics());
    return ExitCode::usage;
  }
  // In place of the stored verdicts, which may be by other assertions.
  add_assessments(request->criteria, table, plan.behaviours, comparison.value());
  comparison.value().kills = kills.matrix();
  // Closed before it is written to (--write).
  request->store.reset();
  end.reset();  // a store is written whole or not at all

  bool written =
      !spool || write_assessments(arguments.operands().front(), request->criteria, *spool, console);
  const std::array outputs = {
      OutputFile{option::kCsv, [&] { return to_csv(comparison.value()); }},
      OutputFile{option::kJson, [&] { return to_json(comparison.value()); }},
      OutputFile{option::kJunit, [&] { return to_junit(comparison.value()); }},
  };
  written = write_outputs(arguments, outputs, console) && written;
  if (prints_table(arguments)) {
    console.print(render_verdicts(comparison.value()) + render_metrics(comparison.value()) +
                  render_kills(comparison.value()));
  }
  if (!comparison.value().complete) {
    console.note("the store lacks tests: rows that are not finished are left out");
  }
  const bool all_have = have_results(comparison.value(), console);
  const bool failed = report_failures(request->conditions, comparison.value(), console);
  return failed || !written || !all_have ? ExitCode::failed : ExitCode::success;
}

}  // namespace jaywalk::command::judge
