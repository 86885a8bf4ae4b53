// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/input/missing_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 10'000;

// In an order that does not depend on the file system; none if they cannot be had.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
       at.increment(error)) {
    if (entries.size() == kMostEntries) return {};
    entries.push_back(at->path().filename());
  }
  if (error) return {};
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path.empty() ? "." : path, error);
}

/// The folder beside a missing one whose name is most like its.
std::optional<fs::path> like_folder(const fs::path& missing) {
  std::vector<std::string> names;
  for (const fs::path& entry : entries_of(missing.parent_path())) {
    if (is_folder(missing.parent_path() / entry)) names.push_back(entry.string());
  }
  const std::optional<std::string> like = closest(missing.filename().string(), names);
  if (!like) return std::nullopt;
  return missing.parent_path() / *like;
}

std::optional<fs::path> like_file(const fs::path& missing) {
  const fs::path folder = missing.parent_path();
  if (!is_folder(folder)) {
    const std::optional<fs::path> like = like_folder(folder);
    if (!like) return std::nullopt;
    return is_file(*like / missing.filename()) ? *like / missing.filename()
                                               : like_file(*like / missing.filename());
  }
  std::vector<std::string> names;
  for (const fs::path& entry : entries_of(folder)) {
    const fs::path below = folder / entry / missing.filename();
    if (is_file(below)) return below;
    if (!is_file(folder / entry)) continue;
    if (!missing.has_extension() && entry.stem() == missing.filename()) return folder / entry;
    // Endings are left out of the comparison: what ".asl" has in common says nothing.
    if (entry.extension() == missing.extension()) names.push_back(entry.stem().string());
  }
  const std::optional<std::string> like = closest(missing.stem().string(), names);
  if (!like) return std::nullopt;
  return folder / (*like + missing.extension().string());
}

}  // namespace

std::string hint_for_missing(const std::string& path, const std::string& root) {
  const fs::path missing(path);
  if (!missing.has_filename()) return {};
  std::optional<fs::path> like = like_file(missing);
  if (!like && !root.empty() && missing.is_relative()) {
    like = like_file(root / missing);
    if (like) like = like->lexically_relative(root);
  }
  return like ? fmt::format("did you mean '{}'?", like->string()) : std::string();
}

}  // namespace jaywalk
