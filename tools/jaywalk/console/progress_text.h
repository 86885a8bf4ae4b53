#pragma once

// How far a long run is, in words.

#include <string>

#include "experiment/compare/experiment.h"
#include "search/search.h"

namespace jaywalk {

/// To the second below an hour, to the minute from there: "3 s", "6 min 05 s", "2 h 00 min".
[[nodiscard]] std::string duration_text(double seconds);

/// "1200 of 84000 tests (1 %), 30500 per second, 3 s left".
[[nodiscard]] std::string progress_text(const Progress& progress, double seconds);

/// "1200 tests, 31 failing, best fitness 0.98, 12 % of the budget, 3 s left".
[[nodiscard]] std::string progress_text(const search::SearchProgress& progress, double seconds);

}  // namespace jaywalk
