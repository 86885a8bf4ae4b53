#pragma once

// Sources of random numbers. Each agent and each test has its own, seeded from the experiment's
// seed; there is no global one.

#include <cstdint>

namespace jaywalk {

/// Mixes a word so that neighbouring inputs give unrelated outputs (Steele, Lea, Flood 2014,
/// "Fast splittable pseudorandom number generators"). Seeds derive from seeds through it.
[[nodiscard]] constexpr std::uint64_t mix_seed(std::uint64_t word) {
  word += 0x9E3779B97F4A7C15U;
  word = (word ^ word >> 30U) * 0xBF58476D1CE4E5B9U;
  word = (word ^ word >> 27U) * 0x94D049BB133111EBU;
  return word ^ word >> 31U;
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
