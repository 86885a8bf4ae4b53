// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/store/database.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <sqlite3.h>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "experiment/results/store/descriptor_vfs.h"
#include "interpreter/support/markup.h"

namespace jaywalk {
namespace {

/// The trouble that an extended result code of SQLite stands for.
DatabaseTrouble trouble_of(int code) {
  switch (code & 0xFF) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return DatabaseTrouble::in_use;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return DatabaseTrouble::damaged;
    case SQLITE_FULL:
      return DatabaseTrouble::no_space;
    case SQLITE_READONLY:
      return code == SQLITE_READONLY_ROLLBACK || code == SQLITE_READONLY_RECOVERY ||
                     code == SQLITE_READONLY_CANTINIT || code == SQLITE_READONLY_CANTLOCK
                 ? DatabaseTrouble::interrupted
                 : DatabaseTrouble::read_only;
    default:
      return DatabaseTrouble::other;
  }
}

int flags_of(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::read:
    case Database::Mode::untouched:
      return SQLITE_OPEN_READONLY;
    case Database::Mode::write:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::create:
    case Database::Mode::temporary:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    case Database::Mode::memory:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_MEMORY;
  }
  return SQLITE_OPEN_READONLY;
}

}  // namespace

std::string file_uri(const std::string& path, std::string_view query) {
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(path, error).generic_string();
  return fmt::format("file:{}?{}", escaped_uri(absolute), query);
}

void Database::Close::operator()(sqlite3* connection) const { sqlite3_close(connection); }

Database::Database(const std::string& path, Mode mode) {
  const std::string uri = mode == Mode::memory ? ":memory:"
                          : mode == Mode::temporary
                              ? ""
                              : file_uri(path, mode == Mode::untouched ? "immutable=1" : "");
  open(uri, flags_of(mode), nullptr);
  if (mode == Mode::temporary) keep_no_journal();
}

Database::Database(int descriptor) {
  const char* const vfs = descriptor_vfs();
  if (vfs == nullptr) {
    fail("SQLite cannot write to an open file");
    return;
  }
  open(descriptor_name(descriptor), flags_of(Mode::write), vfs);
  keep_no_journal();
}

void Database::keep_no_journal() {
  // Which SQLite takes for an attack on a file that others have made.
  sqlite3_db_config(connection_.get(), SQLITE_DBCONFIG_DEFENSIVE, 0, nullptr);
  execute("PRAGMA journal_mode = OFF");
  sqlite3_db_config(connection_.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
}

void Database::stop_when(std::function<bool()> stopped) {
  // Some milliseconds' work.
  constexpr int kInstructions = 20'000;
  stopped_ = std::move(stopped);
  const auto ask = [](void* self) { return static_cast<Database*>(self)->stopped_() ? 1 : 0; };
  sqlite3_progress_handler(connection_.get(), kInstructions, stopped_ ? +ask : nullptr, this);
}

void Database::open(const std::string& uri, int flags, const char* vfs) {
  sqlite3* connection = nullptr;
  // Each connection is used by one thread at a time.
  const int code =
      sqlite3_open_v2(uri.c_str(), &connection, flags | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_URI, vfs);
  // SQLite gives a connection even if it could not open, which knows why and must be closed.
  connection_.reset(connection);
  if (code != SQLITE_OK) note(code);
  // Do not trust the file: its schema may not call functions, its pages are checked when read.
  sqlite3_db_config(connection, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(connection, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  execute("PRAGMA cell_size_check = ON");
}

Database::~Database() = default;

void Database::execute(const std::string& sql) {
  if (failure_) return;
  const int code = sqlite3_exec(connection_.get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) note(code);
}

std::optional<std::int64_t> Database::number(const std::string& sql) {
  Statement statement(*this, sql);
  if (!statement.step() || statement.is_null(0)) return std::nullopt;
  return statement.number(0);
}

std::optional<std::string> Database::text(const std::string& sql) {
  Statement statement(*this, sql);
  if (!statement.step() || statement.is_null(0)) return std::nullopt;
  return statement.text(0);
}

void Database::fail(std::string why) {
  if (failure_) return;
  failure_ = std::move(why);
  trouble_ = DatabaseTrouble::other;
}

void Database::note(int code) {
  if (failure_) return;
  trouble_ = trouble_of(connection_ ? sqlite3_extended_errcode(connection_.get()) : code);
  failure_ = connection_ ? sqlite3_errmsg(connection_.get()) : sqlite3_errstr(code);
  const int error = connection_ ? sqlite3_system_errno(connection_.get()) : 0;
  // "disk I/O error" says less than the system's own reason.
  const bool of_the_system = (code & 0xFF) == SQLITE_IOERR || (code & 0xFF) == SQLITE_CANTOPEN;
  if (of_the_system && error != 0) failure_ = std::strerror(error);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(Database& database, std::string_view sql) : database_(database) {
  if (database_.failure_) return;
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database_.connection_.get(), sql.data(),
                                      static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) database_.note(code);
}

bool Statement::step() {
  if (database_.failure_ || !statement_) return false;
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.note(code);
  return false;
}

void Statement::reset() {
  if (statement_) sqlite3_reset(statement_.get());
}

bool Statement::is_null(int column) const {
  return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}

std::int64_t Statement::number(int column) const {
  if (sqlite3_column_type(statement_.get(), column) != SQLITE_INTEGER) {
    damaged(column, "no whole number");
    return 0;
  }
  return sqlite3_column_int64(statement_.get(), column);
}

std::uint32_t Statement::count(int column) const {
  const std::int64_t value = number(column);
  if (value >= 0 && std::in_range<std::int32_t>(value)) return static_cast<std::uint32_t>(value);
  damaged(column, "a number out of range");
  return 0;
}

double Statement::real(int column) const {
  const double value = any_real(column);
  if (std::isfinite(value)) return value;
  damaged(column, "an infinite number");
  return 0;
}

double Statement::any_real(int column) const {
  const int type = sqlite3_column_type(statement_.get(), column);
  // SQLite stores whole numbers of a REAL column as integers where it can.
  if (type != SQLITE_FLOAT && type != SQLITE_INTEGER) {
    damaged(column, "no number");
    return 0;
  }
  return sqlite3_column_double(statement_.get(), column);
}

void Statement::damaged(int column, std::string_view has) const {
  const char* const name = sqlite3_column_name(statement_.get(), column);
  database_.fail(fmt::format("the store is damaged: its column '{}' has {}",
                             name == nullptr ? "" : name, has));
}

std::string Statement::text(int column) const {
  const void* const bytes = sqlite3_column_blob(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return bytes == nullptr ? std::string() : std::string(static_cast<const char*>(bytes), size);
}

std::string Statement::identifier(int column) const {
  std::string name = text(column);
  if (!is_identifier(name)) damaged(column, fmt::format("'{}', which is no name", name));
  return name;
}

std::string Statement::label(int column) const {
  std::string name = text(column);
  if (!name.empty() && !is_label(name))
    damaged(column, fmt::format("'{}', which is no name", name));
  return name;
}

void Statement::set(int index, std::int64_t value) {
  if (statement_) sqlite3_bind_int64(statement_.get(), index, value);
}

void Statement::set(int index, double value) {
  if (statement_) sqlite3_bind_double(statement_.get(), index, value);
}

void Statement::set(int index, std::string_view value) {
  if (!statement_) return;
  sqlite3_bind_text(statement_.get(), index, value.data(), static_cast<int>(value.size()),
                    SQLITE_STATIC);
}

void Statement::set(int index, Blob value) {
  if (!statement_) return;
  sqlite3_bind_blob(statement_.get(), index, value.bytes.data(),
                    static_cast<int>(value.bytes.size()), SQLITE_STATIC);
}

void Statement::set(int index, std::nullopt_t) {
  if (statement_) sqlite3_bind_null(statement_.get(), index);
}

}  // namespace jaywalk
