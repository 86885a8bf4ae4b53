// SPDX-License-Identifier: Apache-2.0
// Loaded before a program starts (LD_PRELOAD), it disturbs the N-th write to a database: N is in
// JAYWALK_WRITE. JAYWALK_THEN says how: KILL, TERM or HUP, a signal before it is written, or FULL,
// a disk without room from then on. JAYWALK_WRITES names a file for how many writes there were.
// Standard streams and pages are written by other functions, which are left alone.

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <unistd.h>

namespace {

std::atomic<long> writes = 0;

const char* setting(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// False if there is no room left.
bool goes_on() {
  const long number = ++writes;
  const long disturbed = std::atol(setting("JAYWALK_WRITE"));
  const char* const then = setting("JAYWALK_THEN");
  if (std::strcmp(then, "FULL") == 0) return number < disturbed;
  if (number != disturbed) return true;
  kill(getpid(), std::strcmp(then, "TERM") == 0  ? SIGTERM
                 : std::strcmp(then, "HUP") == 0 ? SIGHUP
                                                 : SIGKILL);
  return true;
}

template <class Function, class... Arguments>
auto next(const char* name, Arguments... arguments) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name))(arguments...);
}

ssize_t written(const char* name, int file, const void* bytes, size_t size, off_t at) {
  if (goes_on()) return next<ssize_t(int, const void*, size_t, off_t)>(name, file, bytes, size, at);
  errno = ENOSPC;
  return -1;
}

[[gnu::destructor]] void tell() {
  std::FILE* const file = std::fopen(setting("JAYWALK_WRITES"), "w");
  if (file == nullptr) return;
  std::fprintf(file, "%ld\n", writes.load());
  std::fclose(file);
}

}  // namespace

extern "C" {

ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  return written("pwrite", file, bytes, size, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off_t at) {
  return written("pwrite64", file, bytes, size, at);
}

// These succeed on a full disk, too.

int ftruncate(int file, off_t size) noexcept {
  goes_on();
  return next<int(int, off_t)>("ftruncate", file, size);
}

int ftruncate64(int file, off_t size) noexcept {
  goes_on();
  return next<int(int, off_t)>("ftruncate64", file, size);
}

int unlink(const char* path) noexcept {
  goes_on();
  return next<int(const char*)>("unlink", path);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  goes_on();
  return next<int(int, const char*, int, const char*, int)>("linkat", from_folder, from, to_folder,
                                                            to, flags);
}
}
