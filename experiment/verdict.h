#pragma once

// When a comparison counts as failed: `accuracy<40`.

#include <span>
#include <string>
#include <string_view>

#include "experiment/measures/measures.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

enum class BoundKind { less, less_equal, greater, greater_equal, equal, not_equal };

/// A measure, by name or column, compared with a number.
struct FailureCondition {
  std::string text;
  const Measure* measure = nullptr;
  BoundKind kind = BoundKind::less;
  double bound = 0;
};

/// Parses `accuracy<40`; blanks are allowed, the comparisons are < <= > >= == !=.
[[nodiscard]] Result<FailureCondition> parse_failure_condition(std::string_view text);

/// A measure that does not exist (the score if no test succeeded) fails nothing.
[[nodiscard]] bool fails(const FailureCondition& condition, const Summary& summary);

}  // namespace jaywalk
