// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/allowed_folders.h"

#include <algorithm>
#include <linux/magic.h>
#include <sys/statfs.h>
#include <system_error>

#include <fmt/format.h>

#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// Without links, as far as it exists; empty if that cannot be determined.
fs::path without_links(const std::string& path) {
  // The system's own calls would read such a name only up to there.
  if (path.find('\0') != std::string::npos) return {};
  std::error_code error;
  const fs::path absolute = fs::absolute(path.empty() ? "." : path, error);
  if (error) return {};
  const fs::path found = fs::weakly_canonical(absolute, error);
  return error ? fs::path() : found;
}

bool lies_in(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Whether the system makes it up (/proc, /sys), wherever it is mounted.
bool is_made_up(const fs::path& path) {
  struct statfs system {};
  if (::statfs(path.c_str(), &system) != 0) return false;
  return system.f_type == PROC_SUPER_MAGIC || system.f_type == SYSFS_MAGIC;
}

bool is_plain(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return !is_made_up(path.parent_path());
  return (fs::is_regular_file(status) || fs::is_directory(status)) && !is_made_up(path);
}

fs::path folder_of(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return path;
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// The option with the folder that would do, as it was written unless links lead elsewhere: `found`
/// is the path without them.
std::string granting(const std::string& option, const std::string& path, const fs::path& found) {
  std::error_code ignored;
  fs::path folder = folder_of(found);
  const bool exists = fs::is_directory(folder, ignored);
  const fs::path written = folder_of(path);
  if (without_links(written.string()) == folder) folder = written;
  return fmt::format("{} {} allows it{}", option, shell_quoted(folder.string()),
                     exists ? "" : ", once there is such a folder");
}

}  // namespace

std::string Denial::text() const {
  return hint.empty() ? message : fmt::format("{} ({})", message, hint);
}

void AllowedFolders::add(const std::string& folder) {
  std::error_code error;
  const fs::path found = without_links(folder);
  if (!found.empty() && fs::is_directory(found, error)) folders_.push_back(found);
}

void AllowedFolders::add(const AllowedFolders& others) {
  folders_.insert(folders_.end(), others.folders_.begin(), others.folders_.end());
}

std::optional<Denial> AllowedFolders::denial(const std::string& path) const {
  const fs::path found = without_links(path);
  if (found.empty()) return Denial{"it is no path that can be followed", {}};
  const bool inside =
      std::ranges::any_of(folders_, [&](const fs::path& each) { return lies_in(found, each); });
  if (!is_plain(found)) {
    return Denial{"it is a device, a pipe or the system's own, not a plain file", {}};
  }
  if (inside) return std::nullopt;
  return Denial{"it lies outside the folders that the program may use",
                granting(option_, path, found)};
}

}  // namespace jaywalk
