#pragma once

// Where the texts of files are read from: the disk, or copies that were kept of them, so that what
// was once read can be read again wherever the files are now.

#include <map>
#include <optional>
#include <span>
#include <string>

#include "interpreter/support/diagnostics.h"

namespace jaywalk {

class SourceFiles {
 public:
  /// The disk.
  SourceFiles() = default;
  /// These, by their names, and no others.
  explicit SourceFiles(std::span<const SourcePtr> copies);

  /// There is a file (not a folder) of this name.
  [[nodiscard]] bool has(const std::string& path) const;
  /// As read_source() does; a missing copy is an error, too.
  [[nodiscard]] Result<SourcePtr> read(const std::string& path,
                                       std::size_t max_bytes = std::size_t{64} << 20U) const;

 private:
  std::optional<std::map<std::string, SourcePtr>> copies_;
};

}  // namespace jaywalk
