#include "tools/jaywalk/lsp_workspace.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

namespace jaywalk::lsp {
namespace {

namespace fs = std::filesystem;

bool is_name(const Use& use, const Name& name) {
  return use.what == name.what && use.arity == name.arity && use.name == name.text;
}

// Adds the programs of a folder, without hidden ones; with `depth` 0 not those of its folders.
void find_programs(const std::string& folder, int depth, std::set<std::string>& paths) {
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         failure);
  std::size_t seen = 0;
  for (const fs::recursive_directory_iterator end;
       !failure && entry != end && ++seen < kMostEntries && paths.size() < kMostPrograms;
       entry.increment(failure)) {
    const fs::path& path = entry->path();
    if (entry.depth() >= depth || path.filename().string().starts_with('.')) {
      entry.disable_recursion_pending();
    }
    if (path.extension() == ".asl") paths.insert(path.lexically_normal().generic_string());
  }
}

}  // namespace

Workspace::Workspace(const Folders& folders, const std::vector<std::string>& open,
                     const IncludePath& include_path) {
  constexpr int kDeepest = 100;
  for (const std::string& path : open) read(path, include_path);
  std::set<std::string> paths;
  for (const std::string& folder : folders.whole) find_programs(folder, kDeepest, paths);
  for (const std::string& folder : folders.alone) find_programs(folder, 0, paths);
  for (const std::string& path : paths) read(path, include_path);
}

void Workspace::read(const std::string& path, const IncludePath& include_path) {
  if (programs_.size() >= kMostPrograms || programs_.contains(path)) return;
  Diagnostics ignored;
  Program program;
  program.tree = load_agent(path, include_path, ignored);
  program.uses = uses_of_names(program.tree);
  programs_.emplace(path, std::move(program));
}

// From a file to the other files with the name of all programs that it is part of, and so on.
std::set<std::string> Workspace::files_of(const Name& name, const std::string& path) const {
  std::vector<std::set<std::string>> together;  // the files with the name, by program
  bool is_told = false;
  for (const auto& [main, program] : programs_) {
    std::set<std::string> files;
    for (const Use& use : program.uses) {
      if (!is_name(use, name)) continue;
      files.insert(use.file->source->name());
      is_told = is_told || use.in_message;
    }
    together.push_back(std::move(files));
  }
  std::set<std::string> found{path};
  const auto meets = [&found](const std::string& file) { return found.contains(file); };
  for (std::size_t before = 0; before != found.size();) {
    before = found.size();
    for (const std::set<std::string>& files : together) {
      if (is_told || std::ranges::any_of(files, meets)) found.insert(files.begin(), files.end());
    }
  }
  return found;
}

std::vector<Place> Workspace::uses(const Name& name, const std::string& path,
                                   Definitions definitions) const {
  const std::set<std::string> files = files_of(name, path);
  std::set<std::tuple<std::string, std::uint32_t>> seen;
  std::vector<Place> places;
  for (const auto& [main, program] : programs_) {
    for (const Use& use : program.uses) {
      const SourcePtr& source = use.file->source;
      const bool wanted = is_name(use, name) && files.contains(source->name()) &&
                          (definitions == Definitions::included || !use.defines);
      if (!wanted || !seen.emplace(source->name(), use.span.begin).second) continue;
      places.push_back({source->name(), TextPlaces(source->text()).range(use.span)});
    }
  }
  std::ranges::sort(places, {}, [](const Place& place) {
    return std::tuple(place.path, place.range.begin.line, place.range.begin.unit);
  });
  return places;
}

bool Workspace::is_taken(const Name& name, std::string_view text, const std::string& path) const {
  const std::set<std::string> files = files_of(name, path);
  return std::ranges::any_of(programs_, [&](const auto& each) {
    const auto& [main, program] = each;
    const bool concerned = std::ranges::any_of(program.uses, [&](const Use& use) {
      return is_name(use, name) && files.contains(use.file->source->name());
    });
    return concerned && std::ranges::any_of(program.uses, [&](const Use& use) {
             return use.what == name.what && use.arity == name.arity && use.name == text;
           });
  });
}

}  // namespace jaywalk::lsp
