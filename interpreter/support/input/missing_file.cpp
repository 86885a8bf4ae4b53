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

}  // namespace

std::string hint_for_missing(const std::string& path) {
  const fs::path missing(path);
  const fs::path folder = missing.parent_path();
  if (!missing.has_filename()) return {};
  std::vector<std::string> names;
  for (const fs::path& entry : entries_of(folder)) {
    const fs::path below = folder / entry / missing.filename();
    if (is_file(below)) return fmt::format("did you mean '{}'?", below.string());
    // Endings are left out of the comparison: what ".asl" has in common says nothing.
    const bool is_of_kind = entry.extension() == missing.extension();
    if (is_of_kind && is_file(folder / entry)) names.push_back(entry.stem().string());
  }
  const std::optional<std::string> like = closest(missing.stem().string(), names);
  if (!like) return {};
  const std::string file = (folder / (*like + missing.extension().string())).string();
  return fmt::format("did you mean '{}'?", file);
}

}  // namespace jaywalk
