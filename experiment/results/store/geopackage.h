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

#include "experiment/results/store/database.h"

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

}  // namespace jaywalk
