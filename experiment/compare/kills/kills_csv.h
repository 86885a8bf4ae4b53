#pragma once

// The kill matrix as CSV: a row for each behaviour, number of agents and defect. Columns:
// behaviour, agents, defect, severity (empty: it has none), tests, kills, kill_pct with its 95 %
// interval (low, high; Wilson), first_kill_median: how many tests it takes to kill the defect with
// a chance of a half (empty: none did).

#include <string>
#include <string_view>

#include "experiment/compare/kills/kills.h"

namespace jaywalk {

inline constexpr std::string_view kKillsCsvHeader =
    "behaviour,agents,defect,severity,tests,kills,kill_pct,low,high,first_kill_median";

/// Cells whose tests are not finished are left out. Equal matrices give equal bytes.
[[nodiscard]] std::string to_kills_csv(const KillMatrix& matrix);

}  // namespace jaywalk
