// SPDX-License-Identifier: Apache-2.0
// `jaywalk check`: finds errors in programs, projects and scenarios without running them.

#include "interpreter/check/check.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "env/environments.h"
#include "experiment/test_run/prepared_scenario.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/embed/project_agents.h"
#include "interpreter/program/code_text.h"
#include "interpreter/support/text.h"
#include "interpreter/syntax/load.h"
#include "search/search_experiment.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/console/interrupt.h"
#include "tools/jaywalk/options/include_path.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"
#include "tools/jaywalk/options/scenario_options.h"
#include "tools/jaywalk/programs/program_check.h"
#include "tools/jaywalk/programs/vocabulary.h"
#include "tools/jaywalk/run/own_world.h"
#include "tools/jaywalk/run/trials.h"

namespace jaywalk::command::check {
namespace {

/// Endings of the files of a folder that are checked: programs and projects. A .yaml file may be
/// anything, so scenarios have to be named.
constexpr std::array<std::string_view, 2> kEndings{".asl", ".mas2j"};

/// Checks files, each program once however many scenarios and projects name it.
class Checker {
 public:
  /// `trials`: starts the commands that files name; null: they are not started.
  Checker(IncludePath include_path, Trials* trials)
      : include_path_(std::move(include_path)), trials_(trials) {}

  /// False: files of that kind cannot be checked.
  bool check_file(const std::string& path) {
    if (is_scenario_file(path)) {
      const auto source = read_source(path, kMaxScenarioBytes);
      if (source.ok() && jaywalk::search::is_search(source.value())) {
        check_search(source.value());
      } else {
        check_scenario(path);
      }
    } else if (path.ends_with(".asl")) {
      check_alone(path);
    } else if (path.ends_with(".mas2j")) {
      check_project(path);
    } else {
      return false;
    }
    return true;
  }

  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  struct LoadedProgram {
    SourceTree tree;
    Diagnostics found;
  };

  static LoadedProgram load(const ProgramSource& program) {
    LoadedProgram loaded;
    loaded.tree = program.text ? load_agent(program.text, program.include_path, loaded.found)
                               : load_agent(program.path, program.include_path, loaded.found);
    return loaded;
  }

  bool is_new(const std::string& path) {
    return checked_.programs.insert(std::filesystem::path(path).lexically_normal().string()).second;
  }

  void check_program(LoadedProgram program, const EnvironmentKind* environment,
                     const std::function<void(Vocabulary&)>& complete) {
    check_loaded(program.tree, environment, complete, program.found);
    add_news(program.found, checked_, diagnostics_);
  }

  /// A program by itself, for the environment that it seems to be written for.
  void check_alone(const std::string& path) {
    if (!is_new(path)) return;
    LoadedProgram program = load({.path = path, .text = {}, .include_path = include_path_});
    jaywalk::check_alone(program.tree, path, program.found);
    add_news(program.found, checked_, diagnostics_);
  }

  void check_project(const std::string& path) {
    const std::size_t known_warnings = diagnostics_.warning_count();
    const auto project = read_project_agents(path, include_path_, {.ignored = true}, diagnostics_);
    if (!project) return;
    const std::vector<ProgramSource>& programs = project->programs;
    // Code in Java, or a program that is the world, may post and ask for anything.
    const bool has_others = project->environment || diagnostics_.warning_count() > known_warnings;
    const auto world = try_world(*project, path);
    std::vector<LoadedProgram> loaded;
    std::set<std::string, std::less<>> named;
    bool all_known = !has_others;
    for (const ProgramSource& program : programs) {
      loaded.push_back(load(program));
      all_known &= loaded.back().found.empty();
      named.merge(names_in(loaded.back().tree));
    }
    for (std::size_t i = 0; i < loaded.size(); ++i) {
      if (!programs[i].text && !is_new(programs[i].path)) continue;
      const EnvironmentKind* const environment = project->environment
                                                     ? (world ? world->words.kind() : nullptr)
                                                     : environment_of(loaded[i].tree);
      check_program(std::move(loaded[i]), environment, [&](Vocabulary& vocabulary) {
        vocabulary.others_known = all_known;
        vocabulary.may_be_alone = false;
        vocabulary.named_by_others = named;
      });
    }
  }

  struct TriedWorld {
    explicit TriedWorld(EnvironmentIdentity answered)
        : identity(std::move(answered)), words(identity) {}

    EnvironmentIdentity identity;
    DeclaredWords words;
  };
  /// Null if the project has no world that is a program, or its program is not to be tried or
  /// cannot be started.
  std::unique_ptr<TriedWorld> try_world(const ProjectParts& project, const std::string& path) {
    if (trials_ == nullptr || !project.environment) return nullptr;
    const auto folder = std::filesystem::path(path).parent_path().string();
    const auto world = own_world(Arguments(), project.environment, folder, diagnostics_);
    if (!world) return nullptr;
    std::vector<std::string> agents;
    for (const ProgramSource& program : project.programs) {
      agents.insert(agents.end(), program.agents.begin(), program.agents.end());
    }
    auto identity = trials_->try_world(*world, agents, diagnostics_);
    if (!identity) return nullptr;
    return std::make_unique<TriedWorld>(std::move(*identity));
  }

  void check_search(const SourcePtr& source) {
    auto experiment = jaywalk::search::parse_search(
        source,
        {.files = include_path_.files, .include = {include_path_.folders, include_path_.mapped}});
    if (!experiment) {
      diagnostics_.append(std::move(experiment.diagnostics()));
      return;
    }
    const std::size_t errors = diagnostics_.error_count();
    if (const Scenario* const scenario = experiment.value().plan.model->scenario()) {
      check_programs(*scenario, checked_, diagnostics_);
    }
    if (trials_ != nullptr && diagnostics_.error_count() == errors) {
      trials_->try_search(experiment.value(), diagnostics_);
    }
  }

  void check_scenario(const std::string& path) {
    auto scenario = read_scenario(path, {.files = include_path_.files,
                                         .include = {include_path_.folders, include_path_.mapped}});
    if (!scenario) {
      diagnostics_.append(std::move(scenario.diagnostics()));
      return;
    }
    const std::size_t errors = diagnostics_.error_count();
    diagnostics_.append(scenario.value().warnings);
    check_programs(scenario.value(), checked_, diagnostics_);
    if (diagnostics_.error_count() > errors) return;
    // Preparing finds parameters that do not fit the programs; its warnings are reported already.
    Diagnostics known_warnings;
    auto prepared = PreparedScenario::prepare(scenario.value(), known_warnings);
    if (!prepared) {
      diagnostics_.append(std::move(prepared.diagnostics()));
    } else if (trials_ != nullptr) {
      trials_->try_scenario(scenario.value(), diagnostics_);
    }
  }

  IncludePath include_path_;
  Trials* trials_;
  Checked checked_;
  Diagnostics diagnostics_;
};

/// Prints the compiled code of programs instead of their errors.
ExitCode dump_code(std::span<const std::string> files, const IncludePath& include_path,
                   Console& console) {
  for (const std::string& path : files) {
    if (!path.ends_with(".asl")) {
      console.error(fmt::format("expected a program .asl, found '{}'", path),
                    "--dump-code shows the code of programs");
      return ExitCode::usage;
    }
    Diagnostics found;
    SymbolTable symbols;
    const SourceTree tree = load_agent(path, include_path, found);
    const auto program = compile(tree, symbols, found);
    console.report(found);
    if (program == nullptr || found.has_errors()) return ExitCode::usage;
    console.print(code_text(*program, symbols));
  }
  return ExitCode::success;
}

std::string names_of_checks() {
  std::size_t width = 0;
  for (const CheckInfo& each : checks()) width = std::max(width, each.name.size());
  std::string text;
  for (const CheckInfo& each : checks()) {
    text += fmt::format("{:<{}}  {}\n", each.name, width, each.summary);
  }
  return text;
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "FILE|FOLDER... [OPTIONS]",
      .description =
          "Diagnoses agents (.asl), Jason projects (.mas2j) and scenarios (.yaml), with the\n"
          "programs that they name, and the agents and projects of folders, without running\n"
          "them: mistakes of syntax, misspelt goals, percepts, actions, atoms and keys,\n"
          "variables without a value, plans that are never reached ... `jaywalk check\n"
          "--list` names the warnings; a comment `// jaywalk: allow CODE` silences one in\n"
          "its line and the next, `allow-file CODE` in the file. Exits with 2 if there are\n"
          "errors.\n",
      .options = {{option::kWerror, "", "treat warnings as errors"},
                  {option::kList, "", "name the warnings that there are, and check nothing"},
                  {option::kTry, "",
                   "start each program that a file names (controllers, simulators, systems\n"
                   "under test, worlds), ask its first questions and say what it answered"},
                  {option::kDumpCode, "", "print what the engine executes for each rule and plan"}},
      .examples =
          "  jaywalk check agents/crossing/proximity.asl\n"
          "  jaywalk check scenarios/external.yaml --try\n"
          "  jaywalk check agents scenarios/*.yaml --werror\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.has(option::kList)) {
    console.print(names_of_checks());
    return ExitCode::success;
  }
  if (arguments.operands().empty()) {
    console.error("expected at least one file", "jaywalk check --help shows how to write it");
    return ExitCode::usage;
  }
  const auto include_path = read_include_path(arguments, console);
  if (!include_path) return ExitCode::usage;
  constexpr std::array kWanted{InputKind::program, InputKind::project, InputKind::scenario,
                               InputKind::search};
  Diagnostics wrong;
  const auto operands = input_files(arguments.operands(), kWanted, wrong);
  console.report(wrong);
  std::vector<std::string> files;
  const bool all_found = expand_folders(operands, kEndings, console, files) && !wrong.has_errors();
  if (arguments.has(option::kDumpCode)) {
    return all_found ? dump_code(files, *include_path, console) : ExitCode::usage;
  }
  // Projects first, since they say more about their agents than a program alone does.
  std::stable_partition(files.begin(), files.end(),
                        [](const std::string& path) { return path.ends_with(kEndings[1]); });
  std::optional<InterruptGuard> interrupt;
  std::optional<Trials> trials;
  if (arguments.has(option::kTry)) {
    interrupt.emplace();
    trials.emplace(console);
  }
  const auto is_interrupted = [&] { return interrupt && interrupt->interrupted(); };
  Checker checker(*include_path, trials ? &*trials : nullptr);
  std::size_t checked = 0;
  for (const std::string& path : files) {
    if (is_interrupted()) break;
    if (checker.check_file(path)) {
      ++checked;
    } else {
      console.error(fmt::format("expected a file .asl, .mas2j or .yaml, found '{}'", path));
    }
  }
  if (is_interrupted()) {
    console.note("interrupted");
    return ExitCode::interrupted;
  }
  const bool all_checked = all_found && checked == files.size();
  const Diagnostics& found = checker.diagnostics();
  console.report(found);
  console.print(fmt::format("{} checked: {}, {}\n", counted(checked, "file"),
                            counted(found.error_count() + wrong.error_count(), "error"),
                            counted(found.warning_count(), "warning")));
  const bool failed =
      found.has_errors() || (arguments.has(option::kWerror) && found.warning_count() > 0);
  return failed || !all_checked ? ExitCode::usage : ExitCode::success;
}

}  // namespace jaywalk::command::check
