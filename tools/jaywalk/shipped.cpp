#include "tools/jaywalk/shipped.h"

#include <filesystem>
#include <system_error>

namespace jaywalk {

std::string located(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::path(path).is_absolute() || fs::exists(path, error)) return path;
  // The data's folder is found from the command's own, so that both may be moved together.
  const fs::path command = fs::read_symlink("/proc/self/exe", error);
  if (error) return path;
  const fs::path shipped =
      (command.parent_path() / JAYWALK_DATA_FROM_BIN / path).lexically_normal();
  return fs::exists(shipped, error) ? shipped.string() : path;
}

}  // namespace jaywalk
