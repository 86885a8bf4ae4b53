// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/learning/gridworld.h"

#include <algorithm>
#include <array>

namespace jaywalk::testing_learning {
namespace {

constexpr int kLongest = 60;

bool is_end(Cell cell) {
  return (cell.x == 0 && cell.y == 0) || (cell.x == kSize - 1 && cell.y == kSize - 1);
}

Cell moved(Cell cell, std::uint32_t option) {
  constexpr std::array<Cell, 4> kMoves{Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}};
  return {std::clamp(cell.x + kMoves[option].x, 0, kSize - 1),
          std::clamp(cell.y + kMoves[option].y, 0, kSize - 1)};
}

}  // namespace

std::vector<Cell> cells_to_begin_in() {
  std::vector<Cell> cells;
  for (int x = 0; x < kSize; ++x) {
    for (int y = 0; y < kSize; ++y) {
      if (!is_end({x, y})) cells.push_back({x, y});
    }
  }
  return cells;
}

std::vector<double> features_of(Cell cell) {
  std::vector<double> features(kSize * kSize);
  features[static_cast<std::size_t>(cell.x * kSize + cell.y)] = 1;
  return features;
}

double best_value(Cell cell) {
  return -std::min(cell.x + cell.y, 2 * (kSize - 1) - cell.x - cell.y);
}

std::vector<Episode> generation_of(const Learner& learner, networks::Random& random) {
  std::vector<Episode> generation;
  for (Cell cell : cells_to_begin_in()) {
    Episode& episode = generation.emplace_back();
    for (int i = 0; i < kLongest && !is_end(cell); ++i) {
      Transition transition{.features = features_of(cell), .options = {0, 1, 2, 3}, .reward = -1};
      std::array<double, 4> probabilities{};
      learner.weigh(transition.features, transition.options, Learner::Mode::explore, probabilities);
      double number = random.uniform(0, 1);
      while (transition.chosen < 3 && (number -= probabilities[transition.chosen]) >= 0) {
        ++transition.chosen;
      }
      transition.probability = probabilities[transition.chosen];
      cell = moved(cell, transition.chosen);
      episode.push_back(std::move(transition));
    }
  }
  return generation;
}

}  // namespace jaywalk::testing_learning
