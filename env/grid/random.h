#pragma once

// A small, fast, portable source of random numbers: SplitMix64 (Steele, Lea and Flood, 2014). The
// same seed gives the same numbers on every machine, which the standard distributions do not.

#include <cassert>
#include <cstdint>

namespace jaywalk {

class SplitMix64 {
 public:
  explicit constexpr SplitMix64(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] constexpr std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
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

/// A seed for one purpose, derived from another seed and a number: `mix(mix(seed, test), purpose)`.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t seed, std::uint64_t number) {
  return SplitMix64::mixed(SplitMix64::mixed(seed + 0x9E3779B97F4A7C15U) ^
                           (number + 0x632BE59BD9B4E019U));
}

}  // namespace jaywalk
