// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/run/own_world.h"

#include <string_view>
#include <utility>
#include <wordexp.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace jaywalk {
namespace {

/// Why the shell's rules do not divide a command into words; by the result of wordexp().
std::string_view no_command(int result) {
  switch (result) {
    case WRDE_BADCHAR:
      return "one of | & ; < > ( ) { } must be in quotes";
    case WRDE_BADVAL:
      return "it names a variable that is not set";
    case WRDE_CMDSUB:
      return "the output of another command cannot be put into it";
    case WRDE_SYNTAX:
      return "a quote or bracket is not closed";
    default:
      return "there is no memory for it";
  }
}

/// The words of a command, as a shell divides them; none after reporting why not.
std::vector<std::string> words_of_command(const std::string& command, const OwnWorld& world,
                                          Diagnostics& diagnostics) {
  std::vector<std::string> words;
  wordexp_t found{};
  const int result = wordexp(command.c_str(), &found, WRDE_NOCMD | WRDE_UNDEF);
  if (result == 0) {
    words.assign(found.we_wordv, found.we_wordv + found.we_wordc);
  } else {
    world.error(fmt::format("not a command: {}", no_command(result)), diagnostics);
  }
  if (result == 0 || result == WRDE_NOSPACE) wordfree(&found);
  if (result == 0 && words.empty()) world.error("expected a command, found none", diagnostics);
  return words;
}

std::vector<EnvironmentWord> table_of(
    const std::optional<std::vector<EnvironmentIdentity::Word>>& words) {
  std::vector<EnvironmentWord> table;
  if (!words) return table;
  for (const EnvironmentIdentity::Word& word : *words) {
    table.push_back({.form = word.form, .meaning = word.meaning});
  }
  return table;
}

}  // namespace

void OwnWorld::error(std::string message, Diagnostics& diagnostics) const {
  if (where.source != nullptr) {
    diagnostics.error(where, std::move(message));
  } else {
    diagnostics.error(named_by, std::move(message));
  }
}

void OwnWorld::report_failure(const ProcessEnvironment& world, Diagnostics& diagnostics) const {
  if (world.failure().empty()) return;
  const std::string name =
      title.empty() ? fmt::format("the environment '{}'", fmt::join(command, " ")) : title;
  error(fmt::format("{}: {}", name, world.failure()), diagnostics);
  diagnostics.append(world.mistakes());
}

std::optional<OwnWorld> own_world(const Arguments& arguments,
                                  const std::optional<ProjectEnvironment>& project,
                                  const std::string& folder, Diagnostics& diagnostics) {
  const std::size_t errors = diagnostics.error_count();
  const auto option = arguments.text(option::kEnvironment);
  OwnWorld world;
  world.answer_s =
      arguments.positive(option::kEnvironmentTimeout, diagnostics).value_or(world.answer_s);
  if (option) {
    world.command = words_of_command(*option, world, diagnostics);
  } else if (project) {
    world.where = project->where;
    world.folder = folder;
    world.arguments = project->arguments;
    world.command = words_of_command(project->command, world, diagnostics);
  } else if (arguments.has(option::kEnvironmentTimeout)) {
    diagnostics.error(option::kEnvironmentTimeout.dashed(), "there is no environment to wait for",
                      "--environment names one");
  }
  if (world.command.empty() || diagnostics.error_count() > errors) return std::nullopt;
  return world;
}

std::unique_ptr<ProcessEnvironment> make_world(const OwnWorld& world, Console& console) {
  return std::make_unique<ProcessEnvironment>(ProcessEnvironment::Settings{
      .command = world.command,
      .folder = world.folder,
      .arguments = world.arguments,
      .answer_s = world.answer_s,
      // A world draws with the terminal's codes, which any program that the user starts may write.
      .show =
          [&console](std::string_view text) {
            console.control(text);
            console.flush();
          },
      .show_errors = [&console](std::string_view text) { console.note(text); }});
}

DeclaredWords::DeclaredWords(const EnvironmentIdentity& identity)
    : percepts_(table_of(identity.percepts)),
      actions_(table_of(identity.actions)),
      is_complete_(identity.percepts && identity.actions) {
  kind_.name = identity.name;
  kind_.percepts = percepts_;
  kind_.actions = actions_;
}

}  // namespace jaywalk
