// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/options/shipped.h"

#include <filesystem>
#include <sys/auxv.h>
#include <system_error>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kAssertions = "scenarios/assertions";

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

std::string shipped_folder() { return data_folder().string(); }

SourceFiles files_on_disk() {
  const fs::path data = data_folder();
  return SourceFiles((data / "agents").string(), (data / kAssertions).string());
}

std::string portable_assertions(const std::string& path) {
  const fs::path folder = data_folder() / kAssertions;
  const fs::path below = fs::path(path).lexically_relative(folder);
  if (folder.is_relative() || below.empty() || *below.begin() == "..") return path;
  return std::string(kAssertionsPrefix) + below.generic_string();
}

}  // namespace jaywalk
