#include "experiment/export/temporary.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace jaywalk {
namespace {

/// The rights that programs give their new files, of which the user's mask takes some away.
mode_t usual_rights() {
  constexpr mode_t kAll = 0666;
  const mode_t mask = ::umask(S_IRWXG | S_IRWXO);
  ::umask(mask);
  return kAll & ~mask;
}

}  // namespace

std::string make_part_of(const std::string& path) {
  constexpr std::string_view kEnding = ".part";
  std::string name = path + ".XXXXXX" + std::string(kEnding);
  const int file = ::mkostemps(name.data(), static_cast<int>(kEnding.size()), O_CLOEXEC);
  if (file < 0) return {};
  static const mode_t rights = usual_rights();  // asked once: asking changes it for a moment
  const bool made = ::fchmod(file, rights) == 0;
  const int why = errno;
  ::close(file);
  if (made) return name;
  ::unlink(name.c_str());
  errno = why;
  return {};
}

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "jaywalk-XXXXXX").string();
  if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace jaywalk
