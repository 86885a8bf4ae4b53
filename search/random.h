#pragma once

// A search's own source of random numbers. One seed gives the same numbers on every machine.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "experiment/networks/random.h"
#include "interpreter/support/random.h"

namespace jaywalk::search {

using networks::Random;

/// A seed for something with a name (FNV-1a), so that it does not depend on what else there is.
[[nodiscard]] constexpr std::uint64_t mix_name(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  }
  return mix(seed, hash);
}

/// From the standard normal distribution (Box and Muller 1958).
[[nodiscard]] inline double standard_normal(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform(0, 1)));
  return radius * std::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

}  // namespace jaywalk::search
