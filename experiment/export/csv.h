#pragma once

// A comparison as CSV: a header line, then a row for each behaviour and number of agents. Numbers
// have at most six decimals, without trailing zeros; what does not exist is empty. Equal results
// give equal bytes.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

[[nodiscard]] std::string to_csv(const Comparison& comparison);

}  // namespace jaywalk
