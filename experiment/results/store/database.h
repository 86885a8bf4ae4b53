// SPDX-License-Identifier: Apache-2.0
#pragma once

// SQLite as the store uses it: connections and statements that close themselves. The first failure
// is kept and every later call does nothing, so that callers check once, at the end. Only this
// folder and the store of searches (search/store) include this file.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

struct sqlite3;
struct sqlite3_stmt;

namespace jaywalk {

/// `interrupted`: what another process was writing when it was killed has to be undone first, which
/// a reader cannot do. `read_only`: the file, or its folder, cannot be written to.
enum class DatabaseTrouble { none, in_use, damaged, no_space, interrupted, read_only, other };

/// A path as a URI, `file:/a/b?mode=ro`, which says how SQLite opens it.
[[nodiscard]] std::string file_uri(const std::string& path, std::string_view query);

class Database {
 public:
  /// `untouched`: the file alone, ignoring the log and journal beside it. `memory`: a new database
  /// in memory; the path is not used. `temporary`: like `memory`, but more than a few MB go to a
  /// file without a name.
  enum class Mode { read, untouched, write, create, memory, temporary };

  /// Opens the file; failure() says whether that succeeded.
  Database(const std::string& path, Mode mode);
  /// Makes one in an empty file that is open already and stays open. Its content is valid up to the
  /// last COMMIT only.
  explicit Database(int descriptor);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Runs statements that give no rows or whose rows do not matter.
  void execute(const std::string& sql);
  /// The first column of the first row, if there is one and it is no NULL.
  [[nodiscard]] std::optional<std::int64_t> number(const std::string& sql);
  [[nodiscard]] std::optional<std::string> text(const std::string& sql);

  /// The first thing that went wrong, in words.
  [[nodiscard]] const std::optional<std::string>& failure() const { return failure_; }
  [[nodiscard]] DatabaseTrouble trouble() const { return trouble_; }
  /// From now on statements fail as soon as that is true; it is called from time to time.
  void stop_when(std::function<bool()> stopped);
  /// Takes note of a failure that SQLite did not see; the first counts.
  void fail(std::string why);

 private:
  friend class Statement;
  void keep_no_journal();
  void open(const std::string& uri, int flags, const char* vfs);
  void note(int code);

  struct Close {
    void operator()(sqlite3* connection) const;
  };
  std::unique_ptr<sqlite3, Close> connection_;
  std::function<bool()> stopped_;
  std::optional<std::string> failure_;
  DatabaseTrouble trouble_ = DatabaseTrouble::none;
};

/// Bytes that are stored as they are; must outlive the step that stores them.
struct Blob {
  std::span<const unsigned char> bytes;
};

/// A compiled statement. The database must outlive it.
class Statement {
 public:
  Statement(Database& database, std::string_view sql);

  /// Runs a statement that gives no rows, with these values. Texts must live until it returns.
  template <class... Values>
  void run(const Values&... values) {
    bind(values...);
    step();
    reset();
  }
  /// Sets the parameters in their order.
  template <class... Values>
  void bind(const Values&... values) {
    int index = 0;
    (set(++index, values), ...);
  }
  /// Goes to the next row; false if there is none, or something went wrong.
  bool step();
  /// Makes it ready to run again.
  void reset();

  // The values of a row. A file's numbers may be anything, whatever its schema says: where there is
  // none of the kind, or it is out of range, the database fails as damaged, and the value is 0.
  [[nodiscard]] bool is_null(int column) const;
  [[nodiscard]] std::int64_t number(int column) const;
  /// Finite.
  [[nodiscard]] double real(int column) const;
  /// Perhaps infinite.
  [[nodiscard]] double any_real(int column) const;
  /// A number of things or the index of one: less than 2³¹.
  [[nodiscard]] std::uint32_t count(int column) const;
  /// Any bytes.
  [[nodiscard]] std::string text(int column) const;
  /// Names (markup.h); where the column has another text the database fails as damaged.
  [[nodiscard]] std::string identifier(int column) const;
  /// Or nothing.
  [[nodiscard]] std::string label(int column) const;
  template <class T>
  [[nodiscard]] T integer(int column) const {
    const std::int64_t value = number(column);
    if (std::in_range<T>(value)) return static_cast<T>(value);
    damaged(column, "a number out of range");
    return 0;
  }

 private:
  void damaged(int column, std::string_view has) const;
  void set(int index, std::int64_t value);
  void set(int index, std::uint64_t value) { set(index, static_cast<std::int64_t>(value)); }
  void set(int index, std::uint32_t value) { set(index, std::int64_t{value}); }
  void set(int index, int value) { set(index, std::int64_t{value}); }
  void set(int index, double value);
  void set(int index, std::string_view value);
  void set(int index, const std::string& value) { set(index, std::string_view(value)); }
  void set(int index, const char* value) { set(index, std::string_view(value)); }
  void set(int index, Blob value);
  void set(int index, std::nullopt_t);
  template <class T>
  void set(int index, const std::optional<T>& value) {
    if (value) {
      set(index, *value);
    } else {
      set(index, std::nullopt);
    }
  }

  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace jaywalk
