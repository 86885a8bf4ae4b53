// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/descriptor_vfs.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <sqlite3.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace jaywalk {
namespace {

constexpr std::string_view kPrefix = "/proc/self/fd/";
constexpr const char* kVfsName = "jaywalk-descriptor";
constexpr int kSectorBytes = 4096;

/// The memory that SQLite allocates for an open file; it starts with SQLite's own part.
struct DescriptorFile {
  sqlite3_file base;
  int descriptor;
};

int descriptor_of(sqlite3_file* file) {
  return reinterpret_cast<DescriptorFile*>(file)->descriptor;
}

// The owner closes it.
int close_file(sqlite3_file* /*file*/) { return SQLITE_OK; }

int read_file(sqlite3_file* file, void* buffer, int size, sqlite3_int64 from) {
  auto* const bytes = static_cast<char*>(buffer);
  int done = 0;
  while (done < size) {
    const ssize_t more = ::pread(descriptor_of(file), bytes + done,
                                 static_cast<std::size_t>(size - done), from + done);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) return SQLITE_IOERR_READ;
    if (more == 0) break;
    done += static_cast<int>(more);
  }
  if (done == size) return SQLITE_OK;
  std::memset(bytes + done, 0, static_cast<std::size_t>(size - done));
  return SQLITE_IOERR_SHORT_READ;
}

int write_file_part(sqlite3_file* file, const void* buffer, int size, sqlite3_int64 at) {
  const auto* const bytes = static_cast<const char*>(buffer);
  for (int done = 0; done < size;) {
    const ssize_t more = ::pwrite(descriptor_of(file), bytes + done,
                                  static_cast<std::size_t>(size - done), at + done);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) return errno == ENOSPC ? SQLITE_FULL : SQLITE_IOERR_WRITE;
    done += static_cast<int>(more);
  }
  return SQLITE_OK;
}

int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  return ::ftruncate(descriptor_of(file), size) == 0 ? SQLITE_OK : SQLITE_IOERR_TRUNCATE;
}

int sync_file(sqlite3_file* file, int /*flags*/) {
  return ::fsync(descriptor_of(file)) == 0 ? SQLITE_OK : SQLITE_IOERR_FSYNC;
}

int size_of_file(sqlite3_file* file, sqlite3_int64* size) {
  struct stat seen {};
  if (::fstat(descriptor_of(file), &seen) != 0) return SQLITE_IOERR_FSTAT;
  *size = seen.st_size;
  return SQLITE_OK;
}

// Nobody else knows of the file.
int lock_file(sqlite3_file* /*file*/, int /*level*/) { return SQLITE_OK; }

int is_reserved(sqlite3_file* /*file*/, int* reserved) {
  *reserved = 0;
  return SQLITE_OK;
}

int control_file(sqlite3_file* /*file*/, int /*operation*/, void* /*argument*/) {
  return SQLITE_NOTFOUND;
}

int sector_size(sqlite3_file* /*file*/) { return kSectorBytes; }
int characteristics(sqlite3_file* /*file*/) { return 0; }

sqlite3_io_methods descriptor_methods() {
  sqlite3_io_methods methods{};
  methods.iVersion = 1;
  methods.xClose = close_file;
  methods.xRead = read_file;
  methods.xWrite = write_file_part;
  methods.xTruncate = truncate_file;
  methods.xSync = sync_file;
  methods.xFileSize = size_of_file;
  methods.xLock = lock_file;
  methods.xUnlock = lock_file;
  methods.xCheckReservedLock = is_reserved;
  methods.xFileControl = control_file;
  methods.xSectorSize = sector_size;
  methods.xDeviceCharacteristics = characteristics;
  return methods;
}

sqlite3_vfs* usual_vfs() { return sqlite3_vfs_find(nullptr); }

bool is_descriptor(const char* name) {
  return name != nullptr && std::string_view(name).starts_with(kPrefix);
}

int open_file(sqlite3_vfs* /*vfs*/, const char* name, sqlite3_file* file, int flags,
              int* out_flags) {
  if (!is_descriptor(name)) return usual_vfs()->xOpen(usual_vfs(), name, file, flags, out_flags);
  static const sqlite3_io_methods methods = descriptor_methods();
  const std::string_view number = std::string_view(name).substr(kPrefix.size());
  auto* const opened = reinterpret_cast<DescriptorFile*>(file);
  const auto parsed =
      std::from_chars(number.data(), number.data() + number.size(), opened->descriptor);
  const bool is_number = parsed.ec == std::errc() && parsed.ptr == number.data() + number.size();
  file->pMethods = is_number ? &methods : nullptr;
  if (!is_number) return SQLITE_CANTOPEN;  // its journal, say
  if (out_flags != nullptr) *out_flags = flags;
  return SQLITE_OK;
}

/// Such a name stays as it is: a link to be followed would lead nowhere.
int full_path(sqlite3_vfs* /*vfs*/, const char* name, int size, char* out) {
  if (!is_descriptor(name)) return usual_vfs()->xFullPathname(usual_vfs(), name, size, out);
  sqlite3_snprintf(size, out, "%s", name);
  return SQLITE_OK;
}

}  // namespace

std::string descriptor_name(int descriptor) {
  return std::string(kPrefix) + std::to_string(descriptor);
}

const char* descriptor_vfs() {
  static const bool registered = [] {
    static sqlite3_vfs vfs;
    if (usual_vfs() == nullptr) return false;
    vfs = *usual_vfs();
    vfs.szOsFile = std::max(vfs.szOsFile, static_cast<int>(sizeof(DescriptorFile)));
    vfs.pNext = nullptr;
    vfs.zName = kVfsName;
    vfs.xOpen = open_file;
    vfs.xFullPathname = full_path;
    return sqlite3_vfs_register(&vfs, 0) == SQLITE_OK;
  }();
  return registered ? kVfsName : nullptr;
}

}  // namespace jaywalk
