// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/store_changes.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sqlite3.h>
#include <vector>

#include "experiment/scenario/files/program_text.h"
#include "tests/fuzz/run_case.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz {
namespace {

struct Table {
  std::string name;
  std::vector<std::string> columns;
  /// Those of its columns that hold texts.
  std::vector<std::string> texts;
};

std::string read_bytes(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A connection that closes itself; what fails is none of its business.
class Connection {
 public:
  explicit Connection(const std::string& path) { (void)sqlite3_open(path.c_str(), &connection_); }
  ~Connection() { (void)sqlite3_close(connection_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void execute(const std::string& sql) {
    (void)sqlite3_exec(connection_, sql.c_str(), nullptr, nullptr, nullptr);
  }

  /// The first column of all rows.
  std::vector<std::string> texts(const std::string& sql) {
    std::vector<std::string> found;
    const auto keep = [](void* list, int, char** values, char**) {
      static_cast<std::vector<std::string>*>(list)->emplace_back(values[0] == nullptr ? ""
                                                                                      : values[0]);
      return 0;
    };
    (void)sqlite3_exec(connection_, sql.c_str(), keep, &found, nullptr);
    return found;
  }

  std::vector<Table> tables() {
    std::vector<Table> tables;
    for (std::string& name :
         texts("SELECT name FROM sqlite_master WHERE type='table' ORDER BY name")) {
      auto columns = texts("SELECT name FROM pragma_table_info('" + name + "')");
      auto with_texts =
          texts("SELECT name FROM pragma_table_info('" + name + "') WHERE type='TEXT'");
      tables.push_back({std::move(name), std::move(columns), std::move(with_texts)});
    }
    return tables;
  }

 private:
  sqlite3* connection_ = nullptr;
};

std::string_view odd_value(Choices& choices, std::string& column) {
  static thread_local std::string value;
  switch (choices.below(10)) {
    case 0:
      value = "substr(" + column + ",1,length(" + column + ")/2)";
      break;
    case 1:
      value = column + "||" + column;
      break;
    case 2:
      value = column + "+1";
      break;
    case 3:
      value = "-" + column;
      break;
    case 4:
      value = "CAST(" + column + " AS " + std::string(choices.one_of({"BLOB", "TEXT", "INTEGER"})) +
              ")";
      break;
    default:
      return choices.one_of({"NULL",
                             "0",
                             "-1",
                             "1",
                             "0.5",
                             "2147483647",
                             "2147483648",
                             "4294967296",
                             "9223372036854775807",
                             "-9223372036854775808",
                             "1e308",
                             "9e999",
                             "-9e999",
                             "''",
                             "'x'",
                             "x'00'",
                             "x'ff00ff'",
                             "zeroblob(100000)",
                             "'../../x'",
                             "'<script>'",
                             "char(10)",
                             "char(27)||'[2J'"});
  }
  return value;
}

/// A text that would do harm as a part of a path, on a terminal or in a table.
std::string hostile_text(Choices& choices) {
  const std::string outside = "'" + std::string(kOutside) + "'";
  const std::string_view text =
      choices.one_of({"'..'", "'../x'", "'../../x'", "'../x'||char(0)", "char(0)",
                      "'x'||char(0)||'/../../y'", "'a/../../x'", "'.'", "'.x'", "''",
                      "char(27)||'[2J'", "'x'||char(10)||'y'", "'=HYPERLINK(1)'", "'=1,\"2'",
                      "'-1+1'", "'<x y=\"'", "x'ff'", "outside", "outside||char(0)"});
  if (!text.starts_with("outside")) return std::string(text);
  return outside + std::string(text.substr(std::string_view("outside").size()));
}

/// Some text becomes a hostile one in every column of texts that has it, so that names still agree.
std::string other_name(Choices& choices, const std::vector<Table>& tables) {
  const Table& table = tables[choices.below(tables.size())];
  if (table.texts.empty()) return {};
  const std::string column = '"' + table.texts[choices.below(table.texts.size())] + '"';
  std::string sql = "CREATE TEMP TABLE was AS SELECT " + column + " AS text FROM \"" + table.name +
                    "\" LIMIT 1 OFFSET " + std::to_string(choices.below(4)) + ";\n";
  const std::string text = hostile_text(choices);
  for (const Table& each : tables) {
    for (const std::string& name : each.texts) {
      sql += "UPDATE \"" + each.name + "\" SET \"" + name + "\"=" + text + " WHERE \"" + name +
             "\"=(SELECT text FROM was);\n";
    }
  }
  return sql + "DROP TABLE was;\n";
}

/// An input of the experiment with another text, and its digest with it.
std::string other_input(Choices& choices, Connection& store) {
  const auto texts = store.texts("SELECT text FROM inputs ORDER BY id");
  if (texts.empty()) return {};
  const std::size_t row = choices.below(texts.size());
  std::string text = spoil_yaml(choices, texts[row], one_of(choices, texts));
  std::erase(text, '\0');
  std::string quoted;
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return "UPDATE inputs SET text='" + quoted + "', sha256='" + sha256(text) +
         "' WHERE id=(SELECT id FROM inputs ORDER BY id LIMIT 1 OFFSET " + std::to_string(row) +
         ");\n";
}

std::string statement(Choices& choices, Connection& store, const std::vector<Table>& tables) {
  const Table& table = tables[choices.below(tables.size())];
  const std::string name = '"' + table.name + '"';
  std::string column = '"' + table.columns[choices.below(table.columns.size())] + '"';
  const std::string row = " WHERE rowid=(SELECT rowid FROM " + name + " LIMIT 1 OFFSET " +
                          std::to_string(choices.below(4)) + ")";
  if (choices.once_in(3)) return other_name(choices, tables);
  switch (choices.below(16)) {
    case 0:
      return "DELETE FROM " + name + row + ";\n";
    case 1:
      return "DELETE FROM " + name + ";\n";
    case 2:
      return "DROP TABLE " + name + ";\n";
    case 3:
      return "ALTER TABLE " + name + " RENAME COLUMN " + column + " TO other;\n";
    case 4:
      return "ALTER TABLE " + name + " RENAME TO other; CREATE VIEW " + name +
             " AS SELECT * FROM other;\n";
    case 5:
      return "CREATE TRIGGER t AFTER INSERT ON " + name + " BEGIN DELETE FROM " + name + "; END;\n";
    case 6:
      return "PRAGMA user_version=" + std::to_string(choices.below(20'000)) + ";\n";
    case 7:
      return "ALTER TABLE " + name + " RENAME TO other; CREATE TABLE " + name +
             " AS SELECT * FROM other;\n";
    case 8:
    case 9:
      return other_input(choices, store);
    case 10:
      return "UPDATE " + name + " SET " + column + "=" + std::string(odd_value(choices, column)) +
             ";\n";
    default:
      return "UPDATE " + name + " SET " + column + "=" + std::string(odd_value(choices, column)) +
             row + ";\n";
  }
}

std::string changed_bytes(Choices& choices, std::string& bytes) {
  const std::size_t times = 1 + choices.below(12);
  std::string how = "-- bytes:";
  for (std::size_t i = 0; i < times; ++i) {
    const std::size_t at = choices.below(choices.once_in(4) ? 100 : bytes.size());
    bytes[at] = static_cast<char>(choices.below(256));
    how += " " + std::to_string(at);
  }
  if (choices.once_in(6)) bytes.resize(choices.below(bytes.size()));
  return how + "\n";
}

}  // namespace

std::string sound_store(const std::string& name, const Case& maker) {
  const std::string folder = std::string(std::getenv("JAYWALK_FUZZ_SCRATCH")) + "/" + name;
  std::string path = folder + "/store.gpkg";
  if (!std::filesystem::exists(path)) (void)run_case(maker, folder);
  return path;
}

ChangedStore change_store(Choices& choices, const std::string& path, const std::string& sql) {
  if (sql.empty() && choices.once_in(3)) {
    std::string bytes = read_bytes(path);
    std::string how = changed_bytes(choices, bytes);
    return {.bytes = std::move(bytes), .how = std::move(how)};
  }
  const std::string copy = path + ".changed";
  std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing);
  std::string how = sql;
  {
    Connection store(copy);
    store.execute("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA foreign_keys=OFF;");
    const std::vector<Table> tables = store.tables();
    const std::size_t times = choices.below(3) + (sql.empty() ? 1 : 0);
    for (std::size_t i = 0; i < times; ++i) how += statement(choices, store, tables);
    store.execute(how);
  }
  std::string bytes = read_bytes(copy);
  std::filesystem::remove(copy);
  return {.bytes = std::move(bytes), .how = std::move(how)};
}

}  // namespace jaywalk::fuzz
