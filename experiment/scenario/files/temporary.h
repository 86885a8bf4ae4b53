// SPDX-License-Identifier: Apache-2.0
#pragma once

// Temporary files and folders. Their names cannot be predicted and no existing file is opened, so
// that an attacker's link cannot redirect the output.

#include <string>

namespace jaywalk {

/// A file that is being made and will stand at `path`. Until then it has no name, so that a
/// process that is killed leaves nothing. Where the file system cannot make such a file it is
/// called `path.XXXXXX.part`; those that a killed process has left there are removed.
class PartFile {
 public:
  enum class Naming { unnamed_if_possible, named };

  /// Empty, with the rights of any new file. is_open() says whether it could be made; if not,
  /// `errno` says why.
  explicit PartFile(std::string path, Naming naming = Naming::unnamed_if_possible);
  /// Removes the file unless replace() or put_new() succeeded.
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// A path by which this process can open it until then.
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Gives the file its final path and replaces a file that is there; `errno` says why that failed.
  [[nodiscard]] bool replace();
  /// Gives the file its final path; fails with EEXIST if there is a file already.
  [[nodiscard]] bool put_new();

 private:
  void open_named();
  [[nodiscard]] bool link_to(const std::string& path) const;

  std::string path_;
  std::string name_;
  int descriptor_ = -1;
  bool is_named_ = false;
};

/// A file without a name in the folder for temporary files: it goes when it is closed. Its
/// descriptor; negative if it cannot be made.
[[nodiscard]] int open_unnamed();

/// A folder that only we can look into; it goes with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Empty if it could not be made.
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace jaywalk
