// SPDX-License-Identifier: Apache-2.0
#pragma once

// Folders in which programs may read or write files. Paths of programs are resolved like the system
// does: links are followed first, so that one that leads out of the folders counts as outside.
// Devices, pipes, sockets and files of the system (/proc, /sys) are never allowed.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace jaywalk {

/// Why a program may not touch something, and what to do about it (empty: nothing).
struct Denial {
  std::string message;
  std::string hint;

  /// Both in one line.
  [[nodiscard]] std::string text() const;
};

class AllowedFolders {
 public:
  /// None yet; `option` is what allows more of them, as hints name it.
  explicit AllowedFolders(std::string option = "--allow-read") : option_(std::move(option)) {}

  /// From now on, what lies in the folder and below; empty: the working folder. A folder that does
  /// not exist adds nothing.
  void add(const std::string& folder);
  void add(const AllowedFolders& others);
  /// Why a file or folder, which need not exist, may not be touched; nothing if it may.
  [[nodiscard]] std::optional<Denial> denial(const std::string& path) const;

 private:
  std::string option_;
  std::vector<std::filesystem::path> folders_;  // canonical
};

}  // namespace jaywalk
