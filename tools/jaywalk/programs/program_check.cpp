// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/programs/program_check.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "experiment/test_run/prepared_scenario.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/support/source_files.h"
#include "interpreter/term/symbol.h"
#include "tools/jaywalk/programs/vocabulary.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// Whether a project lies in the program's folder or above it.
bool lies_in_project(const std::string& path) {
  return find_project_folder(fs::path(path).parent_path().string()).has_value();
}

/// Each once, in the order of the scenario.
std::vector<std::string> programs_of(const Scenario& scenario) {
  std::vector<std::string> programs;
  std::set<std::string> known;
  const auto add = [&](const std::string& program) {
    if (known.insert(fs::path(program).lexically_normal().string()).second) {
      programs.push_back(program);
    }
  };
  for (const BehaviourSpec& behaviour : scenario.behaviours) {
    add(behaviour.program);
    for (const TeamMember& member : behaviour.team) add(member.program);
  }
  for (const BehaviourSpec& actor : scenario.actors) add(actor.program);
  return programs;
}

/// Whether all agents of a test that has the program run that program.
bool has_no_others(const Scenario& scenario, const std::string& program) {
  return scenario.actors.empty() &&
         std::ranges::all_of(scenario.behaviours, [&](const BehaviourSpec& behaviour) {
           const bool has_part = behaviour.program == program ||
                                 std::ranges::any_of(behaviour.team, [&](const TeamMember& member) {
                                   return member.program == program;
                                 });
           return behaviour.team.empty() || !has_part;
         });
}

}  // namespace

void check_loaded(const SourceTree& program, const EnvironmentKind* environment,
                  const std::function<void(Vocabulary&)>& complete, Diagnostics& found) {
  if (!found.has_errors()) {
    SymbolTable symbols;
    (void)compile(program, symbols, found);
  }
  if (found.has_errors()) return;
  Vocabulary vocabulary = vocabulary_for(environment);
  complete(vocabulary);
  check_program(program, vocabulary, found);
}

void add_news(const Diagnostics& news, Checked& checked, Diagnostics& found) {
  for (const Diagnostic& each : news.items()) {
    if (checked.said.insert(render(each)).second) found.add(each);
  }
}

void check_programs(const Scenario& scenario, Checked& checked, Diagnostics& found) {
  for (const std::string& program : programs_of(scenario)) {
    checked.programs.insert(fs::path(program).lexically_normal().string());
    Diagnostics of_program;
    const SourceTree tree = load_agent(program, include_path(scenario), of_program);
    of_program = with_errors(of_program, kMissingInclude, kMissingIncludeHint);
    const auto complete = [&](Vocabulary& vocabulary) {
      vocabulary.settings = settings_of(scenario, program);
      vocabulary.begins_by_itself = has_no_others(scenario, program);
      mark_absent_percepts(scenario, vocabulary);
    };
    check_loaded(tree, find_environment(scenario.world->kind()), complete, of_program);
    add_news(of_program, checked, found);
  }
}

void check_compiled(const SourceTree& program, const std::string& path, StartedAs started,
                    KnownWorld world, const ActionRegistry* actions, Diagnostics& found) {
  ProgramWords words = words_of(program);
  Vocabulary vocabulary = vocabulary_for(world ? *world : environment_of(words));
  if (actions != nullptr) add_own_actions(*actions, vocabulary);
  vocabulary.may_be_alone = started == StartedAs::alone && !lies_in_project(path);
  vocabulary.begins_by_itself = started == StartedAs::alone;
  check_program(program, std::move(words), vocabulary, found);
}

void check_alone(const SourceTree& program, const std::string& path, Diagnostics& found) {
  check_loaded(
      program, environment_of(program),
      [&path](Vocabulary& vocabulary) { vocabulary.may_be_alone = !lies_in_project(path); }, found);
}

}  // namespace jaywalk
