// SPDX-License-Identifier: Apache-2.0
#include "interpreter/embed/project_agents.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/parser.h"
#include "interpreter/syntax/project/project.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// Java classes that do what every agent of ours does, or nothing that a program can see: Jason's
/// belief updates pass by the keys of IndexedBB, and controls and inspectors only look on.
constexpr std::array<std::string_view, 13> kOwnClasses = {"Agent",
                                                          "jason.asSemantics.Agent",
                                                          "AgArch",
                                                          "jason.architecture.AgArch",
                                                          "jason.architecture.MindInspectorAgArch",
                                                          "DefaultBeliefBase",
                                                          "jason.bb.DefaultBeliefBase",
                                                          "jason.bb.IndexedBB",
                                                          "jason.control.ExecutionControl",
                                                          "jason.control.ExecutionControlGUI",
                                                          "jason.environment.Environment",
                                                          "Local",
                                                          "Centralised"};

/// Not a class of Java: an environment that is a program.
constexpr std::string_view kProcess = "process";

bool needs_java(const ProjectClass& java_class) {
  return std::ranges::find(kOwnClasses, java_class.name) == kOwnClasses.end();
}

class JavaReport {
 public:
  JavaReport(JavaParts parts, Diagnostics& diagnostics)
      : parts_(parts), diagnostics_(diagnostics) {}

  /// `why` no host can run it; empty for what one can.
  void look_at(std::string_view role, const std::optional<ProjectClass>& java_class,
               std::string_view why) {
    if (!java_class || !needs_java(*java_class)) return;
    if (parts_.hosted && why.empty()) return;
    if (parts_.ignored) {
      diagnostics_.warning(java_class->where, "java",
                           fmt::format("{} '{}' is left out", role, java_class->name));
    } else if (why.empty()) {
      diagnostics_.error(
          java_class->where, fmt::format("{} '{}' is a Java class", role, java_class->name),
          "run with --jason PATH (see docs/guides/from_jason.md), or write the world "
          "as a program; --ignore-java runs the project without it");
    } else {
      diagnostics_.error(
          java_class->where,
          fmt::format("{} '{}' is a Java class that {}", role, java_class->name, why),
          "--ignore-java runs the project without it");
    }
  }

 private:
  JavaParts parts_;
  Diagnostics& diagnostics_;
};

/// Agents of Jade's platform are agents of one process here; what they say does not change.
bool is_jade(const std::optional<ProjectClass>& infrastructure) {
  return infrastructure && infrastructure->name == "Jade";
}

void look_for_java(const Project& project, JavaParts parts, Diagnostics& diagnostics) {
  constexpr std::string_view kReasons = "changes how Jason itself reasons, which does not run here";
  JavaReport report(parts, diagnostics);
  if (is_jade(project.infrastructure)) {
    diagnostics.warning(project.infrastructure->where, "java",
                        "all agents run in this process, not on the platform Jade");
  } else {
    report.look_at("the infrastructure", project.infrastructure,
                   "runs Jason's agents, which do not run here");
  }
  if (!project.environment || project.environment->name != kProcess) {
    report.look_at("the environment", project.environment, "");
  }
  report.look_at("the execution control", project.execution_control,
                 "controls the cycles of Jason's agents, which do not run here");
  for (const ProjectAgent& agent : project.agents) {
    report.look_at("the agent architecture", agent.arch_class, kReasons);
    report.look_at("the agent class", agent.agent_class, kReasons);
    report.look_at("the belief base", agent.belief_base_class,
                   "keeps the beliefs of Jason's agents, which do not run here");
  }
  for (const auto& [name, java_class] : project.directives) {
    report.look_at(fmt::format("the directive {}", name), java_class,
                   "changes plans of Jason's parser, which does not run here");
  }
}

std::optional<ProjectEnvironment> environment_of(const Project& project, Diagnostics& diagnostics) {
  if (!project.environment || project.environment->name != kProcess) return std::nullopt;
  const std::vector<std::string>& parameters = project.environment->parameters;
  if (parameters.empty() || !parameters.front().starts_with('"')) {
    diagnostics.error(project.environment->where, "expected the command of the process, in quotes",
                      "for example process(\"python3 world.py\")");
    return std::nullopt;
  }
  return ProjectEnvironment{.command = string_content(parameters.front()),
                            .arguments = {parameters.begin() + 1, parameters.end()},
                            .where = project.environment->where};
}

/// The program's file: beside the project, or in a folder of its source path.
std::string find_program(const ProjectAgent& agent, const fs::path& folder,
                         const std::vector<std::string>& source_path) {
  const std::string file = agent.file.empty() ? agent.name + ".asl" : agent.file;
  std::error_code ignored;
  for (const std::string& each : source_path) {
    const fs::path candidate = (fs::path(each) / file).lexically_normal();
    if (fs::exists(candidate, ignored)) return candidate.string();
  }
  // Plans name their place by a path from the working folder.
  return folder.empty() ? file : (folder / file).lexically_normal().string();
}

/// A folder of the source path, perhaps below one that --map gives a place.
std::string with_mapped_prefix(const std::string& folder, const IncludePath& include_path) {
  const std::size_t length = std::min(folder.find('/'), folder.size());
  for (const auto& [prefix, meant] : include_path.mapped) {
    if (folder.compare(0, length, prefix) != 0) continue;
    // The user's own path is relative to where the command runs.
    std::error_code ignored;
    return fs::absolute(meant + folder.substr(length), ignored).string();
  }
  return folder;
}

std::vector<std::string> names_of(const ProjectAgent& agent) {
  if (agent.count == 1) return {agent.name};
  std::vector<std::string> names;
  for (int i = 1; i <= agent.count; ++i) names.push_back(fmt::format("{}{}", agent.name, i));
  return names;
}

/// Options that Jason knows and that have no meaning here are passed over.
ReasoningSettings settings_of(const ProjectAgent& agent) {
  ReasoningSettings settings;
  for (const ProjectOption& option : agent.options) {
    if (option.name == "events" && option.value == "requeue") {
      settings.unwanted = ReasoningSettings::Unwanted::requeue;
    } else if (option.name == "intBels") {
      settings.same_focus = option.value != "newFocus";
    } else if (option.name == "nrcbp") {
      settings.cycles_per_look = static_cast<std::uint32_t>(
          std::clamp(std::strtol(option.value.c_str(), nullptr, 10), 1L, 1'000'000L));
    } else if (option.name == "verbose") {
      settings.verbosity =
          static_cast<int>(std::clamp(std::strtol(option.value.c_str(), nullptr, 10), 0L, 2L));
    } else if (option.name == "tro") {
      settings.tail_recursion = option.value != "false";
    } else if (option.name == "synchronised") {
      settings.messages_by_plans = option.value == "true";
    }
  }
  return settings;
}

/// The literals of an option, each as it was written; errors point into the project.
std::vector<std::string> literals_of(const ProjectAgent& agent, std::string_view option_name,
                                     Diagnostics& diagnostics) {
  const auto option = std::ranges::find(agent.options, option_name, &ProjectOption::name);
  if (option == agent.options.end()) return {};
  const auto text =
      std::make_shared<Source>(fmt::format("{} of {}", option_name, agent.name), option->value);
  ast::Arena arena;
  Diagnostics inner;
  const ast::Node* const list = parse_literals(text, arena, inner);
  if (list == nullptr) {
    const std::string why =
        inner.empty() ? "not a list of literals" : inner.items().front().message;
    diagnostics.error(option->where, fmt::format("in the {}: {}", option_name, why));
    return {};
  }
  std::vector<std::string> literals;
  for (const ast::Node* const literal : list->args) {
    literals.emplace_back(text->text(literal->span));
  }
  return literals;
}

/// A program that adds to another one the beliefs and goals that the project gives, in the order in
/// which Jason would: its goals before the program's, its beliefs added first. Beliefs of a program
/// are added from the last to the first.
SourcePtr extended_program(const std::string& path, const std::string& project_path,
                           std::vector<std::string> beliefs,
                           const std::vector<std::string>& goals) {
  std::string text;
  for (const std::string& goal : goals) text += fmt::format("!{}.\n", goal);
  const fs::path folder = fs::path(project_path).parent_path();
  const std::string relative =
      folder.empty() ? path : fs::path(path).lexically_relative(folder).string();
  text += fmt::format("{{ include(\"{}\") }}\n", relative.empty() ? path : relative);
  std::ranges::reverse(beliefs);
  for (const std::string& belief : beliefs) text += fmt::format("{}.\n", belief);
  return std::make_shared<Source>(project_path, std::move(text));
}

}  // namespace

std::optional<ProjectParts> read_project_agents(const std::string& path,
                                                const IncludePath& include_path, JavaParts java,
                                                Diagnostics& diagnostics) {
  auto source = read_any_encoding(path, diagnostics);
  if (!source) {
    diagnostics.append(std::move(source.diagnostics()));
    return std::nullopt;
  }
  const auto project = parse_project(source.value(), diagnostics);
  if (!project) return std::nullopt;
  look_for_java(*project, java, diagnostics);
  ProjectParts parts;
  parts.environment = environment_of(*project, diagnostics);
  parts.java.class_path = project->class_path;
  if (java.hosted && project->environment && !parts.environment &&
      needs_java(*project->environment)) {
    parts.java.environment = project->environment;
  }

  const fs::path folder = fs::path(path).parent_path();
  IncludePath folders = include_path;
  std::vector<std::string> source_path;
  // A source path is one from the project's folder, or else from the working one.
  for (const fs::path& from : {folder, fs::path()}) {
    for (const std::string& each : project->asl_source_path) {
      const fs::path searched = from / with_mapped_prefix(each, include_path);
      if (!from.empty() || folder.empty() || searched.is_relative()) {
        source_path.push_back(searched.lexically_normal().string());
      }
    }
    if (folder.empty()) break;
  }
  folders.source_path = source_path;
  // All of the project's programs may read what the project may.
  const std::string own_folder = folder.string();
  folders.files.allow_reading(own_folder);
  const AllowedFolders readable = folders.readable_from(own_folder);

  for (const ProjectAgent& agent : project->agents) {
    ProgramSource program{.path = find_program(agent, folder, source_path),
                          .include_path = folders,
                          .agents = names_of(agent),
                          .settings = settings_of(agent)};
    if (const auto denial = readable.denial(program.path)) {
      diagnostics.error(agent.where,
                        fmt::format("cannot read {}: {}", program.path, denial->message),
                        denial->hint);
      continue;
    }
    auto beliefs = literals_of(agent, "beliefs", diagnostics);
    const auto goals = literals_of(agent, "goals", diagnostics);
    if (!beliefs.empty() || !goals.empty()) {
      program.include_path.program =
          folder.empty() ? program.path : fs::path(program.path).lexically_normal().string();
      program.text = extended_program(program.path, path, std::move(beliefs), goals);
    }
    parts.programs.push_back(std::move(program));
  }
  if (diagnostics.has_errors()) return std::nullopt;
  return parts;
}

SourceTree load_source(const ProgramSource& source, Diagnostics& diagnostics) {
  return source.text ? load_agent(source.text, source.include_path, diagnostics)
                     : load_agent(source.path, source.include_path, diagnostics);
}

}  // namespace jaywalk
