// SPDX-License-Identifier: Apache-2.0
#include "experiment/scenario/files/temporary.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <random>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace jaywalk {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".part";
constexpr std::size_t kRandomLetters = 6;
/// Names at random that are tried before it is given up: one that exists is rare.
constexpr int kMostNames = 100;
constexpr mode_t kUsualRights = 0666;

/// The rights that programs give their new files, of which the user's mask takes some away.
mode_t masked_rights() {
  const mode_t mask = ::umask(S_IRWXG | S_IRWXO);
  ::umask(mask);
  return kUsualRights & ~mask;
}

std::string folder_of_file(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string link_of(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// A file without a name that can be given one; negative if there is none to be had.
int open_nameless(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, kUsualRights);
  if (file < 0 || ::access(link_of(file).c_str(), F_OK) == 0) return file;
  ::close(file);  // it is by /proc that it gets its name
  return -1;
}

std::string random_letters() {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> index(0, kLetters.size() - 1);
  std::string letters;
  for (std::size_t i = 0; i < kRandomLetters; ++i) letters += kLetters[index(random)];
  return letters;
}

/// Whether it is `NAME.XXXXXX.part`.
bool is_part_of(std::string_view file, std::string_view name) {
  if (file.size() != name.size() + 1 + kRandomLetters + kEnding.size()) return false;
  if (!file.starts_with(name) || !file.ends_with(kEnding) || file[name.size()] != '.') return false;
  return std::ranges::all_of(file.substr(name.size() + 1, kRandomLetters), [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0;
  });
}

/// Removes unfinished parts of a file that killed processes left; a process that is writing one
/// holds a lock on it.
void remove_abandoned(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  std::error_code error;
  for (fs::directory_iterator entry(folder_of_file(path), error), end; !error && entry != end;
       entry.increment(error)) {
    if (!is_part_of(entry->path().filename().string(), name)) continue;
    const int file = ::open(entry->path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(entry->path().c_str());
    ::close(file);
  }
}

}  // namespace

PartFile::PartFile(std::string path, Naming naming) : path_(std::move(path)) {
  if (path_.find('\0') != std::string::npos) {  // the system would read the path up to there
    errno = EINVAL;
    return;
  }
  if (naming == Naming::unnamed_if_possible) descriptor_ = open_nameless(folder_of_file(path_));
  if (descriptor_ < 0) open_named();
  if (descriptor_ >= 0 && !is_named_) name_ = link_of(descriptor_);
}

PartFile::~PartFile() {
  const int why = errno;
  if (is_named_) ::unlink(name_.c_str());
  if (descriptor_ >= 0) ::close(descriptor_);
  errno = why;
}

void PartFile::open_named() {
  static const mode_t rights = masked_rights();  // asked once: asking changes it for a moment
  remove_abandoned(path_);
  std::string name = path_ + ".XXXXXX" + std::string(kEnding);
  const int file = ::mkostemps(name.data(), static_cast<int>(kEnding.size()), O_CLOEXEC);
  if (file < 0) return;
  struct stat seen {};
  // Another process may have taken it for abandoned before it was locked.
  const bool made = ::fchmod(file, rights) == 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0 &&
                    ::fstat(file, &seen) == 0;
  if (made && seen.st_nlink > 0) {
    descriptor_ = file;
    name_ = name;
    is_named_ = true;
    return;
  }
  const int why = made ? EAGAIN : errno;
  ::close(file);
  if (!made) ::unlink(name.c_str());
  errno = why;
}

bool PartFile::link_to(const std::string& path) const {
  return ::linkat(AT_FDCWD, name_.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

bool PartFile::put_new() {
  // A link, unlike a renamed file, takes no other file's place.
  return link_to(path_);
}

bool PartFile::replace() {
  if (!is_named_) {
    if (link_to(path_)) return true;
    // Only a file with a name can replace another one, so give it one for a moment.
    for (int i = 0; i < kMostNames && errno == EEXIST && !is_named_; ++i) {
      const std::string name = path_ + "." + random_letters() + std::string(kEnding);
      is_named_ = link_to(name);
      if (is_named_) name_ = name;
    }
  }
  if (!is_named_ || std::rename(name_.c_str(), path_.c_str()) != 0) return false;
  is_named_ = false;
  return true;
}

int open_unnamed() {
  std::error_code error;
  const fs::path folder = fs::temp_directory_path(error);
  if (error) return -1;
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (file >= 0) return file;
  std::string name = (folder / "jaywalk-XXXXXX").string();
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "jaywalk-XXXXXX").string();
  if (!error && ::mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace jaywalk
