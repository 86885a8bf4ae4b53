// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/files/program_copies.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "experiment/scenario/files/write_file.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

Diagnostics cannot_write(const std::string& path) {
  Diagnostics diagnostics;
  diagnostics.error(path, "cannot write the kept copy of a program to start it");
  return diagnostics;
}

// Two commands may name the same program.
void add_once(std::vector<SourcePtr>& sources, const SourcePtr& program) {
  const bool is_there = std::ranges::any_of(
      sources, [&](const SourcePtr& each) { return each->name() == program->name(); });
  if (!is_there) sources.push_back(program);
}

bool is_as_it_was(const Source& kept) {
  std::error_code error;
  if (!fs::is_regular_file(kept.name(), error)) return false;
  const auto now = read_source(kept.name());
  return now.ok() && now.value()->text() == kept.text();
}

}  // namespace

Result<std::string> ProgramCopies::add(const Source& program) {
  // The file keeps its name, since an interpreter may depend on it; so each gets its own folder.
  const fs::path path = output_path((fs::path(folder_.path()) / std::to_string(count_++)).string(),
                                    fs::path(program.name()).filename().string());
  std::error_code error;
  if (folder_.path().empty() || !fs::create_directory(path.parent_path(), error)) {
    return cannot_write(program.name());
  }
  std::ofstream file(path, std::ios::binary);
  file << program.text();
  file.close();
  fs::permissions(path, fs::perms::owner_all, error);
  if (!file || error) return cannot_write(program.name());
  return path.string();
}

Result<std::shared_ptr<const ProgramCopies>> keep_programs(
    std::span<std::vector<std::string>* const> commands, const SourceFiles& files,
    std::vector<SourcePtr>& sources) {
  std::shared_ptr<ProgramCopies> copies;
  for (std::vector<std::string>* const command : commands) {
    for (std::string& word : *command) {
      if (!files.has(word)) continue;
      const auto program = files.read(word);
      if (!program.ok()) continue;  // no text, as the interpreter itself
      add_once(sources, program.value());
      if (is_as_it_was(*program.value())) continue;
      if (!copies) copies = std::make_shared<ProgramCopies>();
      auto copy = copies->add(*program.value());
      if (!copy) return std::move(copy.diagnostics());
      word = std::move(copy).value();
    }
  }
  return std::shared_ptr<const ProgramCopies>(std::move(copies));
}

}  // namespace jaywalk
