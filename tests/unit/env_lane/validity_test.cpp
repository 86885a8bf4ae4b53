// SPDX-License-Identifier: Apache-2.0
#include "env/lane/validity.h"

#include <gtest/gtest.h>

#include "interpreter/support/random.h"
#include "tests/unit/env_lane/data.h"

namespace jaywalk::lane {
namespace {

TEST(Validity, IsTheCompetitionsOnEveryRoadOfTheReference) {
  const std::vector<JudgedRoad> roads = judged_roads();
  ASSERT_EQ(roads.size(), 2500U);
  std::size_t number = 0;
  for (const JudgedRoad& road : roads) {
    const RoadVerdict verdict = validate(road.points);
    ASSERT_TRUE(verdict.road) << "road " << number;
    EXPECT_EQ(verdict.message, road.message) << "road " << number << " of " << road.family;
    EXPECT_EQ(verdict.road->middle.size(), road.interpolated) << "road " << number;
    ++number;
  }
}

// The short way to the verdict alone, on the same roads and on those of four other scales, so that
// each rule is the first one broken.
TEST(Validity, IsFoundWithoutTheMessageAlike) {
  std::size_t valid = 0;
  for (const JudgedRoad& road : judged_roads()) {
    for (const double scale : {0.1, 0.25, 0.5, 1.0, 1.2}) {
      Polyline points = road.points;
      for (Point& point : points) point = {scale * point.x_m, scale * point.y_m};
      const bool is = is_valid(points);
      EXPECT_EQ(is, validate(points).valid()) << "a road of " << road.family << " times " << scale;
      valid += is ? 1 : 0;
    }
  }
  EXPECT_GT(valid, 1000U);
  EXPECT_FALSE(is_valid({{100, 100}}));
  EXPECT_FALSE(is_valid({{50, 50}, {50, 50}, {90, 90}}));
  // Longer than the least length only by its bends, so that the interpolation is measured.
  const Polyline ring{{100, 60}, {140, 100}, {100, 140}, {62, 98}};
  EXPECT_EQ(is_valid(ring, {.least_length_m = 60}), validate(ring, {.least_length_m = 60}).valid());
  EXPECT_EQ(is_valid(ring, {.least_length_m = 600}),
            validate(ring, {.least_length_m = 600}).valid());
}

TEST(Validity, RefusesRoadsOfOnePointOrTooMany) {
  EXPECT_EQ(validate({{100, 100}}).message, "Not enough road points.");
  Polyline many;
  for (int i = 0; i < 501; ++i) many.push_back({100, 10 + 0.3 * i});
  EXPECT_EQ(validate(many).message, "The road definition contains too many points");
  many.pop_back();
  EXPECT_TRUE(validate(many).valid());
}

TEST(Validity, RefusesPointsThatCoincide) {
  EXPECT_EQ(validate({{50, 50}, {50, 50}, {90, 90}}).message, "ERROR ValueError: Invalid inputs.");
}

TEST(Validity, AcceptsARoadRightOfTheMapAsTheCompetitionDoes) {
  EXPECT_TRUE(validate({{250, 20}, {250, 150}}).valid());
  EXPECT_FALSE(validate({{-50, 20}, {-50, 150}}).valid());
}

double uniform(SplitMix64& random) { return static_cast<double>(random.next() >> 11U) * 0x1.0p-53; }

/// The share of valid roads among many that `make` draws.
template <class Make>
double valid_share(Make make) {
  constexpr int kRoads = 5000;
  SplitMix64 random(1);
  int valid = 0;
  for (int i = 0; i < kRoads; ++i) valid += validate(make(random)).valid() ? 1 : 0;
  return static_cast<double>(valid) / kRoads;
}

// Peltomäki et al. 2022, section 2.1: 0.48 of 5,000 roads; those are the dependent curvatures with
// which the experiments begin.
TEST(Validity, HoldsForHalfOfTheDependentCurvatureVectors) {
  const double share = valid_share([](SplitMix64& random) {
    std::vector<double> curvatures{0.07 * (2 * uniform(random) - 1)};
    while (curvatures.size() < 5) {
      curvatures.push_back(curvatures.back() + 0.05 * (2 * uniform(random) - 1));
    }
    return integrate(curvatures);
  });
  EXPECT_NEAR(share, 0.50, 0.02);
}

TEST(Validity, HoldsForThreeQuartersOfTheUniformCurvatureVectors) {
  const double share = valid_share([](SplitMix64& random) {
    std::vector<double> curvatures(5);
    for (double& each : curvatures) each = 0.07 * (2 * uniform(random) - 1);
    return integrate(curvatures);
  });
  EXPECT_NEAR(share, 0.75, 0.02);
}

// The paper's 0.0036.
TEST(Validity, HoldsForNearlyNoneOfSixUniformPoints) {
  const double share = valid_share([](SplitMix64& random) {
    Polyline points;
    for (int i = 0; i < 6; ++i) points.push_back({200 * uniform(random), 200 * uniform(random)});
    return points;
  });
  EXPECT_NEAR(share, 0.004, 0.003);
}

}  // namespace
}  // namespace jaywalk::lane
