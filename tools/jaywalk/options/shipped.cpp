#include "tools/jaywalk/options/shipped.h"

#include <filesystem>
#include <sys/auxv.h>
#include <system_error>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

/// The data's folder is found from the command's own, so that both may be moved together; where
/// that is unknown it is the one that was configured.
fs::path data_folder() {
  std::error_code error;
  fs::path command = fs::read_symlink("/proc/self/exe", error);
  if (error) {  // without /proc, the path by which the command was started
    command = fs::canonical(reinterpret_cast<const char*>(::getauxval(AT_EXECFN)), error);
  }
  if (error) return JAYWALK_DATA;
  return (command.parent_path() / JAYWALK_DATA_FROM_BIN).lexically_normal();
}

}  // namespace

std::string located(const std::string& path) {
  std::error_code error;
  if (fs::path(path).is_absolute() || fs::exists(path, error)) return path;
  const fs::path shipped = (data_folder() / path).lexically_normal();
  return fs::exists(shipped, error) ? shipped.string() : path;
}

SourceFiles files_on_disk() { return SourceFiles((data_folder() / "agents").string()); }

}  // namespace jaywalk
