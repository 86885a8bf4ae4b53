// SPDX-License-Identifier: Apache-2.0
#pragma once

// A source of random numbers of its own, for a search or a learner. One seed gives the same numbers
// on every machine.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/support/random.h"

namespace jaywalk::networks {

class Random {
 public:
  explicit Random(std::uint64_t seed) : source_(seed) {}

  /// Uniform over 0 ... bound - 1. REQUIRES: bound > 0.
  [[nodiscard]] std::size_t below(std::size_t bound) { return source_.below(bound); }
  /// Uniform over first ... last.
  [[nodiscard]] int between(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::size_t>(last - first) + 1));
  }
  /// Uniform in [low, high).
  [[nodiscard]] double uniform(double low, double high) {
    return low + (high - low) * source_.share();
  }
  [[nodiscard]] bool coin() { return (source_.next() >> 63U) != 0; }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  SplitMix64 source_;
};

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

}  // namespace jaywalk::networks
