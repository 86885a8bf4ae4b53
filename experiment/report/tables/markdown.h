#pragma once

// A comparison as a table in Markdown, for issues and papers' notes.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

/// A row for each behaviour and number of agents; values with their 95 % intervals.
[[nodiscard]] std::string to_markdown(const Comparison& comparison);

}  // namespace jaywalk
