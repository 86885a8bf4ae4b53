#pragma once

// A comparison as JSON: what was compared, then an object for each behaviour and number of agents
// with the fields of the CSV and what the paper published, where that may be shown (published.h).
// What does not exist is null.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

[[nodiscard]] std::string to_json(const Comparison& comparison);

}  // namespace jaywalk
