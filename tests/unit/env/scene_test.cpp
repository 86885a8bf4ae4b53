// SPDX-License-Identifier: Apache-2.0
#include "env/scene.h"

#include <numbers>

#include <gtest/gtest.h>

#include "env/crossing/crossing.h"

namespace jaywalk {
namespace {

const Actor kCar{"av", ActorKind::vehicle, 4, 2};
constexpr double kAhead = std::numbers::pi / 2;

double distance(const ActorState& first, const ActorState& second) {
  return distance_m(box(kCar, first), box(kCar, second));
}

TEST(Scene, BoxesThatOverlapOrTouchHaveNoDistance) {
  EXPECT_DOUBLE_EQ(distance({0, 0, 0, 0}, {1, 1, 0, kAhead}), 0);
  EXPECT_DOUBLE_EQ(distance({0, 0, 0, 0}, {4, 0, 0, 0}), 0);
}

TEST(Scene, DistanceIsFromBoxToBox) {
  EXPECT_DOUBLE_EQ(distance({0, 0, 0, 0}, {7, 0, 0, 0}), 3);
  EXPECT_NEAR(distance({0, 0, 0, 0}, {7, 0, 0, kAhead}), 4, 1e-12);
  EXPECT_DOUBLE_EQ(distance({0, 0, 0, 0}, {7, 6, 0, 0}), 5) << "from corner to corner";
}

TEST(Scene, ABoxInsideAnotherHasNoDistance) {
  const Actor small{"p1", ActorKind::pedestrian, 0.5, 0.5};
  EXPECT_DOUBLE_EQ(distance_m(box(kCar, {}), box(small, {})), 0);
}

TEST(Scene, TheAvOfTheCrossingLiesBehindItsLeadingEdge) {
  SymbolTable symbols;
  const CrossingVocabulary vocabulary(symbols);
  const CrossingParameters parameters;
  Crossing crossing(parameters, vocabulary, {{1, 12}, {10, 40}});
  ASSERT_EQ(crossing.actors().size(), 3U);
  EXPECT_EQ(crossing.actors()[0], (Actor{"av", ActorKind::vehicle, 4.5, 3}));
  crossing.advance();
  const Scene scene = crossing.scene();
  // Rows 3 and 4 of 1.5 m; the edge is cell 6, whose far side is at 10.5 m.
  EXPECT_DOUBLE_EQ(scene[0].x_m, 6);
  EXPECT_DOUBLE_EQ(scene[0].y_m, 10.5 - 2.25);
  EXPECT_DOUBLE_EQ(scene[0].speed_mps, 9);
  EXPECT_DOUBLE_EQ(scene[1].x_m, 2.25);
  EXPECT_DOUBLE_EQ(scene[1].y_m, 18.75);
  EXPECT_DOUBLE_EQ(scene[1].speed_mps, 0);
  EXPECT_DOUBLE_EQ(scene[1].heading_rad, 0) << "it looks at the road";
  EXPECT_DOUBLE_EQ(scene[2].heading_rad, std::numbers::pi);
}

}  // namespace
}  // namespace jaywalk
