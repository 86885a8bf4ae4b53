// `jaywalk check`: what is wrong with programs, projects and scenarios, without running them.

#include "interpreter/check/check.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "env/environments.h"
#include "experiment/trial.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/syntax/load.h"
#include "interpreter/term/symbol.h"
#include "tools/jaywalk/command.h"
#include "tools/jaywalk/include_path.h"
#include "tools/jaywalk/project_agents.h"
#include "tools/jaywalk/scenario_options.h"
#include "tools/jaywalk/vocabulary.h"

namespace jaywalk::command::check {
namespace {

/// Checks files, each program once however many scenarios and projects name it.
class Checker {
 public:
  explicit Checker(IncludePath include_path) : include_path_(std::move(include_path)) {}

  /// False: files of that kind cannot be checked.
  bool check_file(const std::string& path) {
    if (is_scenario_file(path)) {
      check_scenario(path);
    } else if (path.ends_with(".asl")) {
      check_program({.path = path, .include_path = include_path_}, nullptr);
    } else if (path.ends_with(".mas2j")) {
      check_project(path);
    } else {
      return false;
    }
    return true;
  }

  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  /// Without an environment, that which the program seems to be written for.
  void check_program(const ProgramSource& program, const EnvironmentKind* environment) {
    if (!program.text && !checked_.insert(program.path).second) return;
    Diagnostics found;
    const SourceTree tree = program.text ? load_agent(program.text, program.include_path, found)
                                         : load_agent(program.path, program.include_path, found);
    if (!found.has_errors()) {
      SymbolTable symbols;
      (void)compile(tree, symbols, found);
    }
    if (!found.has_errors()) {
      if (environment == nullptr) environment = environment_of(tree);
      jaywalk::check_program(tree, vocabulary_for(environment), found);
    }
    diagnostics_.append(std::move(found));
  }

  void check_project(const std::string& path) {
    const auto programs =
        read_project_agents(path, include_path_, JavaParts::ignored, diagnostics_);
    if (!programs) return;
    for (const ProgramSource& program : *programs) check_program(program, nullptr);
  }

  void check_scenario(const std::string& path) {
    auto scenario = read_scenario(path);
    if (!scenario) {
      diagnostics_.append(std::move(scenario.diagnostics()));
      return;
    }
    const std::size_t errors = diagnostics_.error_count();
    for (const BehaviourSpec& behaviour : scenario.value().behaviours) {
      check_program({.path = behaviour.program, .include_path = include_path_},
                    find_environment("crossing"));
    }
    if (diagnostics_.error_count() > errors) return;
    // What remains is how parameters and programs fit together.
    Diagnostics known_warnings;
    auto prepared = PreparedScenario::prepare(std::move(scenario).value(), known_warnings);
    if (!prepared) diagnostics_.append(std::move(prepared.diagnostics()));
  }

  IncludePath include_path_;
  std::set<std::string> checked_;
  Diagnostics diagnostics_;
};

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

CommandHelp help() {
  CommandHelp help{
      .usage = "FILE... [OPTIONS]",
      .description =
          "Diagnoses agents (.asl), Jason projects (.mas2j) and scenarios (.yaml), with the\n"
          "programs that they name, without running them: mistakes of syntax, misspelt\n"
          "goals, percepts, actions and keys. Exits with 2 if there are errors.\n",
      .options = {{"werror", "", "treat warnings as errors"}},
      .examples =
          "  jaywalk check agents/crossing/proximity.asl\n"
          "  jaywalk check agents/crossing/*.asl scenarios/*.yaml --werror\n"};
  help.options.insert(help.options.end(), kIncludeOptions.begin(), kIncludeOptions.end());
  return help;
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().empty()) {
    console.error("expected at least one file", "jaywalk check --help shows how to write it");
    return ExitCode::usage;
  }
  const auto include_path = read_include_path(arguments, console);
  if (!include_path) return ExitCode::usage;
  Checker checker(*include_path);
  std::size_t checked = 0;
  for (const std::string& path : arguments.operands()) {
    if (checker.check_file(path)) {
      ++checked;
    } else {
      console.error(fmt::format("expected a file .asl, .mas2j or .yaml, found '{}'", path));
    }
  }
  const bool all_checked = checked == arguments.operands().size();
  const Diagnostics& found = checker.diagnostics();
  console.report(found);
  console.print(fmt::format("{} checked: {}, {}\n", counted(checked, "file"),
                            counted(found.error_count(), "error"),
                            counted(found.warning_count(), "warning")));
  const bool failed = found.has_errors() || (arguments.has("werror") && found.warning_count() > 0);
  return failed || !all_checked ? ExitCode::usage : ExitCode::success;
}

}  // namespace jaywalk::command::check
