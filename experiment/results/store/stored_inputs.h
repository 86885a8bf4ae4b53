#pragma once

// The files that tests were made from, kept in a store as they were: a store can be read anywhere
// and opens nothing that its maker named.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/results/store/database.h"
#include "interpreter/support/source.h"
#include "interpreter/support/source_files.h"

namespace jaywalk {

/// An input file of an experiment: scenario, start cells, programs and their includes.
struct StoredInput {
  /// As it was named when it was read.
  std::string path;
  std::string text;
  /// The hash of the text, 64 hexadecimal digits.
  std::string sha256;
};

[[nodiscard]] StoredInput stored_input(const Source& source);
[[nodiscard]] std::vector<StoredInput> stored_inputs(std::span<const SourcePtr> sources);
/// The files as they were, and no others.
[[nodiscard]] SourceFiles copies_of(std::span<const StoredInput> inputs);

/// Their table, empty. Statements of SQL.
inline constexpr std::string_view kInputsTable =
    "CREATE TABLE inputs (id INTEGER PRIMARY KEY NOT NULL, path TEXT NOT NULL, sha256 TEXT NOT "
    "NULL, text TEXT NOT NULL);";

void write_inputs(Database& database, std::span<const StoredInput> inputs);
[[nodiscard]] std::vector<StoredInput> read_inputs(Database& database);
/// Why they are not as they were written; nothing if they are.
[[nodiscard]] std::optional<std::string> damage_of(std::span<const StoredInput> inputs);

}  // namespace jaywalk
