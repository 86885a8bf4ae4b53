#pragma once

// A comparison as JSON: the experiment, then an object for each behaviour and number of agents with
// the fields of the CSV and the paper's figures, where these may be shown (published.h). Values
// that do not exist are null.

#include <string>

#include "experiment/compare/comparison.h"

namespace jaywalk {

[[nodiscard]] std::string to_json(const Comparison& comparison);

}  // namespace jaywalk
