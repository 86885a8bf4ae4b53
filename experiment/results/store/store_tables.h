#pragma once

// Whether a database has the tables that it should have, and nothing that does something by itself:
// looked at before anything is read of a file that may come from anywhere.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "experiment/results/store/database.h"

namespace jaywalk {

/// Stores of a kind: those of tests, and those of searches (search/store).
struct StoreKind {
  /// In messages, after "a".
  std::string_view name;
  /// A table that no other kind has.
  std::string_view table;
  /// Changes with the tables.
  std::int64_t version;
  /// Makes everything that such a store may have beside tables of others.
  std::function<void(Database&)> create;
};

[[nodiscard]] bool is_store(Database& database, const StoreKind& kind);

/// Why it is no store of this kind and version that Jaywalk wrote: it lacks a table, or one has
/// other columns; it has a view, a trigger, a virtual table or an index of its own. Tables that
/// others have added (styles of a GIS) are ignored. Nothing, too, if the database failed.
[[nodiscard]] std::optional<std::string> objection(Database& database, const StoreKind& kind);

}  // namespace jaywalk
