// SPDX-License-Identifier: Apache-2.0
#pragma once

// The project file, `.mas2j`: which agents a multi-agent system consists of.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// A Java class with parameters, `jason.bb.IndexedBB("student(key,_)")`, as written.
struct ProjectClass {
  std::string name;
  std::vector<std::string> parameters;
  SourceSpan where;
};

struct ProjectOption {
  std::string name;
  std::string value;  // strings without their quotes
  SourceSpan where;   // of the value's content, so that errors inside point there
};

/// Agents of a project, in all.
inline constexpr std::int64_t kMostProjectAgents = 1'000'000;

struct ProjectAgent {
  std::string name;
  std::string file;  // as written, with the extension; empty: `name`.asl
  std::vector<ProjectOption> options;
  std::optional<ProjectClass> arch_class, agent_class, belief_base_class;
  int count = 1;  // `#n`
  std::string at;
  SourceSpan where;
};

struct Project {
  SourcePtr source;
  std::string name;
  std::optional<ProjectClass> infrastructure, environment, execution_control;
  std::vector<ProjectAgent> agents;
  std::vector<std::pair<std::string, ProjectClass>> directives;
  std::vector<std::string> class_path, asl_source_path;
};

/// The content of a string as it is written, `\"` converted.
[[nodiscard]] std::string string_content(std::string_view quoted);

/// Parses a project; diagnostics as for programs. A result is returned only if there are no errors.
[[nodiscard]] std::optional<Project> parse_project(SourcePtr source, Diagnostics& diagnostics);

}  // namespace jaywalk
