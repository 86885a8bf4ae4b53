// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/run_case.h"

#include <algorithm>
#include <array>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <new>
#include <set>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "tests/helpers/run_agents.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::fuzz {
namespace {

constexpr std::string_view kInput = "input";

void write_files(const Case& made) {
  for (const auto& [name, text] : made.files) {
    if (const auto folder = std::filesystem::path(name).parent_path(); !folder.empty()) {
      std::filesystem::create_directories(folder);
    }
    std::ofstream(name, std::ios::binary) << text;
  }
  std::ofstream(std::string(kInput), std::ios::binary) << made.input;
}

/// The case's input becomes the standard one, from its beginning.
void open_input() {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the system has no other interface
  const int input = ::open(kInput.data(), O_RDONLY | O_CLOEXEC);
  (void)::dup2(input, STDIN_FILENO);
  (void)::close(input);
}

void run_programs(const Case& made) {
  if (made.agents.empty()) return;
  std::vector<test::NamedProgram> programs;
  for (const std::string& file : made.agents) {
    programs.push_back({std::filesystem::path(file).stem().string(), made.files.at(file)});
  }
  MasOptions options;
  options.max_cycles = 100;
  options.max_inferences = 5'000;
  options.max_agent_bytes = 2U << 20U;
  (void)test::run_agents(programs, options);
}

/// The options of a command: its own and those that all have.
std::vector<OptionSpec> options_of(const Command& command) {
  std::vector<OptionSpec> options = command.help().options;
  options.insert(options.end(), common_options().begin(), common_options().end());
  return options;
}

/// A search of roads has no agents to limit.
bool runs_agents(const Case& made, const std::vector<std::string>& words) {
  if (words.front() != "search") return true;
  return std::ranges::any_of(made.files, [](const auto& file) {
    return file.second.find("kind: crossing") != std::string::npos;
  });
}

/// Commands that take limits of a test get small ones, of inferences and megabytes: programs at
/// random reach them often.
std::vector<std::string> with_limits(const Case& made, std::vector<std::string> words) {
  if (!runs_agents(made, words)) return words;
  constexpr std::array<std::pair<OptionName, std::string_view>, 2> kLimits{
      {{option::kMaxInferences, "1000000"}, {option::kMaxMemory, "64"}}};
  for (const Command& command : commands()) {
    if (command.name != words.front()) continue;
    for (const OptionSpec& option : options_of(command)) {
      for (const auto& [name, value] : kLimits) {
        if (option.name == name) words.push_back(name.dashed() + "=" + std::string(value));
      }
    }
  }
  return words;
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

using Names = std::set<std::string>;

/// The names in a folder that begin in some way.
Names names_in(const std::filesystem::path& folder, std::string_view begin = {}) {
  Names names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::string name = entry->path().filename().string();
    if (name.starts_with(begin)) names.insert(std::move(name));
  }
  return names;
}

/// Around the folder of a case: beside it, and where absolute paths lead.
class Surroundings {
 public:
  explicit Surroundings(const std::string& folder)
      : beside_(std::filesystem::path(folder).parent_path()), before_(names_in(beside_)) {}

  /// A file that the case has made where it should not; empty if it has made none.
  [[nodiscard]] std::string stray(const Case& made) const {
    if (made.outputs.empty()) return {};
    for (const std::string& name : names_in(beside_)) {
      if (before_.contains(name)) continue;
      std::filesystem::remove_all(beside_ / name);  // so that the case does the same again
      return "../" + name;
    }
    for (const std::string& name : names_in(".")) {
      const auto begins = [&](const std::string& output) { return name.starts_with(output); };
      const auto is_or_lies_in = [&](const auto& file) {
        return file.first == name || file.first.starts_with(name + '/');
      };
      if (name == kInput || std::ranges::any_of(made.files, is_or_lies_in)) continue;
      if (std::ranges::none_of(made.outputs, begins)) return name;
    }
    const std::filesystem::path outside(kOutside);
    const Names there = names_in(outside.parent_path(), outside.filename().string());
    for (const std::string& name : there) std::filesystem::remove(outside.parent_path() / name);
    return there.empty() ? std::string() : (outside.parent_path() / *there.begin()).string();
  }

 private:
  std::filesystem::path beside_;
  Names before_;
};

}  // namespace

int run_command(std::span<const std::string> words) {
  for (const Command& command : commands()) {
    if (command.name != words.front()) continue;
    const auto arguments = parse_arguments(words.subspan(1), options_of(command));
    if (!arguments) return static_cast<int>(ExitCode::usage);
    Console console;
    const ExitCode code = command.execute(arguments.value(), console);
    (void)console.finish();
    return static_cast<int>(code);
  }
  return static_cast<int>(ExitCode::internal);
}

std::string run_case(const Case& made, const std::string& folder) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  std::filesystem::current_path(folder);
  const Surroundings surroundings(folder);
  write_files(made);
  try {
    run_programs(made);
    for (const auto& words : made.commands) {
      open_input();
      const int code = run_command(with_limits(made, words));
      if (code < 0 || code > 2) return "exit code " + std::to_string(code) + " of " + words.front();
    }
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return std::string("internal error: ") + error.what();
  }
  const std::string stray = surroundings.stray(made);
  return stray.empty() ? stray : "exit with a file outside: " + stray;
}

void write_case(const Case& made, const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::filesystem::current_path(folder);
  write_files(made);
  std::ofstream script("repeat");
  script << "#!/bin/sh\ncd \"$(dirname \"$0\")\" || exit\n";
  if (!made.agents.empty()) {
    script << "# Together, under the limits of tests/fuzz/run_case.cpp:";
    for (const std::string& file : made.agents) script << " " << file;
    script << "\n";
  }
  for (const auto& words : made.commands) {
    script << "jaywalk";
    for (const std::string& word : with_limits(made, words)) script << " " << quoted(word);
    script << " <" << kInput << "\n";
  }
}

}  // namespace jaywalk::fuzz
