// SPDX-License-Identifier: Apache-2.0
// How roads turn around their failures.

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/generators/sites.h"

namespace jaywalk::search {
namespace {

using testing::DoubleNear;
using testing::Each;

/// `count` points 10 m apart, each of which turns the road by `degrees`.
TestInput bend(int count, double degrees) {
  TestInput points{Form::points, {0, 0}};
  double heading = 0;
  for (int i = 1; i < count; ++i) {
    points.values.push_back(points.values[points.values.size() - 2] + 10 * std::cos(heading));
    points.values.push_back(points.values[points.values.size() - 2] + 10 * std::sin(heading));
    heading += degrees * std::numbers::pi / 180;
  }
  return points;
}

Turns turns(int count, double degrees, double place) {
  return turns_near({{}, place}, bend(count, degrees), 10);
}

TEST(Turns, AreThoseOfTheRoadWithinThirtyMetres) {
  EXPECT_THAT(turns(20, 20, 10), Each(DoubleNear(2, 1e-9)));
  EXPECT_EQ(turns(20, 20, 10).size(), 12U);
  EXPECT_EQ(turns(20, 20, 1).size(), 8U) << "10 m before it and 30 m after";
  EXPECT_EQ(turns(5, 20, 3).size(), 8U) << "30 m before it and 10 m after";
  EXPECT_TRUE(turns(2, 0, 1).empty());
}

TEST(Turns, DifferAsTheCompetitionWeighsIt) {
  const Turns left(12, 1.0);
  EXPECT_EQ(turns_distance(left, left), 0);
  EXPECT_DOUBLE_EQ(turns_distance(left, Turns(12, -1.0)), 60 * (2.0 / 3) / 2);
  EXPECT_DOUBLE_EQ(turns_distance(left, Turns(9, 1.0)), 15) << "three pieces of 5 m to insert";
  EXPECT_DOUBLE_EQ(turns_distance(left, {}), 60);
}

TEST(KnownTurns, GainByWhatIsUnlikeAllOfThem) {
  KnownTurns known;
  EXPECT_EQ(known.gain(Turns(12, 1.0)), 0);
  known.add(Turns(12, 1.0));
  known.add(Turns(12, 1.0));
  EXPECT_EQ(known.gain(Turns(12, 1.0)), 0);
  // 15 for each of the two, and its own 15.
  EXPECT_DOUBLE_EQ(known.gain(Turns(9, 1.0)), 45);
  known.add(Turns(9, 1.0));
  EXPECT_DOUBLE_EQ(known.gain(Turns(9, 1.0)), 0)
      << "it has nothing to add, and the mean is its own";
}

}  // namespace
}  // namespace jaywalk::search
