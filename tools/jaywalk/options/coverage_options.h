// SPDX-License-Identifier: Apache-2.0
#pragma once

// `--coverage`: what of the agents' programs was used, written to files.

#include "experiment/report/stored_coverage.h"
#include "experiment/results/description.h"
#include "interpreter/coverage/source_coverage.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr OptionSpec kCoverageOption{
    option::kCoverage, "FILE",
    "write which plans, conditions and formulas of the agents'\n"
    "programs were used: a listing (.txt), a page (.html) or a\n"
    "tracefile of LCOV (.info); repeatable. A rule's last call\n"
    "takes memory then, so deep recursion may reach the limit",
    Written::file};

/// Adds an error for each file whose ending says nothing.
void check_coverage_options(const Arguments& arguments, Diagnostics& diagnostics);

/// Writes the files; `subject` says on the page what ran. False after reporting what could not be
/// written.
[[nodiscard]] bool write_coverage(const Arguments& arguments, const SourceCoverage& coverage,
                                  const std::string& subject, Console& console);

/// The tests that ran: "scenarios/paper.yaml: election; 1, 3 agents; tests 0 to 199 of seed 0".
[[nodiscard]] std::string coverage_subject(const ExperimentDescription& experiment,
                                           const CoverageWanted& wanted);

}  // namespace jaywalk
