#pragma once

// Files and folders for as long as something is made. Nobody can foresee their names, and nothing
// that is there already is opened, so that no link put in their place leads elsewhere.

#include <string>

namespace jaywalk {

/// Makes an empty file beside `path`, `path.XXXXXX.part`, with the rights of any new file. Its
/// name; empty if it cannot be made, and `errno` says why.
[[nodiscard]] std::string make_part_of(const std::string& path);

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
