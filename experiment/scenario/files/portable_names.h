// SPDX-License-Identifier: Apache-2.0
#pragma once

// The names of files as stores and pages keep them. Absolute paths are shortened to the part that
// does not depend on the machine, so that they do not reveal its folders, and the same files have
// the same names wherever they lie.

#include <string>
#include <vector>

#include "interpreter/support/source_files.h"

namespace jaywalk {

class PortableNames {
 public:
  /// Shortens nothing.
  PortableNames() = default;
  /// `names`: all that belong together. Relative paths stay as they are. A path of an installed
  /// file
  /// (`files`) begins at the folder of the installation, another absolute path below the folder
  /// that it shares with the other names which begin with the same two folders. So relative paths
  /// still lead from one file to another.
  PortableNames(const std::vector<std::string>& names, const SourceFiles& files);

  /// A name, or a text with such names in it (`policy=["/home/me/learned.json"]`).
  [[nodiscard]] std::string in(std::string text) const;

 private:
  /// The folders that are left out, each with a slash at its end.
  std::vector<std::string> roots_;
};

/// A path for a title; an absolute path is shortened to the file's name.
[[nodiscard]] std::string portable_path(const std::string& path);

}  // namespace jaywalk
