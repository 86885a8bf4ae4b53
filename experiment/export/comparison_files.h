// SPDX-License-Identifier: Apache-2.0
#pragma once

// A comparison as files for other programs, a source file for each format.

#include <span>
#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// A self-contained SVG picture: accuracy and combined score against the number of agents, ours
/// drawn solid, the published figures dashed in the same colour.
[[nodiscard]] std::string render_svg(const Comparison& comparison);

/// A header line, then a row for each behaviour and number of agents. Numbers have at most six
/// decimals, without trailing zeros; what does not exist is empty. Equal results give equal bytes.
[[nodiscard]] std::string to_csv(const Comparison& comparison);

/// The experiment, then an object for each behaviour and number of agents with the fields of the
/// CSV and the paper's figures, where these may be shown (published.h). Values that do not exist
/// are null.
[[nodiscard]] std::string to_json(const Comparison& comparison);

/// Verdicts as JUnit XML, which continuous integration reads: a suite for each assertion, a case
/// for each behaviour and number of agents: failed if some test violated it, skipped if no test
/// exercised it.
[[nodiscard]] std::string to_junit(const Comparison& comparison);
/// A suite for one test, called `name`, a case for each assertion.
[[nodiscard]] std::string to_junit(const std::string& name, const Criteria& criteria,
                                   const TestAssessment& assessment);

/// A table for issues and notes: a row for each behaviour and number of agents; values with their
/// 95 % intervals.
[[nodiscard]] std::string to_markdown(const Comparison& comparison);

}  // namespace jaywalk
