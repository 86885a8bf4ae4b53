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

struct ProjectParts {
  std::vector<ProgramSource> programs;
  std::optional<ProjectEnvironment> environment;
};

enum class JavaParts { refused, ignored };

/// Reads the project at `path`. Includes are looked for in the project's own folders before those
/// of `include_path`. Null after adding errors to `diagnostics`.
[[nodiscard]] std::optional<ProjectParts> read_project_agents(const std::string& path,
                                                              const IncludePath& include_path,
                                                              JavaParts java,
                                                              Diagnostics& diagnostics);

}  // namespace jaywalk
