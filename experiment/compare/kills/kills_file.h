#pragma once

// Kills that were counted elsewhere (a search, another comparison) beside those of a matrix: reads
// the CSV that `--kills` writes (compare/kills/kills_csv.h). Read kills.h first.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/kills/kills.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

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
