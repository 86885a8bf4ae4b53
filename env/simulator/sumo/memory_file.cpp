#include "env/simulator/sumo/memory_file.h"

#include <algorithm>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace jaywalk {

MemoryFile::MemoryFile() : descriptor_(memfd_create("jaywalk", MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::string MemoryFile::path() const {
  return fmt::format("/proc/{}/fd/{}", getpid(), descriptor_);
}

bool MemoryFile::write(std::string_view text) {
  // Children that write to it share its place.
  if (ftruncate(descriptor_, 0) != 0 || lseek(descriptor_, 0, SEEK_SET) != 0) return false;
  off_t place = 0;
  while (!text.empty()) {
    const ssize_t written = pwrite(descriptor_, text.data(), text.size(), place);
    if (written <= 0) return false;
    place += written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

std::string MemoryFile::read(std::size_t most) const {
  struct stat about {};
  if (fstat(descriptor_, &about) != 0) return {};
  const auto size = static_cast<std::size_t>(about.st_size);
  std::string text(std::min(size, most), '\0');
  const ssize_t count =
      pread(descriptor_, text.data(), text.size(), static_cast<off_t>(size - text.size()));
  text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
  return text;
}

}  // namespace jaywalk
