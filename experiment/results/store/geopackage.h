// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tables of every store: those of a GeoPackage (OGC 12-128, version 1.3), which is a SQLite
// file with some tables that say which others are layers, and ours for versions and input files.
// Before anything is read of a file that may come from anywhere, it is seen to have the tables that
// it should have, and nothing that does something by itself.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/results/store/database.h"
#include "interpreter/support/source_files.h"
#include <jaywalk/diagnostics.h>

namespace jaywalk {

/// The four bytes `GPKG` in the header of a SQLite file, its `application_id`.
inline constexpr std::uint32_t kGeoPackageId = 0x47504B47;
/// Version 1.3, its `user_version`.
inline constexpr std::int64_t kGeoPackageVersion = 10300;

/// A table as readers of GeoPackages find it.
struct ListedTable {
  std::string_view name;
  std::string_view description;
  /// POINT or LINESTRING, in the column `geom`; empty: its rows have no place.
  std::string_view geometry = {};
};

/// Makes these tables in an empty file. `plane` describes the coordinates that lie nowhere on
/// earth.
void create_geopackage(Database& database, std::string_view plane);
void list_tables(Database& database, std::span<const ListedTable> tables, int srs_id);
/// Notes the version of the store's own tables, and that of the program that writes it.
void write_versions(Database& database, std::int64_t store, std::string_view jaywalk);

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

/// An input file of an experiment (scenario, start cells, programs and their includes), kept in a
/// store as it was: a store can be read anywhere and opens nothing that its maker named.
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
