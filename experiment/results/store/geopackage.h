#pragma once

// The tables of every store: those of a GeoPackage (OGC 12-128, version 1.3), which is a SQLite
// file with some tables that say which others are layers, and ours for versions and input files.

#include <cstdint>
#include <span>
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

}  // namespace jaywalk
