// SPDX-License-Identifier: Apache-2.0
#pragma once

// When a comparison counts as failed: `accuracy<40`.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiment/compare/comparison.h"
#include "experiment/compare/measures/measures.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

enum class BoundKind { less, less_equal, greater, greater_equal, equal, not_equal };

/// A measure, by name or column, compared with a number; or of an assertion how many tests had a
/// verdict (`recovery.fail`), or what share met its precondition (`recovery.exercised_pct`).
struct FailureCondition {
  std::string text;
  const Measure* measure = nullptr;
  /// Instead of a measure: an assertion and the verdict or share of it that is compared.
  std::string assertion;
  std::string field;
  BoundKind kind = BoundKind::less;
  double bound = 0;
};

/// Parses `accuracy<40`; blanks are allowed, the comparisons are < <= > >= == !=.
[[nodiscard]] Result<FailureCondition> parse_failure_condition(std::string_view text);

/// The number that the condition is about; nothing if no test gives one (the score if none
/// succeeded, verdicts if all ended errored). REQUIRES: a row of the comparison.
[[nodiscard]] std::optional<double> value_of(const FailureCondition& condition,
                                             const Comparison& comparison, std::size_t row);

/// The measure or verdict that the condition compares, `accuracy` or `recovery.fail`.
[[nodiscard]] std::string subject_of(const FailureCondition& condition);

/// Why the comparison has no such assertion; nothing if it has.
[[nodiscard]] Diagnostics problems(const FailureCondition& condition,
                                   std::span<const Assertion> assertions);

/// Whether the row meets the condition. A row without such a number fails, too.
[[nodiscard]] bool fails(const FailureCondition& condition, const Comparison& comparison,
                         std::size_t row);

}  // namespace jaywalk
