// SPDX-License-Identifier: Apache-2.0
// `jaywalk export`: stored tests as files for other programs.

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "experiment/export/exporter.h"
#include "interpreter/support/text.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/stored_test.h"

namespace jaywalk::command::export_ {
namespace {

ExitCode list_exporters(Console& console) {
  std::size_t width = 0;
  for (const Exporter& each : exporters()) width = std::max(width, each.name.size());
  for (const Exporter& each : exporters()) {
    console.print(fmt::format("{:<{}}  {}\n", each.name, width, each.summary));
  }
  return ExitCode::success;
}

const Exporter* wanted_exporter(const Arguments& arguments, Console& console) {
  const std::string name = arguments.text(option::kFormat).value_or("openscenario");
  if (const Exporter* found = find_exporter(name)) return found;
  std::vector<std::string> names;
  for (const Exporter& each : exporters()) names.emplace_back(each.name);
  std::string hint = did_you_mean(name, names);
  if (hint.empty()) hint = "jaywalk export --list names the formats";
  console.error(fmt::format("unknown format '{}'", name), hint);
  return nullptr;
}

/// Their ids.
Result<std::vector<std::int64_t>> wanted_tests(const ResultsReader& store,
                                               const Arguments& arguments) {
  Diagnostics diagnostics;
  const auto number = arguments.number(option::kTest, 0, diagnostics);
  if (diagnostics.has_errors()) return diagnostics;
  TestFilter filter;
  if (!arguments.has(option::kAll) && !number) filter.succeeded = true;
  std::vector<std::int64_t> chosen;
  auto failure = store.for_each_test(filter, [&](const StoredTest& each) {
    if (number.value_or(each.test.number) == each.test.number) chosen.push_back(each.id);
    return Proceed::yes;
  });
  if (failure) return std::move(*failure);
  if (!chosen.empty()) return chosen;
  if (number) {
    diagnostics.error(option::kTest.dashed(), fmt::format("the store has no test {}", *number));
  } else {
    diagnostics.error(store.path(), "no test of the store met the precondition",
                      filter.succeeded ? "--all exports the others" : "");
  }
  return diagnostics;
}

/// The store or a copy of a file in it is wrong, as opposed to what could not be written.
bool is_about_input(const Diagnostics& diagnostics, const ResultsReader& store) {
  return std::ranges::any_of(diagnostics.items(), [&](const Diagnostic& each) {
    return each.where.source != nullptr || each.subject == store.path() ||
           std::ranges::any_of(store.description().inputs, [&](const StoredInput& input) {
             return each.subject == input.path;
           });
  });
}

ExitCode run(const Exporter& exporter, const ResultsReader& store, ScenarioDialect dialect,
             const Arguments& arguments, Console& console) {
  const auto tests = wanted_tests(store, arguments);
  if (!tests.ok()) {
    console.report(tests.diagnostics());
    return ExitCode::usage;
  }
  const ExportRequest request{.store = store,
                              .tests = tests.value(),
                              .folder = arguments.text(option::kOut).value_or("."),
                              .dialect = dialect,
                              .connection = arguments.text(option::kConnection).value_or(""),
                              .schema = arguments.text(option::kSchema).value_or(""),
                              .overwrite = arguments.has(option::kOverwrite)};
  std::error_code error;
  std::filesystem::create_directories(request.folder, error);
  if (error) {
    console.error(fmt::format("cannot make '{}': {}", request.folder, error.message()));
    return ExitCode::failed;
  }
  const ExportedFiles files = exporter.run(request);
  if (!files.ok()) {
    console.report(files.diagnostics());
    return is_about_input(files.diagnostics(), store) ? ExitCode::usage : ExitCode::failed;
  }
  console.report(files.value().warnings);
  console.note(fmt::format("{} exported", counted(request.tests.size(), "test")));
  if (!files.value().note.empty()) console.note(files.value().note);
  for (const std::string& file : files.value().files) console.print(file + '\n');
  return ExitCode::success;
}

}  // namespace

CommandHelp help() {
  return {.usage = "STORE [OPTIONS]",
          .description =
              "Writes the tests of a store as files for other programs: those that met the\n"
              "precondition, unless --all or --test says otherwise. Prints the files' names.\n"
              "esmini plays OpenSCENARIO files as the tests were recorded with --traj_filter 0:\n"
              "its filter moves actors by up to a quarter of a metre.\n",
          .options =
              {
                  {option::kFormat, "NAME",
                   "what to write: openscenario (default), csv, trace, json,\n"
                   "postgis"},
                  {option::kOut, "DIR", "where to; made if it is not there (default: here)",
                   Written::folder},
                  {option::kTest, "N", "the tests of this number alone"},
                  {option::kAll, "", "all tests"},
                  {option::kDialect, "NAME", "of openscenario: standard (default) or carla"},
                  {option::kConnection, "TEXT",
                   "of postgis: the database, as ogr2ogr wants it, with or without\n"
                   "PG: before it"},
                  {option::kSchema, "NAME",
                   "of postgis: the schema for the tables (default: the store's\n"
                   "name); it must be new"},
                  {option::kOverwrite, "",
                   "of postgis: replace the store's tables in an existing schema"},
                  kAllowCommandsOption,
                  {option::kList, "", "name the formats"},
              },
          .examples =
              "  jaywalk export runs.gpkg --out found\n"
              "  jaywalk export runs.gpkg --test 7 --dialect carla --out carla\n"
              "  jaywalk export runs.gpkg --format csv --all --out tables\n"
              "  jaywalk export runs.gpkg --format postgis --connection 'PG:dbname=tests'\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.has(option::kList)) return list_exporters(console);
  const std::array<std::string, 2> dialects{"standard", "carla"};
  Diagnostics diagnostics;
  const auto dialect =
      static_cast<ScenarioDialect>(arguments.choice(option::kDialect, dialects, diagnostics));
  if (diagnostics.has_errors()) {
    console.report(diagnostics);
    return ExitCode::usage;
  }
  const Exporter* exporter = wanted_exporter(arguments, console);
  if (exporter == nullptr) return ExitCode::usage;
  const auto store = open_results(arguments, "export", console);
  if (!store) return ExitCode::usage;
  return run(*exporter, *store, dialect, arguments, console);
}

}  // namespace jaywalk::command::export_
