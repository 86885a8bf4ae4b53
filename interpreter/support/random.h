// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sources of random numbers. Each agent, each test and each search has its own, whose seed derives
// from the experiment's; there is no global one. The same seed gives the same numbers on every
// machine, which the standard distributions do not.

#include <cassert>
#include <cstdint>

namespace jaywalk {

/// Small, fast and portable (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number
/// generators"): worlds, tests and searches draw from it.
class SplitMix64 {
 public:
  static constexpr std::uint64_t kStep = 0x9E3779B97F4A7C15U;

  explicit constexpr SplitMix64(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] constexpr std::uint64_t next() {
    state_ += kStep;
    return mixed(state_);
  }

  /// Uniform over 0 ... bound - 1, without bias. REQUIRES: bound > 0.
  [[nodiscard]] constexpr std::uint64_t below(std::uint64_t bound) {
    assert(bound > 0);
    // Numbers of the last, incomplete run of `bound` values are drawn again.
    const std::uint64_t excess = (UINT64_MAX % bound + 1) % bound;
    std::uint64_t value = next();
    while (value > UINT64_MAX - excess) value = next();
    return value % bound;
  }

  /// Uniform in [0, 1), in steps of 2^-53.
  [[nodiscard]] constexpr double share() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

  /// The finaliser: every bit of the result depends on every bit of `value`.
  [[nodiscard]] static constexpr std::uint64_t mixed(std::uint64_t value) {
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31U);
  }

 private:
  std::uint64_t state_;
};

/// Mixes a word so that neighbouring inputs give unrelated outputs. Seeds derive from seeds through
/// it.
[[nodiscard]] constexpr std::uint64_t mix_seed(std::uint64_t word) {
  return SplitMix64::mixed(word + SplitMix64::kStep);
}

/// A seed for one purpose, derived from another seed and a number: `mix(mix(seed, test), purpose)`.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t seed, std::uint64_t number) {
  return SplitMix64::mixed(mix_seed(seed) ^ (number + 0x632BE59BD9B4E019U));
}

/// The generator of java.util.Random, so that a program that sets its seed draws Jason's numbers.
class JavaRandom {
 public:
  explicit JavaRandom(std::int64_t seed) { set_seed(seed); }

  void set_seed(std::int64_t seed) {
    state_ = (static_cast<std::uint64_t>(seed) ^ kMultiplier) & kMask;
  }
  /// Uniform in [0, 1), 53 bits.
  double next_double() {
    const std::uint64_t high = next(26);
    const std::uint64_t low = next(27);
    return static_cast<double>((high << 27U) + low) * 0x1.0p-53;
  }
  /// Uniform in 0 ... bound-1. REQUIRES: bound > 0.
  std::int32_t next_int(std::int32_t bound) {
    auto bits = static_cast<std::int32_t>(next(31));
    const std::int32_t least = bound - 1;
    if ((bound & least) == 0) {
      return static_cast<std::int32_t>((static_cast<std::int64_t>(bound) * bits) >> 31);
    }
    std::int32_t value = bits % bound;
    // Numbers of the last, incomplete range are drawn again.
    while (static_cast<std::int64_t>(bits) - value + least > INT32_MAX) {
      bits = static_cast<std::int32_t>(next(31));
      value = bits % bound;
    }
    return value;
  }

 private:
  static constexpr std::uint64_t kMultiplier = 0x5DEECE66DU;
  static constexpr std::uint64_t kMask = (std::uint64_t{1} << 48U) - 1;

  std::uint64_t next(unsigned bits) {
    state_ = (state_ * kMultiplier + 0xBU) & kMask;
    return state_ >> (48U - bits);
  }

  std::uint64_t state_ = 0;
};

}  // namespace jaywalk
