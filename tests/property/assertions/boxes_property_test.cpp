// SPDX-License-Identifier: Apache-2.0
// Random boxes on random ways: they touch if and only if their smallest distance is 0.

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "experiment/judge/signals/boxes.h"

namespace jaywalk {
namespace {

TEST(BoxesOnTheirWay, TouchIfTheirSmallestDistanceIsZero) {
  std::mt19937 random(11);
  const auto between = [&](double from, double to) {
    return std::uniform_real_distribution(from, to)(random);
  };
  const auto actor = [&] {
    Actor result;
    result.length_m = between(0.3, 12);
    result.width_m = between(0.3, 3);
    return result;
  };
  const auto state = [&] {
    ActorState result;
    result.x_m = between(-8, 8);
    result.y_m = between(-8, 8);
    result.heading_rad = between(0, 2 * std::numbers::pi);
    return result;
  };
  int touching = 0;
  constexpr int kPairs = 20'000;
  for (int i = 0; i < kPairs; ++i) {
    const Actor fixed = actor();
    const Actor moving = actor();
    const Movement first{state(), state()};
    const Movement second{state(), state()};
    const bool meet = closest_m(fixed, first, moving, second) <= 0;
    ASSERT_EQ(touch(fixed, first, moving, second), meet) << "pair " << i;
    touching += meet ? 1 : 0;
  }
  EXPECT_GT(touching, kPairs / 10);
  EXPECT_LT(touching, kPairs - kPairs / 10);
}

}  // namespace
}  // namespace jaywalk
