// SPDX-License-Identifier: Apache-2.0
#pragma once

// A conformance program: AgentSpeak whose comments say what must come of it (see README.md).

#include <map>
#include <string>
#include <vector>

#include "tests/helpers/run_agents.h"

namespace jaywalk::test {

struct ProgramFile {
  std::vector<NamedProgram> agents;
  /// What `include`, `.include` and `.create_agent` can read.
  std::map<std::string, std::string> files;
  /// What each agent is to print.
  std::map<std::string, std::vector<std::string>> printed;
  std::vector<std::string> errors;
  std::vector<std::string> logged;
  std::string end = "idle";
  bool on_board = false;
  MasOptions options;
  /// What is wrong with the comments themselves.
  std::vector<std::string> problems;
};

[[nodiscard]] ProgramFile read_program_file(const std::string& path);

}  // namespace jaywalk::test
