// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/kills/predictors.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "experiment/compare/measures/statistics.h"

namespace jaywalk {
namespace {

/// Measured times would differ from run to run, and lines of code are no result.
constexpr std::array<std::string_view, 4> kCandidates = {"accuracy", "score", "combined",
                                                         "ticks_all"};

struct Pairs {
  std::vector<double> values;
  std::vector<double> kills;
};

Pairs pairs_of(const Comparison& comparison, const Measure& measure, std::uint32_t agents) {
  Pairs pairs;
  for (const KillRow& row : comparison.kills.rows) {
    if (row.agents != agents || row.tests() == 0 || row.kills_alone) continue;
    for (const Summary& summary : comparison.summaries) {
      if (summary.agents != agents || summary.behaviour != row.behaviour) continue;
      const Estimate estimate = measure.estimate(summary);
      if (!estimate.value) continue;
      pairs.values.push_back(*estimate.value);
      pairs.kills.push_back(kill_pct(row));
    }
  }
  return pairs;
}

std::vector<std::uint32_t> numbers_of_agents(const KillMatrix& matrix) {
  std::vector<std::uint32_t> numbers;
  for (const KillRow& row : matrix.rows) {
    if (std::ranges::find(numbers, row.agents) == numbers.end()) numbers.push_back(row.agents);
  }
  return numbers;
}

}  // namespace

std::vector<Predictor> predictors(const Comparison& comparison) {
  constexpr std::size_t kFewest = 3;
  std::vector<Predictor> found;
  for (const std::uint32_t agents : numbers_of_agents(comparison.kills)) {
    for (const std::string_view name : kCandidates) {
      const Measure& measure = *find_measure(name);
      const Pairs pairs = pairs_of(comparison, measure, agents);
      if (pairs.values.size() < kFewest) continue;
      const auto correlation = rank_correlation(pairs.values, pairs.kills);
      if (!correlation) continue;
      found.push_back({.measure = &measure,
                       .agents = agents,
                       .behaviours = pairs.values.size(),
                       .rank_correlation = *correlation});
    }
  }
  return found;
}

}  // namespace jaywalk
