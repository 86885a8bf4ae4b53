// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/source_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// A folder's entries, sorted; none if it cannot be read.
std::vector<fs::directory_entry> entries_of(const fs::path& folder) {
  std::vector<fs::directory_entry> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    entries.push_back(*entry);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Nothing that leads out of the folder that it is looked for in.
bool stays_below(std::string_view path) {
  const fs::path normal = fs::path(path).lexically_normal();
  return !normal.empty() && !normal.is_absolute() && *normal.begin() != "..";
}

constexpr int kHighest = 4;

fs::path absolute_folder(const std::string& folder) {
  std::error_code error;
  fs::path own = fs::absolute(folder.empty() ? "." : folder, error).lexically_normal();
  if (!own.has_filename()) own = own.parent_path();  // of `folder/`
  return own;
}

/// The folder `agents` that a folder lies in or is: programs of a collection share the files in it,
/// in every copy of the collection.
std::optional<std::string> collection_of(const std::string& folder) {
  fs::path above = absolute_folder(folder);
  for (int i = 0; i < kHighest; ++i, above = above.parent_path()) {
    if (above.filename() == "agents") return above.string();
  }
  return std::nullopt;
}

/// Unit tests lie in a folder `tests` below the programs that they test.
std::optional<std::string> tested_folder(const std::string& folder) {
  const fs::path own = absolute_folder(folder);
  if (own.filename() != "tests") return std::nullopt;
  return own.parent_path().string();
}

}  // namespace

SourceFiles::SourceFiles(std::span<const SourcePtr> copies) : copies_(std::in_place) {
  for (const SourcePtr& copy : copies) copies_->emplace(copy->name(), copy);
}

std::string SourceFiles::place(const std::string& path) const {
  const bool is_list = !assertions_.empty() && path.starts_with(kAssertionsPrefix);
  const std::string& folder = is_list ? assertions_ : library_;
  const std::string_view prefix = is_list ? kAssertionsPrefix : kLibraryPrefix;
  if (folder.empty() || !path.starts_with(prefix)) return path;
  const std::string below = path.substr(prefix.size());
  return stays_below(below) ? (fs::path(folder) / below).string() : path;
}

std::string SourceFiles::installed_folder() const {
  return library_.empty() ? std::string() : (fs::path(library_).parent_path() / "").string();
}

SourcePtr SourceFiles::find_copy(const std::string& path) const {
  const bool is_absolute = fs::path(path).is_absolute();
  for (std::size_t begin = 0; begin != std::string::npos;) {
    const auto copy = copies_->find(path.substr(begin));
    if (copy != copies_->end()) return copy->second;
    const std::size_t slash = is_absolute ? path.find('/', begin) : std::string::npos;
    begin = slash == std::string::npos ? slash : slash + 1;
  }
  return nullptr;
}

AllowedFolders SourceFiles::readable_from(const std::string& folder) const {
  AllowedFolders readable = readable_;
  const std::string own = folder.empty() ? folder : place(folder + '/');
  readable.add(own);
  if (const auto project = find_project_folder(own)) readable.add(*project);
  if (const auto tested = tested_folder(own)) readable.add(*tested);
  if (const auto collection = collection_of(own)) readable.add(*collection);
  if (!library_.empty()) readable.add(library_);
  return readable;
}

bool SourceFiles::has(const std::string& path) const {
  if (copies_) return find_copy(path) != nullptr;
  std::error_code error;
  return fs::is_regular_file(place(path), error);
}

Result<SourcePtr> SourceFiles::read(const std::string& path, std::size_t max_bytes) const {
  if (!copies_) {
    const std::string file = place(path);
    Result<SourcePtr> source = read_source(file, max_bytes);
    if (!source || file == path) return source;
    return std::make_shared<const Source>(path, std::string(source.value()->text()));
  }
  if (SourcePtr copy = find_copy(path)) return copy;
  Diagnostics diagnostics;
  diagnostics.error(path, "no copy of this file was kept");
  return diagnostics;
}

std::optional<std::string> SourceFiles::find_installed(std::string_view path) const {
  if (!stays_below(path)) return std::nullopt;
  if (copies_) {
    for (const auto& [name, copy] : *copies_) {
      const std::size_t world = name.find('/', kLibraryPrefix.size());
      if (name.starts_with(kLibraryPrefix) && world != std::string::npos &&
          std::string_view(name).substr(world + 1) == path) {
        return name;
      }
    }
    return std::nullopt;
  }
  if (library_.empty()) return std::nullopt;
  for (const fs::directory_entry& world : entries_of(library_)) {
    const std::string name = std::string(kLibraryPrefix) +
                             (world.path().filename() / path).lexically_normal().generic_string();
    if (has(name)) return name;
  }
  return std::nullopt;
}

std::vector<std::string> SourceFiles::installed_in(std::string_view folder) const {
  std::vector<std::string> names;
  if (copies_ || library_.empty()) return names;
  for (const fs::directory_entry& entry : entries_of(place(std::string(folder)))) {
    if (entry.path().extension() != ".asl") continue;
    names.push_back(std::string(folder) + '/' + entry.path().filename().generic_string());
  }
  return names;
}

std::optional<std::string> find_project_folder(const std::string& folder) {
  std::error_code error;
  fs::path above = absolute_folder(folder);
  for (int i = 0; i < kHighest && !error; ++i, above = above.parent_path()) {
    for (fs::directory_iterator entry(above, error), end; !error && entry != end;
         entry.increment(error)) {
      const fs::path extension = entry->path().extension();
      if (extension == ".mas2j" || extension == ".jcm") return above.string();
    }
  }
  return std::nullopt;
}

}  // namespace jaywalk
