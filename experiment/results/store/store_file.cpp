// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/store_file.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "experiment/results/store/geopackage.h"
#include "experiment/scenario/files/temporary.h"

namespace jaywalk {
namespace {

// Fields in the header of a SQLite file (https://sqlite.org/fileformat2.html#the_database_header).
constexpr std::size_t kHeaderBytes = 100;
constexpr std::string_view kMagic{"SQLite format 3\0", 16};
constexpr std::size_t kPageSizeAt = 16;
constexpr std::size_t kChangesAt = 24;
constexpr std::size_t kPagesAt = 28;
constexpr std::size_t kApplicationIdAt = 68;
constexpr std::size_t kPagesValidForAt = 92;

using Header = std::array<unsigned char, kHeaderBytes>;

std::uint32_t number_at(const Header& header, std::size_t at) {
  return (std::uint32_t{header[at]} << 24U) | (std::uint32_t{header[at + 1]} << 16U) |
         (std::uint32_t{header[at + 2]} << 8U) | header[at + 3];
}

std::uint64_t page_size(const Header& header) {
  const std::uint32_t size = number_at(header, kPageSizeAt) >> 16U;
  return size == 1 ? 65536 : size;
}

/// A message about missing bytes; nothing if the file is as long as its header says, or a log
/// beside it may have the rest.
std::optional<std::string> cut_off(const std::string& path, const Header& header) {
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(path, error);
  const std::uint64_t log = std::filesystem::file_size(path + "-wal", error);
  if (!error && log > 0) return std::nullopt;
  if (number_at(header, kChangesAt) != number_at(header, kPagesValidForAt)) return std::nullopt;
  const std::uint64_t wanted = page_size(header) * number_at(header, kPagesAt);
  if (bytes >= wanted) return std::nullopt;
  return fmt::format("it is cut off: {} of {} bytes are there", bytes, wanted);
}

/// Why a file cannot be a store, by its first bytes: it is no SQLite file, no GeoPackage, cut off;
/// nothing if it can.
std::optional<std::string> why_no_store_file(const std::string& path, std::string_view kind) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return "no such file";
  if (std::filesystem::is_directory(status))
    return fmt::format("this is a folder, a {} was expected", kind);
  if (!std::filesystem::is_regular_file(status)) return "this is no regular file";
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return fmt::format("cannot be read: {}", std::strerror(errno));
  Header header{};
  file.read(reinterpret_cast<char*>(header.data()), kHeaderBytes);
  const bool whole = file.gcount() == static_cast<std::streamsize>(kHeaderBytes);
  if (!whole || std::memcmp(header.data(), kMagic.data(), kMagic.size()) != 0) {
    return fmt::format("not a {}: it is no SQLite file", kind);
  }
  if (number_at(header, kApplicationIdAt) != kGeoPackageId) {
    return fmt::format("not a {}: a SQLite file, but no GeoPackage", kind);
  }
  return cut_off(path, header);
}

/// Why not all of its pages are sound.
std::optional<std::string> damage(Database& database, Scrutiny scrutiny) {
  if (scrutiny == Scrutiny::header) return std::nullopt;
  const auto found = database.text("PRAGMA quick_check(1)");
  if (database.failure() || found == "ok") return std::nullopt;
  return fmt::format("the store is damaged: {}", found.value_or("it cannot be checked"));
}

/// Lets SQLite undo the unfinished transaction of a killed process, if the file is a store.
void undo_interrupted(const std::string& path, const StoreKind& kind) {
  Database untouched(path, Database::Mode::untouched);
  if (objection(untouched, kind) || untouched.failure()) return;
  Database database(path, Database::Mode::write);
  (void)database.number("SELECT count(*) FROM versions");
}

std::unique_ptr<Database> readable(const std::string& path, const StoreKind& kind) {
  auto database = std::make_unique<Database>(path, Database::Mode::read);
  (void)database->number("SELECT count(*) FROM sqlite_master");
  if (database->trouble() != DatabaseTrouble::interrupted) return database;
  database.reset();
  undo_interrupted(path, kind);
  return std::make_unique<Database>(path, Database::Mode::read);
}

Diagnostics taken(const std::string& path) {
  return store_error(path, "the file exists", "choose another name, or remove it first");
}

}  // namespace

Diagnostics store_error(const std::string& path, std::string message, std::string hint) {
  Diagnostics diagnostics;
  diagnostics.error(path, std::move(message), std::move(hint));
  return diagnostics;
}

std::string trouble_with(const Database& database) {
  switch (database.trouble()) {
    case DatabaseTrouble::in_use:
      return "another process is writing the store";
    case DatabaseTrouble::damaged:
      return fmt::format("the store is damaged: {}", *database.failure());
    case DatabaseTrouble::no_space:
      return "no space is left for the store";
    case DatabaseTrouble::interrupted:
      return "a process was killed while it wrote the file, and what it wrote cannot be undone";
    case DatabaseTrouble::read_only:
      return "the store can only be read: its file or its folder is write-protected";
    case DatabaseTrouble::other:
    case DatabaseTrouble::none:
      break;
  }
  return database.failure().value_or("unknown failure");
}

bool is_store(const std::string& path, const StoreKind& kind) {
  if (why_no_store_file(path, kind.name)) return false;
  Database database(path, Database::Mode::untouched);
  return is_store(database, kind);
}

Result<std::unique_ptr<Database>> open_to_read(const std::string& path, const StoreKind& kind,
                                               Scrutiny scrutiny) {
  if (auto why = why_no_store_file(path, kind.name)) return store_error(path, std::move(*why));
  auto database = readable(path, kind);
  auto why = objection(*database, kind);
  if (!why && !database->failure()) why = damage(*database, scrutiny);
  if (database->failure()) return store_error(path, trouble_with(*database));
  if (why) return store_error(path, std::move(*why));
  return database;
}

Result<std::unique_ptr<Database>> open_to_write(const std::string& path, const StoreKind& kind) {
  if (auto sound = open_to_read(path, kind, Scrutiny::all); !sound) {
    return std::move(sound.diagnostics());
  }
  auto database = std::make_unique<Database>(path, Database::Mode::write);
  // Kept from the first transaction on, until it is closed.
  database->execute("PRAGMA locking_mode = EXCLUSIVE");
  database->execute("BEGIN EXCLUSIVE; COMMIT");
  if (database->failure()) return store_error(path, trouble_with(*database));
  return database;
}

void start_log(Database& database) {
  database.execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
}

std::optional<std::string> finish_log(Database& database, const std::string& path) {
  database.execute("PRAGMA journal_mode = DELETE");
  if (database.failure()) return trouble_with(database);
  // A reader of a store that was killed left it; no other process has the store open now.
  std::error_code error;
  std::filesystem::remove(path + "-shm", error);
  return std::nullopt;
}

std::optional<Diagnostics> create_store_file(const std::string& path,
                                             const std::function<void(Database& database)>& fill) {
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(path, error))) {
    return taken(path);
  }
  PartFile part(path);
  std::optional<std::string> failure;
  if (!part.is_open()) {
    failure = std::generic_category().message(errno);
    return store_error(path, fmt::format("cannot be written: {}", *failure));
  }
  {
    Database database(part.descriptor());
    // Larger pages than SQLite's own make rows of this size cheaper to write.
    database.execute("PRAGMA page_size = 16384");
    database.execute("BEGIN");
    fill(database);
    database.execute("COMMIT");
    if (database.failure()) failure = trouble_with(database);
  }
  if (!failure && !part.put_new()) {
    // Another process may have put its file there while this one was filled.
    if (errno == EEXIST) return taken(path);
    failure = std::generic_category().message(errno);
  }
  if (!failure) return std::nullopt;
  return store_error(path, fmt::format("cannot be written: {}", *failure));
}

}  // namespace jaywalk
