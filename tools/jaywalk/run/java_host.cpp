// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/run/java_host.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/syntax/load.h"
#include "tools/jaywalk/options/shipped.h"
#include "tools/jaywalk/run/world_calls.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJasonHome = "JASON_HOME";
constexpr const char* kJavaHome = "JAVA_HOME";

/// A variable that is set, and not to nothing.
std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

/// The program `java`: that of JAVA_HOME, or the one in PATH; empty if there is none.
std::string find_java() {
  std::error_code ignored;
  std::vector<fs::path> folders;
  if (const std::string home = variable(kJavaHome); !home.empty()) {
    folders.push_back(fs::path(home) / "bin");
  } else {
    const std::string path = variable("PATH");
    for (std::size_t begin = 0; begin <= path.size();) {
      const std::size_t end = std::min(path.find(':', begin), path.size());
      folders.emplace_back(path.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / "java", ignored)) return (folder / "java").string();
  }
  return {};
}

}  // namespace

bool has_jason(const Arguments& arguments) {
  return arguments.has(option::kJason) || !variable(kJasonHome).empty();
}

bool calls_java(const std::vector<ProgramSource>& programs) {
  return std::ranges::any_of(programs, [](const ProgramSource& program) {
    Diagnostics ignored;  // reported when it is compiled
    const ForeignNames names = foreign_names(load_source(program, ignored));
    return !names.actions.empty() || !names.functions.empty();
  });
}

std::optional<OwnWorld> java_world(const Arguments& arguments, const ProjectJava& java,
                                   const std::string& folder, Diagnostics& diagnostics) {
  OwnWorld world;
  world.folder = folder;
  world.has_actions = true;
  world.title = "the project's Java classes";
  if (java.environment) {
    world.where = java.environment->where;
    world.title = fmt::format("the environment '{}'", java.environment->name);
  }
  const std::string option = arguments.text(option::kJason).value_or("");
  const std::string jason = option.empty() ? variable(kJasonHome) : option;
  world.named_by = option.empty() ? kJasonHome : option::kJason.dashed();
  std::error_code ignored;
  if (!fs::exists(jason, ignored)) {
    diagnostics.error(world.named_by, fmt::format("there is no file or folder '{}'", jason));
    return std::nullopt;
  }
  const std::string program = find_java();
  if (program.empty()) {
    const std::string home = variable(kJavaHome);
    diagnostics.error(
        home.empty() ? "java" : kJavaHome,
        home.empty() ? "is not in PATH" : fmt::format("there is no bin/java in '{}'", home),
        "install a Java development kit (Debian: default-jdk-headless), or set JAVA_HOME to one");
    return std::nullopt;
  }
  // The machine runs in the project's folder.
  const std::string adapter = fs::absolute(fs::path(shipped_folder()) / "jason", ignored).string();
  world.command = {program, adapter + "/Launch.java", adapter,
                   fs::absolute(jason, ignored).string(),
                   fmt::format("{}", fmt::join(java.class_path, ":"))};
  if (java.environment) {
    world.command.push_back(java.environment->name);
    for (const std::string& each : java.environment->parameters) {
      world.command.push_back(each.starts_with('"') ? string_content(each) : each);
    }
  }
  return world;
}

}  // namespace jaywalk
