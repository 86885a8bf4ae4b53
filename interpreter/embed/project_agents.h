// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a Jason project to the programs that its agents run, and to the world that they act in. What
// only Java can do is refused, or left out if the user says so.

#include <optional>
#include <string>
#include <vector>

#include "interpreter/agent/surroundings/settings.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"
#include "interpreter/syntax/project/project.h"

namespace jaywalk {

/// A program and the agents that run it.
struct ProgramSource {
  std::string path;
  /// If set, the program is this text, which includes the file at `path`.
  SourcePtr text;
  IncludePath include_path;
  std::vector<std::string> agents;
  ReasoningSettings settings;
};

/// An environment that is a program: `environment: process("python3 world.py", kitchen)`. It runs
/// in the project's folder.
struct ProjectEnvironment {
  /// Words as for a shell.
  std::string command;
  /// Terms, as they are written.
  std::vector<std::string> arguments;
  SourceSpan where;
};

/// The parts of a project that a host of Java classes needs.
struct ProjectJava {
  /// The environment, if it is a class.
  std::optional<ProjectClass> environment;
  /// Folders and jars, as they are written.
  std::vector<std::string> class_path;
};

struct ProjectParts {
  std::vector<ProgramSource> programs;
  std::optional<ProjectEnvironment> environment;
  ProjectJava java;
};

/// What to do about Java classes.
struct JavaParts {
  /// There is a host for the environment. Other classes change how Jason itself reasons.
  bool hosted = false;
  /// Classes that are not hosted are left out, with a warning; otherwise they are refused.
  bool ignored = false;
};

/// Reads the project at `path`. Includes are looked for in the project's own folders before those
/// of `include_path`. Null after adding errors to `diagnostics`.
[[nodiscard]] std::optional<ProjectParts> read_project_agents(const std::string& path,
                                                              const IncludePath& include_path,
                                                              JavaParts java,
                                                              Diagnostics& diagnostics);

/// The program with all that it includes.
[[nodiscard]] SourceTree load_source(const ProgramSource& source, Diagnostics& diagnostics);

}  // namespace jaywalk
