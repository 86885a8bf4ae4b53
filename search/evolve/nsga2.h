// SPDX-License-Identifier: Apache-2.0
#pragma once

// NSGA-II (Deb, Pratap, Agarwal and Meyarivan 2002, "A fast and elitist multiobjective genetic
// algorithm: NSGA-II") that maximises two objectives.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "search/test_input.h"

namespace jaywalk::search {

/// An individual's fitness. `lacks`: by how much it misses the constraints; an individual that
/// misses less dominates, whatever its objectives are.
struct Worth {
  std::array<double, 2> objectives{};
  double lacks = 0;
};

[[nodiscard]] bool dominates(const Worth& a, const Worth& b);

/// An individual's place among others: its front (0: not dominated), and how far
/// its neighbours in that front are (the more the better).
struct Standing {
  std::size_t front = 0;
  double crowding = 0;
};
[[nodiscard]] bool better(const Standing& a, const Standing& b);

[[nodiscard]] std::vector<Standing> rank(std::span<const Worth> worths);

/// The indices of the best `count` individuals, the best first.
[[nodiscard]] std::vector<std::size_t> survivors(std::span<const Standing> standings,
                                                 std::size_t count);

/// The better of two by chance. REQUIRES: not empty.
[[nodiscard]] std::size_t tournament(std::span<const Standing> standings, Random& random);

}  // namespace jaywalk::search
