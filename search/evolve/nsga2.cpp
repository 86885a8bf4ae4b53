// SPDX-License-Identifier: Apache-2.0
#include "search/evolve/nsga2.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace jaywalk::search {
namespace {

/// Section III-B: for each objective, the distance of the neighbours in its order; the outermost
/// are infinitely far apart.
void measure_crowding(std::span<const Worth> worths, std::vector<std::size_t> front,
                      std::vector<Standing>& standings) {
  for (std::size_t objective = 0; objective < 2; ++objective) {
    const auto value = [&](std::size_t i) { return worths[i].objectives[objective]; };
    std::ranges::stable_sort(front, {}, value);
    const double range = value(front.back()) - value(front.front());
    for (const std::size_t outermost : {front.front(), front.back()}) {
      standings[outermost].crowding = std::numeric_limits<double>::infinity();
    }
    for (std::size_t k = 1; k + 1 < front.size() && range > 0; ++k) {
      standings[front[k]].crowding += (value(front[k + 1]) - value(front[k - 1])) / range;
    }
  }
}

}  // namespace

bool dominates(const Worth& a, const Worth& b) {
  // Constrained domination: what lacks less is better, whatever it achieves.
  if (a.lacks != b.lacks) return a.lacks < b.lacks;
  const auto& [a0, a1] = a.objectives;
  const auto& [b0, b1] = b.objectives;
  return a0 >= b0 && a1 >= b1 && (a0 > b0 || a1 > b1);
}

bool better(const Standing& a, const Standing& b) {
  return a.front != b.front ? a.front < b.front : a.crowding > b.crowding;
}

std::vector<Standing> rank(std::span<const Worth> worths) {
  std::vector<Standing> standings(worths.size());
  std::vector<std::size_t> dominated_by(worths.size());
  std::vector<std::vector<std::size_t>> dominated(worths.size());
  for (std::size_t i = 0; i < worths.size(); ++i) {
    for (std::size_t j = 0; j < worths.size(); ++j) {
      if (!dominates(worths[i], worths[j])) continue;
      dominated[i].push_back(j);
      ++dominated_by[j];
    }
  }
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < worths.size(); ++i) {
    if (dominated_by[i] == 0) front.push_back(i);
  }
  for (std::size_t number = 0; !front.empty(); ++number) {
    std::vector<std::size_t> next;
    for (const std::size_t i : front) {
      standings[i].front = number;
      for (const std::size_t j : dominated[i]) {
        // Dominated by nothing but what is in this front and those before.
        if (--dominated_by[j] == 0) next.push_back(j);
      }
    }
    measure_crowding(worths, std::move(front), standings);
    front = std::move(next);
  }
  return standings;
}

std::vector<std::size_t> survivors(std::span<const Standing> standings, std::size_t count) {
  std::vector<std::size_t> order(standings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return better(standings[a], standings[b]); });
  order.resize(std::min(count, order.size()));
  return order;
}

std::size_t tournament(std::span<const Standing> standings, Random& random) {
  const std::size_t one = random.below(standings.size());
  const std::size_t other = random.below(standings.size());
  return better(standings[other], standings[one]) ? other : one;
}

}  // namespace jaywalk::search
