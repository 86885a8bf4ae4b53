#pragma once

// NSGA-II (Deb, Pratap, Agarwal and Meyarivan 2002, "A fast and elitist multiobjective genetic
// algorithm: NSGA-II") for two objectives that are to be large.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "search/random.h"

namespace jaywalk::search {

/// What an individual is worth. `lacks`: by how much it misses what is required; any that misses
/// less dominates, whatever its objectives are.
struct Worth {
  std::array<double, 2> objectives{};
  double lacks = 0;
};

[[nodiscard]] bool dominates(const Worth& a, const Worth& b);

/// Where an individual stands among others: in which front (0: nobody dominates it), and how far
/// its neighbours in that front are (the more the better).
struct Standing {
  std::size_t front = 0;
  double crowding = 0;
};
[[nodiscard]] bool better(const Standing& a, const Standing& b);

[[nodiscard]] std::vector<Standing> rank(std::span<const Worth> worths);

/// The indices of the best so many, the best first.
[[nodiscard]] std::vector<std::size_t> survivors(std::span<const Standing> standings,
                                                 std::size_t count);

/// The better of two by chance. REQUIRES: not empty.
[[nodiscard]] std::size_t tournament(std::span<const Standing> standings, Random& random);

}  // namespace jaywalk::search
