// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which of the cheap measures (accuracy, score, …) predicts what kills: their rank correlations
// with the share of kills over the behaviours of one number of agents.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiment/compare/comparison.h"
#include "experiment/compare/measures/measures.h"

namespace jaywalk {

struct Predictor {
  const Measure* measure = nullptr;
  std::uint32_t agents = 0;
  /// The behaviours that have a value of the measure.
  std::size_t behaviours = 0;
  /// Spearman's coefficient, from -1 to 1.
  double rank_correlation = 0;
};

/// In the order of the numbers of agents, then of the measures; those of fewer than three
/// behaviours, or of values that are all alike, are left out.
[[nodiscard]] std::vector<Predictor> predictors(const Comparison& comparison);

}  // namespace jaywalk
