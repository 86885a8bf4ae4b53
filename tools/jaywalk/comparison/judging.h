// SPDX-License-Identifier: Apache-2.0
#pragma once

// `--assertions`, `--fail-on` and their like: the assertions and metrics to evaluate on tests, and
// the report of their results.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/comparison.h"
#include "experiment/compare/failure_condition.h"
#include "experiment/results/reader.h"
#include "experiment/scenario/scenario.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

inline constexpr std::array kJudgingOptions = {
    OptionSpec{option::kAssertions, "FILE",
               "judge the tests by these assertions (.yaml) instead of the\n"
               "scenario's; repeatable"},
    OptionSpec{option::kMetrics, "",
               "measure the tests: minimum distance, time to collision, ...\n"
               "(jaywalk list metrics)"},
    OptionSpec{option::kJunit, "FILE", "write the verdicts as JUnit XML", Written::file},
};

/// The assertions of the options, or `otherwise` (the scenario's) if there are none; nothing after
/// reporting errors.
[[nodiscard]] std::optional<Criteria> read_criteria(const Arguments& arguments,
                                                    const std::vector<Assertion>& otherwise,
                                                    Console& console);

/// The conditions of --fail-on; adds errors. Conditions about assertions can be checked only once
/// the assertions are known: check_conditions() reports errors in them.
[[nodiscard]] std::vector<FailureCondition> read_conditions(const Arguments& arguments,
                                                            Diagnostics& diagnostics);
[[nodiscard]] bool check_conditions(const std::vector<FailureCondition>& conditions,
                                    const Criteria& criteria, Console& console);

/// Says which rows meet a condition; whether any does.
[[nodiscard]] bool report_failures(const std::vector<FailureCondition>& conditions,
                                   const Comparison& comparison, Console& console);

}  // namespace jaywalk
