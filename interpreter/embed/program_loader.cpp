// SPDX-License-Identifier: Apache-2.0
#include "interpreter/embed/program_loader.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "interpreter/compile/compiler.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

std::string first_error(const Diagnostics& diagnostics) {
  const auto error = std::ranges::find(diagnostics.items(), Severity::error, &Diagnostic::severity);
  if (error == diagnostics.items().end()) return "the program cannot be read";
  if (error->where.source == nullptr) return fmt::format("{}: {}", error->subject, error->message);
  const auto at = error->where.source->position(error->where.span.begin);
  return fmt::format("{}:{}:{}: {}", error->where.source->name(), at.line, at.column,
                     error->message);
}

}  // namespace

ProgramLoader::ProgramLoader(const std::string& folder, IncludePath include_path,
                             const ActionRegistry* actions)
    : folders_({folder}), include_path_(std::move(include_path)), actions_(actions) {
  include_path_.files.allow_reading(folder);
  readable_ = include_path_.readable_from(folder);
}

std::string ProgramLoader::find(const std::string& file) const {
  for (const auto* folders : {&folders_, &include_path_.source_path, &include_path_.folders}) {
    for (const std::string& folder : *folders) {
      const fs::path candidate = (fs::path(folder) / file).lexically_normal();
      std::error_code ignored;
      if (fs::is_regular_file(candidate, ignored)) return candidate.string();
    }
  }
  return file;
}

bool ProgramLoader::may_read(const std::string& path, LoadProblem& problem) const {
  const std::string file = include_path_.files.place(path);
  std::error_code ignored;
  // A missing file is reported as missing, whatever may be read.
  if (!fs::exists(file, ignored)) return true;
  const auto denial = readable_.denial(file);
  if (denial) problem = {fmt::format("cannot read {}: {}", path, denial->text()), true};
  return !denial;
}

std::shared_ptr<const Program> ProgramLoader::load(const ProgramRequest& request,
                                                   SymbolTable& symbols, LoadProblem& problem) {
  // An agent may be created without a program.
  static const std::string kEmpty;
  const std::string* const text =
      request.file.empty() ? &kEmpty : include_path_.given_text(request.file);
  const std::string path = find(request.file);
  if (text == nullptr && !may_read(path, problem)) return nullptr;
  std::error_code ignored;
  const fs::file_time_type changed = fs::last_write_time(path, ignored);
  const std::string key = fmt::format("{}\n{}\n{}", path, request.included, request.ns);
  const auto known = loaded_.find(key);
  if (known != loaded_.end() && known->second.changed == changed) return known->second.program;
  Diagnostics diagnostics;
  const SourceTree tree = text != nullptr
                              ? load_agent(std::make_shared<const Source>(request.file, *text),
                                           include_path_, diagnostics)
                              : load_agent(path, include_path_, diagnostics);
  auto program = compile(tree, symbols, diagnostics,
                         {.ns = request.ns, .fresh_names = request.included, .actions = actions_});
  if (diagnostics.has_errors()) problem.text = first_error(diagnostics);
  if (program == nullptr) return nullptr;
  if (!request.included || !program->has_own_namespaces()) loaded_[key] = {changed, program};
  return program;
}

}  // namespace jaywalk
