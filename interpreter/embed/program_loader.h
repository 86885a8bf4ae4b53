// SPDX-License-Identifier: Apache-2.0
#pragma once

// Programs that are loaded while a system runs (`.create_agent`, `.include`).

#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/agent/surroundings/host.h"
#include "interpreter/program/program.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

class ProgramLoader {
 public:
  /// For the programs of a folder (empty: the working one). Files are looked for there, then in the
  /// folders of the include path, then as they are named; only those that the programs may read
  /// are loaded. `actions`: those of CompileOptions.
  ProgramLoader(const std::string& folder, IncludePath include_path,
                const ActionRegistry* actions = nullptr);

  /// Compiles a file into `symbols`, which must be the same table in every call. A file that has
  /// not changed is read once, unless it is included and has namespaces of its own. Null after
  /// setting `problem`; a program with a problem as well has been loaded without the included file
  /// that has it.
  [[nodiscard]] std::shared_ptr<const Program> load(const ProgramRequest& request,
                                                    SymbolTable& symbols, LoadProblem& problem);

 private:
  struct Loaded {
    std::filesystem::file_time_type changed;
    std::shared_ptr<const Program> program;
  };

  [[nodiscard]] std::string find(const std::string& file) const;

  [[nodiscard]] bool may_read(const std::string& path, LoadProblem& problem) const;

  std::vector<std::string> folders_;
  IncludePath include_path_;
  AllowedFolders readable_;
  const ActionRegistry* actions_;
  std::unordered_map<std::string, Loaded> loaded_;  // by path, purpose and namespace
};

}  // namespace jaywalk
