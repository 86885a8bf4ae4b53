// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads texts from the disk, or from copies that were kept of files, so that they can be read again
// wherever the files are now. Programs and lists of assertions that are installed with Jaywalk have
// names of their own, `$jaywalk/crossing/proximity.asl` and `$jaywalk/assertions/crossing.yaml`,
// which are the same wherever it is installed; copies of them have these names, too.

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/allowed_folders.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// How the names of installed programs begin; a folder for each world follows.
inline constexpr std::string_view kLibraryPrefix = "$jaywalk/";
inline constexpr std::string_view kAssertionsPrefix = "$jaywalk/assertions/";

class SourceFiles {
 public:
  /// The disk, without installed programs.
  SourceFiles() = default;
  /// The disk; the installed programs are in the folder `library`, lists of assertions in another.
  explicit SourceFiles(std::string library, std::string assertions = {})
      : library_(std::move(library)), assertions_(std::move(assertions)) {}
  /// Only these copies, by their names.
  explicit SourceFiles(std::span<const SourcePtr> copies);

  /// Allows programs to read this folder, besides their own (`--allow-read`).
  void allow_reading(const std::string& folder) { readable_.add(folder); }
  /// The folders that a program in `folder` may read: that folder, the project that it belongs to,
  /// a folder `agents` that it lies in, the installed programs and those of allow_reading().
  [[nodiscard]] AllowedFolders readable_from(const std::string& folder) const;
  /// Whether that matters: copies may always be read.
  [[nodiscard]] bool are_on_disk() const { return !copies_; }

  /// There is a file (not a folder) of this name.
  [[nodiscard]] bool has(const std::string& path) const;
  /// As read_source() does; a missing copy is an error, too.
  [[nodiscard]] Result<SourcePtr> read(const std::string& path,
                                       std::size_t max_bytes = std::size_t{64} << 20U) const;
  /// The file on the disk that a name means. REQUIRES: there are no copies.
  [[nodiscard]] std::string place(const std::string& path) const;
  /// The folder of all that is installed with Jaywalk, with a slash at its end; empty: there is
  /// none.
  [[nodiscard]] std::string installed_folder() const;

  /// The name of the installed program of that path below the folder of some world:
  /// `$jaywalk/crossing/shared/steps.asl` for `shared/steps.asl`.
  [[nodiscard]] std::optional<std::string> find_installed(std::string_view path) const;
  /// The names of the programs in a folder of the installed ones, `$jaywalk/crossing`, sorted.
  [[nodiscard]] std::vector<std::string> installed_in(std::string_view folder) const;

 private:
  /// The copy of that name. An absolute path, as a text may have it, means the copy whose name it
  /// ends with (PortableNames). Null: there is none.
  [[nodiscard]] SourcePtr find_copy(const std::string& path) const;

  std::optional<std::map<std::string, SourcePtr>> copies_;
  std::string library_;     // empty: none
  std::string assertions_;  // empty: none
  AllowedFolders readable_;
};

/// The next folder from this one upwards in which a project lies, of Jason or JaCaMo.
[[nodiscard]] std::optional<std::string> find_project_folder(const std::string& folder);

}  // namespace jaywalk
