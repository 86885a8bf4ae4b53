// SPDX-License-Identifier: Apache-2.0
#pragma once

// The output of a comparison: a table, or the format that --format names; and notes about failures
// of its agents.

#include <string>
#include <vector>

#include "experiment/compare/comparison.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr OptionSpec kFormatOption{
    option::kFormat, "NAME", "print the results as csv, json or markdown instead of a table"};
inline constexpr OptionSpec kStrictOption{
    option::kStrict, "", "exit with 1 if agents dropped intentions or never acted"};

enum class Format { table, csv, json, markdown };

struct OutputOptions {
  Format format = Format::table;
  /// Not with --quiet, nor where another option takes standard output.
  bool shown = true;
  bool strict = false;
};

/// Adds an error for an unknown format.
[[nodiscard]] OutputOptions read_output_options(const Arguments& arguments,
                                                Diagnostics& diagnostics);

/// Prints it: in the format asked for, or as tables, or not at all. What went wrong with agents
/// goes to standard error where there are no tables.
void show_comparison(const OutputOptions& options, const Comparison& comparison, Console& console);

/// Warns of tests that ended errored. False after reporting rows of which no test has a result (of
/// a model or a defect of the AV, too), or that there are no rows at all.
[[nodiscard]] bool have_results(const Comparison& comparison, Console& console);

/// Says so if --strict objects to what happened to the agents.
[[nodiscard]] bool fails_strictly(const OutputOptions& options, const Comparison& comparison,
                                  Console& console);

}  // namespace jaywalk
