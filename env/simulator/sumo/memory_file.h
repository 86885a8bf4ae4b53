#pragma once

// A file without a name, in memory, which SUMO reads and writes. It disappears with our process.

#include <string>
#include <string_view>

namespace jaywalk {

class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  [[nodiscard]] bool is_open() const { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// A path by which our child processes can open it.
  [[nodiscard]] std::string path() const;
  /// Replaces the content; false if there is not enough memory.
  [[nodiscard]] bool write(std::string_view text);
  /// The content, at most the last `most` bytes.
  [[nodiscard]] std::string read(std::size_t most) const;

 private:
  int descriptor_;
};

}  // namespace jaywalk
