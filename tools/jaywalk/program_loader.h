#pragma once

// Programs that are loaded while a system runs (`.create_agent`, `.include`).

#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/agent/host.h"
#include "interpreter/program/program.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

class ProgramLoader {
 public:
  /// Files are looked for in `folders`, then in those of the include path, then as they are named.
  ProgramLoader(std::vector<std::string> folders, IncludePath include_path)
      : folders_(std::move(folders)), include_path_(std::move(include_path)) {}

  /// Compiles a file into `symbols`, which must be the same table in every call. A file that has
  /// not changed is read once. Null after setting `error`; a program with an error as well has been
  /// loaded without the included file that has it.
  [[nodiscard]] std::shared_ptr<const Program> load(const ProgramRequest& request,
                                                    SymbolTable& symbols, std::string& error);

 private:
  struct Loaded {
    std::filesystem::file_time_type changed;
    std::shared_ptr<const Program> program;
  };

  [[nodiscard]] std::string find(const std::string& file) const;

  std::vector<std::string> folders_;
  IncludePath include_path_;
  std::unordered_map<std::string, Loaded> loaded_;  // by path, purpose and namespace
};

}  // namespace jaywalk
