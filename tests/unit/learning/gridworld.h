// SPDX-License-Identifier: Apache-2.0
#pragma once

// A textbook problem: four by four cells, four moves, a reward of -1 for each, an end in two
// corners (Sutton and Barto, "Reinforcement learning", 2018, example 4.1, under the best policy:
// what is expected is minus the distance to the nearer end).

#include <cstdint>
#include <vector>

#include "experiment/networks/random.h"
#include "experiment/policy/learner.h"

namespace jaywalk::testing_learning {

inline constexpr int kSize = 4;

struct Cell {
  int x = 0;
  int y = 0;
};

[[nodiscard]] std::vector<Cell> cells_to_begin_in();
[[nodiscard]] std::vector<double> features_of(Cell cell);
/// Minus the number of moves that it takes.
[[nodiscard]] double best_value(Cell cell);

/// Episodes from every cell, by what the learner explores.
[[nodiscard]] std::vector<Episode> generation_of(const Learner& learner, networks::Random& random);

}  // namespace jaywalk::testing_learning
