// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/lsp/lsp_workspace.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>
#include <utility>

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

// Installed programs may be reached by links; empty if there are none.
fs::path library_of(const SourceFiles& files) {
  std::error_code failure;
  const std::string name = std::string(kLibraryPrefix) + "crossing";
  const std::string place = files.place(name);
  return place == name ? fs::path() : fs::weakly_canonical(place, failure).parent_path();
}

}  // namespace

std::string file_of(const std::string& name, const SourceFiles& files) {
  if (!name.starts_with(kLibraryPrefix)) return name;
  const fs::path library = library_of(files);
  return library.empty() ? name : (library / name.substr(kLibraryPrefix.size())).generic_string();
}

std::string installed_name(const std::string& file, const SourceFiles& files) {
  const fs::path library = library_of(files);
  std::error_code failure;
  const fs::path below = fs::weakly_canonical(file, failure).lexically_relative(library);
  const bool outside = library.empty() || below.empty() || *below.begin() == "..";
  return outside ? std::string() : std::string(kLibraryPrefix) + below.generic_string();
}

Workspace::Workspace(const Folders& folders, const std::vector<std::string>& open,
                     const IncludePath& include_path)
    : files_(include_path.files) {
  constexpr int kDeepest = 100;
  for (const std::string& path : open) read(path, include_path);
  std::set<std::string> paths;
  for (const std::string& folder : folders.whole) find_programs(folder, kDeepest, paths);
  for (const std::string& folder : folders.alone) find_programs(folder, 0, paths);
  for (const std::string& path : paths) read(path, include_path);
}

std::string Workspace::file_of(const Use& use) const {
  return lsp::file_of(use.file->source->name(), files_);
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
      files.insert(file_of(use));
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
      if (!is_name(use, name) || (definitions == Definitions::left_out && use.defines)) continue;
      std::string file = file_of(use);
      if (!files.contains(file) || !seen.emplace(file, use.span.begin).second) continue;
      places.push_back({std::move(file), TextPlaces(use.file->source->text()).range(use.span)});
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
      return is_name(use, name) && files.contains(file_of(use));
    });
    return concerned && std::ranges::any_of(program.uses, [&](const Use& use) {
             return use.what == name.what && use.arity == name.arity && use.name == text;
           });
  });
}

}  // namespace jaywalk::lsp
