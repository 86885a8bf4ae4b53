// SPDX-License-Identifier: Apache-2.0
// Goes through the whole space of vectors, each point once, so that a point that it does not find
// does not exist: all values of discrete dimensions, a raster of continuous ones. The order is
// fixed, and spreads over the space from the first test on: a step is the golden section of all
// points, so that a search that ends early has seen something of every part.

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "search/generator.h"

namespace jaywalk::search::generator::exhaustive {
namespace {

constexpr std::array kParameters = {
    NumberParameter{"raster", 5, 1, 1000,
                    "values of a continuous range, both of its ends included"},
};

/// Nobody lives to see the end of more.
constexpr std::uint64_t kMostPoints = std::numeric_limits<std::uint64_t>::max() / 4;

/// A point of the space by its place in the order.
struct Walk {
  std::uint64_t at = 0;
  std::uint64_t seen = 0;
};

class AllVectors : public Generator {
 public:
  explicit AllVectors(const GeneratorSetup& setup)
      : space_(setup.space), distinct_(setup.space.distinct_values()) {
    const auto raster = static_cast<std::uint64_t>(std::llround(setup.values[0]));
    for (const std::size_t values : distinct_) {
      const std::uint64_t count = values == 0 ? raster : values;
      // Further parameters keep the middle of their range.
      counts_.push_back(points_ > kMostPoints / count ? 1 : count);
      points_ *= counts_.back();
    }
    step_ = static_cast<std::uint64_t>(static_cast<double>(points_) / std::numbers::phi);
    while (std::gcd(step_, points_) != 1) ++step_;
  }

  [[nodiscard]] bool exhausted() const override { return exhausted_; }

  TestInput ask(Asking& asking) override {
    // If there are none but invalid ones, the search says so of the last one.
    (void)go_to_valid(walk_, [&](const TestInput& input) { return asking.valid(input); });
    TestInput input = point(walk_);
    advance(walk_);
    exhausted_ = walk_.seen == points_ || !has_more();
    return input;
  }

  void tell(const ExecutedTest&, double) override {}

 private:
  void advance(Walk& walk) const {
    ++walk.seen;
    walk.at = (walk.at + step_) % points_;
  }

  /// On to the next valid point; false if there is none, or not within very many.
  template <class Valid>
  [[nodiscard]] bool go_to_valid(Walk& walk, Valid valid) const {
    for (int i = 0; i < kMostDraws; ++i) {
      if (valid(point(walk))) return true;
      if (walk.seen + 1 >= points_) return false;
      advance(walk);
    }
    return false;
  }

  [[nodiscard]] bool has_more() const {
    Walk ahead = walk_;
    return go_to_valid(ahead, [&](const TestInput& input) { return space_.contains(input); }) ||
           ahead.seen + 1 < points_;
  }

  [[nodiscard]] TestInput point(const Walk& walk) const {
    TestInput input{Form::vector, {}};
    std::uint64_t rest = walk.at;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      input.values.push_back(value(i, rest % counts_[i]));
      rest /= counts_[i];
    }
    return input;
  }

  /// From -1 to 1: the middle of a part, or a point of the raster.
  [[nodiscard]] double value(std::size_t dimension, std::uint64_t index) const {
    const auto count = static_cast<double>(counts_[dimension]);
    const auto place = static_cast<double>(index);
    if (counts_[dimension] == 1) return 0;
    if (distinct_[dimension] == 0) return 2 * place / (count - 1) - 1;
    return (2 * place + 1) / count - 1;
  }

  const SearchSpace& space_;
  std::vector<std::size_t> distinct_;
  /// How many values of each dimension are tried.
  std::vector<std::uint64_t> counts_;
  std::uint64_t points_ = 1;
  std::uint64_t step_ = 1;
  Walk walk_;
  bool exhausted_ = false;
};

}  // namespace

std::span<const NumberParameter> parameters() { return kParameters; }

std::unique_ptr<Generator> make(const GeneratorSetup& setup) {
  return std::make_unique<AllVectors>(setup);
}

}  // namespace jaywalk::search::generator::exhaustive
