// SPDX-License-Identifier: Apache-2.0
#pragma once

// The tables of a results store beside those of every store (geopackage.h); docs/reference/store.md
// describes all of them.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "experiment/results/store/database.h"
#include "experiment/results/store/geometry.h"
#include "experiment/results/store/geopackage.h"

namespace jaywalk {

/// Changes with the tables. A store of another version is refused.
inline constexpr std::int64_t kStoreVersion = 3;

/// Rows that belong to a test are numbered test_id * 2^24 + n, so that their order is the plan's,
/// whatever the order in which they were written.
inline constexpr int kRowBits = 24;
inline constexpr std::int64_t kMaxTestId = std::int64_t{1} << (62 - kRowBits);
inline constexpr std::int64_t kMaxRows = std::int64_t{1} << kRowBits;

[[nodiscard]] constexpr std::int64_t row_id(std::int64_t test_id, std::int64_t row) {
  return (test_id << kRowBits) + row;
}

/// The tables with rows for each test, which are copied when stores are merged.
inline constexpr std::array<std::string_view, 6> kTablesOfTests = {
    "tests", "actors", "observations", "events", "drops", "assessments"};

/// Creates all tables in an empty file.
void create_tables(Database& database, const Placement& placement);

/// Stores with these tables, and no others.
[[nodiscard]] StoreKind results_store();

/// `2000-01-01T00:00:12.500Z`: the moment `seconds` after tick 0, in the column `time`. Tick 0 is
/// the same for every test.
[[nodiscard]] std::string time_text(double seconds);

/// Records the extent of each layer's rows.
void note_extents(Database& database, const Placement& placement);
/// Adds the index by test, once all rows are there; the last thing that is done.
void complete_tables(Database& database);
[[nodiscard]] bool is_completed(Database& database);

}  // namespace jaywalk
