#pragma once

// `--coverage`: what of the agents' programs was used, written to files.

#include "interpreter/coverage/source_coverage.h"
#include "tools/jaywalk/arguments.h"
#include "tools/jaywalk/console.h"

namespace jaywalk {

inline constexpr OptionSpec kCoverageOption{
    "coverage", "FILE",
    "write which plans, conditions and formulas of the agents'\n"
    "programs were used: a listing (.txt), a page (.html) or a\n"
    "tracefile of LCOV (.info); repeatable"};

/// Adds an error for each file whose ending says nothing.
void check_coverage_options(const Arguments& arguments, Diagnostics& diagnostics);

/// Writes the files; false after reporting what could not be written.
[[nodiscard]] bool write_coverage(const Arguments& arguments, const SourceCoverage& coverage,
                                  Console& console);

/// As `locate`, of programs whose files are read again.
[[nodiscard]] SourceCoverage locate_in_files(const Probes& probes, const CoverageCounts& counts);

}  // namespace jaywalk
