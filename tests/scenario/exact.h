// SPDX-License-Identifier: Apache-2.0
#pragma once

// The exact answers of the case study's small world, and how far from them chance may lead.

#include <array>
#include <cmath>
#include <cstdint>

#include "reference.h"

namespace jaywalk::exact {

struct Answer {
  reference::Behaviour behaviour;
  const char* program;
  /// The probability that a single agent meets the precondition.
  double probability;
};

/// Agents act independently of each other, or the probability is 1.
inline constexpr std::array kAnswers{
    Answer{reference::Behaviour::random_action, "random_action", 0.16898},
    Answer{reference::Behaviour::random_behaviour, "random_behaviour", 0.27440},
    Answer{reference::Behaviour::proximity, "proximity", 0.47917},
    Answer{reference::Behaviour::intersect, "intersect", 1},
    Answer{reference::Behaviour::intersect_literal, "intersect_literal", 0.49109},
    Answer{reference::Behaviour::election_by_intersect, "election_by_intersect", 1},
};

struct ElectionAnswer {
  std::size_t agents;
  double accuracy;  // by simulation, within 0.009
};

inline constexpr std::array kElection{
    ElectionAnswer{1, 0.47917}, ElectionAnswer{2, 0.634},  ElectionAnswer{3, 0.731},
    ElectionAnswer{4, 0.785},   ElectionAnswer{5, 0.830},  ElectionAnswer{10, 0.925},
    ElectionAnswer{15, 0.954},  ElectionAnswer{20, 0.966},
};

/// The probability that at least one of several agents meets the precondition.
inline double accuracy(double probability, std::size_t agents) {
  return 1 - std::pow(1 - probability, static_cast<double>(agents));
}

/// Half the 99.9 % interval of a proportion estimated from `tests` tests.
inline double tolerance(double accuracy, std::uint64_t tests) {
  constexpr double kDeviations = 3.2905;
  return kDeviations * std::sqrt(accuracy * (1 - accuracy) / static_cast<double>(tests));
}

}  // namespace jaywalk::exact
