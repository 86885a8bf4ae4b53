#pragma once

// Random sequences: what `random-sequences` proposes, and what `graft` puts around its stretches.

#include "search/test_input.h"

namespace jaywalk::search {

/// By how much neighbours of a random sequence differ at most: 0.05 1/m of 0.07 (Frenetic's bound).
inline constexpr double kMostDifference = 0.05 / 0.07;

/// Appends `count` numbers from -1 to 1, each uniform among those that differ from the one before
/// it by kMostDifference at most; the very first one follows 0.
void append_random(std::vector<double>& values, int count, Random& random);

/// Its length is uniform among those that the bounds call usual.
[[nodiscard]] TestInput draw_sequence(const SequenceBounds& bounds, Random& random);

}  // namespace jaywalk::search
