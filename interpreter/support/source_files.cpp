#include "interpreter/support/source_files.h"

#include <filesystem>
#include <system_error>

namespace jaywalk {

SourceFiles::SourceFiles(std::span<const SourcePtr> copies) : copies_(std::in_place) {
  for (const SourcePtr& copy : copies) copies_->emplace(copy->name(), copy);
}

bool SourceFiles::has(const std::string& path) const {
  if (copies_) return copies_->contains(path);
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

Result<SourcePtr> SourceFiles::read(const std::string& path, std::size_t max_bytes) const {
  if (!copies_) return read_source(path, max_bytes);
  const auto found = copies_->find(path);
  if (found != copies_->end()) return found->second;
  Diagnostics diagnostics;
  diagnostics.error(path, "no copy of this file was kept");
  return diagnostics;
}

}  // namespace jaywalk
