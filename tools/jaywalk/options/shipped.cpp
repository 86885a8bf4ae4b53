#include "tools/jaywalk/options/shipped.h"

#include <filesystem>
#include <system_error>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// The data's folder is found from the command's own, so that both may be moved together. Empty if
/// that is unknown.
fs::path data_folder() {
  std::error_code error;
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  return (command.parent_path() / JAYWALK_DATA_FROM_BIN).lexically_normal();
}

}  // namespace

std::string located(const std::string& path) {
  std::error_code error;
  if (fs::path(path).is_absolute() || fs::exists(path, error)) return path;
  const fs::path data = data_folder();
  const fs::path shipped = (data / path).lexically_normal();
  return !data.empty() && fs::exists(shipped, error) ? shipped.string() : path;
}

SourceFiles files_on_disk() {
  const fs::path data = data_folder();
  return data.empty() ? SourceFiles() : SourceFiles((data / "agents").string());
}

}  // namespace jaywalk
