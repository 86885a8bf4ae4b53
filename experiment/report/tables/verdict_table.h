#pragma once

// Verdicts and metrics as text, for a terminal of 80 columns.

#include <span>
#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// A row for each assertion, behaviour and number of agents; empty if none was judged.
[[nodiscard]] std::string render_verdicts(const Comparison& comparison);
/// How each metric is spread; empty if none was measured.
[[nodiscard]] std::string render_metrics(const Comparison& comparison);
/// The table of measures (table.h), then these as far as there are any.
[[nodiscard]] std::string render_tables(const Comparison& comparison);
/// The text for one test: a line for each assertion, and one for each metric that has a value.
[[nodiscard]] std::string render_assessment(const Criteria& criteria,
                                            const TestAssessment& assessment,
                                            std::span<const Actor> actors);

}  // namespace jaywalk
