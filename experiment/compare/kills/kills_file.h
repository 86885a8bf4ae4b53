// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kill matrix as CSV, as `--kills` writes it, and such files read again: kills that were
// counted elsewhere (a search, another comparison) beside those of a matrix. Read kills.h first.
//
// A row for each behaviour, number of agents and defect. Columns: behaviour, agents, defect,
// severity (empty: it has none), tests, kills, kill_pct with its 95 % interval (low, high; Wilson),
// first_kill_median: how many tests it takes to kill the defect with a chance of a half (empty:
// none did).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/kills/kills.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

inline constexpr std::string_view kKillsCsvHeader =
    "behaviour,agents,defect,severity,tests,kills,kill_pct,low,high,first_kill_median";

/// Cells whose tests are not finished are left out. Equal matrices give equal bytes.
[[nodiscard]] std::string to_kills_csv(const KillMatrix& matrix);

/// A line of such a file.
struct KillLine {
  std::string behaviour;
  std::uint32_t agents = 0;
  /// With its severity: `latency=0.3`.
  std::string defect;
  std::uint64_t tests = 0;
  std::uint64_t kills = 0;
  std::optional<std::uint64_t> first_median;
  SourceSpan where;
};

/// All mistakes are reported, with their places.
[[nodiscard]] Result<std::vector<KillLine>> parse_kills(const SourcePtr& source);

/// Adds rows to the matrix, of which only kills are known. Defects that the matrix does not have
/// are left out; those of its own without a line have no tests.
/// REQUIRES: no mistakes_of().
void add_kills(const std::vector<KillLine>& lines, KillMatrix& matrix);

/// Errors that prevent showing the lines of a file beside the plan's rows and those of `earlier`
/// files: a row that is there already, or no common defect.
[[nodiscard]] Diagnostics mistakes_of(const std::vector<KillLine>& lines,
                                      const ExperimentPlan& plan,
                                      const std::vector<KillLine>& earlier);

/// The file's defects that are not among these, each once.
[[nodiscard]] std::vector<std::string> other_defects(const std::vector<KillLine>& lines,
                                                     const ExperimentPlan& plan);

}  // namespace jaywalk
