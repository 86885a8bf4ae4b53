// SPDX-License-Identifier: Apache-2.0
#include "env/lane/path.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/lane/controllers/path_follower.h"

namespace jaywalk::lane {
namespace {

/// So many points a metre apart along x.
Path straight(std::size_t points) {
  Polyline line;
  for (std::size_t i = 0; i < points; ++i) line.push_back({static_cast<double>(i), 0});
  return Path(line);
}

/// About a point a metre of a circle, to the left if the radius is positive.
Path circle(double radius, int points = 60) {
  Polyline line;
  for (int i = 0; i < points; ++i) {
    const double angle = i / std::fabs(radius);
    line.push_back({std::fabs(radius) * std::sin(angle), radius * (1 - std::cos(angle))});
  }
  return Path(line);
}

TEST(Path, MeasuresItsLengthFromTheBeginning) {
  const Path path({{0, 0}, {3, 4}, {3, 10}});
  EXPECT_EQ(path.size(), 3U);
  EXPECT_DOUBLE_EQ(path.arc_m(0), 0);
  EXPECT_DOUBLE_EQ(path.arc_m(1), 5);
  EXPECT_DOUBLE_EQ(path.arc_m(2), 11);
}

TEST(Path, HeadsForItsNextPoint) {
  const Path path({{0, 0}, {1, 1}, {1, 5}});
  EXPECT_DOUBLE_EQ(path.heading(0), std::numbers::pi / 4);
  EXPECT_DOUBLE_EQ(path.heading(1), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(path.heading(2), path.heading(1)) << "the last goes on as the one before";
}

TEST(Path, IsCurvedAsItsCircleAndPositiveToTheLeft) {
  EXPECT_NEAR(circle(20).curvature(30), 0.05, 1e-4);
  EXPECT_NEAR(circle(-20).curvature(30), -0.05, 1e-4);
  EXPECT_EQ(straight(9).curvature(4), 0);
}

TEST(Path, IsCurvedAlikeAcrossTheJumpOfAngles) {
  // A full circle: headings run through pi.
  const Path path = circle(8, 50);
  for (std::size_t i = 2; i + 4 < path.size(); ++i) {
    EXPECT_NEAR(path.curvature(i), 0.125, 1e-3) << i;
  }
}

TEST(Path, FindsItsNearestPointAheadAndBehind) {
  const Path path = straight(20);
  EXPECT_EQ(path.nearest({7.2, 3}, 0), 7U);
  EXPECT_EQ(path.nearest({7.2, 3}, 15), 7U);
  EXPECT_EQ(path.nearest({-5, 0}, 4), 0U);
  EXPECT_EQ(path.nearest({500, 0}, 4), 19U);
}

TEST(Path, FindsALocalMinimumOnly) {
  // There and back: from the far end the way back is nearer, from the beginning the way there.
  Polyline line;
  for (int i = 0; i <= 20; ++i) line.push_back({static_cast<double>(i), 0});
  for (int i = 20; i >= 0; --i) line.push_back({static_cast<double>(i), 6});
  const Path path(line);
  EXPECT_EQ(path.nearest({5, 3.5}, 4), 5U);
  EXPECT_EQ(path.nearest({5, 3.5}, 38), 36U);
}

TEST(Path, KnowsWhichPointIsSoFarAhead) {
  const Path path = straight(20);
  EXPECT_EQ(path.ahead(3, 5), 8U);
  EXPECT_EQ(path.ahead(3, 4.5), 8U) << "at least as far";
  EXPECT_EQ(path.ahead(3, 0), 3U);
  EXPECT_EQ(path.ahead(3, 100), 19U) << "the last one";
}

TEST(Path, MeasuresDistancesFromItsStretches) {
  const Path path = straight(20);
  EXPECT_DOUBLE_EQ(path.distance_m({7.5, 2}, 7), 2) << "between two points";
  EXPECT_DOUBLE_EQ(path.distance_m({-3, 4}, 0), 5) << "beyond its beginning";
  EXPECT_DOUBLE_EQ(path.distance_m({22, 4}, 19), 5);
}

TEST(Wrapped, IsTheSameAngleWithinHalfATurn) {
  for (double angle = -20; angle < 20; angle += 0.37) {
    const double within = wrapped(angle);
    EXPECT_LE(std::fabs(within), std::numbers::pi);
    EXPECT_NEAR(std::sin(within), std::sin(angle), 1e-12);
    EXPECT_NEAR(std::cos(within), std::cos(angle), 1e-12);
  }
}

constexpr SpeedPlanParameters kPlan{.speed_limit_mps = 20,
                                    .lateral_acceleration = 5,
                                    .braking = 4,
                                    .preview_m = 30,
                                    .gain = 2,
                                    .most_acceleration = 6,
                                    .most_braking = 8};

TEST(SpeedPlan, OnAStraightRoadKeepsTheLimit) {
  const Path path = straight(60);
  const SpeedPlan plan(path, kPlan);
  EXPECT_DOUBLE_EQ(plan.acceleration(path, 0, 20), 0);
  EXPECT_DOUBLE_EQ(plan.acceleration(path, 0, 19), 2) << "the gain times a metre per second";
  EXPECT_DOUBLE_EQ(plan.acceleration(path, 0, 21), -2);
}

TEST(SpeedPlan, StaysWithinItsBounds) {
  const Path path = straight(60);
  const SpeedPlan plan(path, kPlan);
  EXPECT_DOUBLE_EQ(plan.acceleration(path, 0, 0), 6);
  EXPECT_DOUBLE_EQ(plan.acceleration(path, 0, 50), -8);
}

TEST(SpeedPlan, DrivesCurvesAtTheirLateralAcceleration) {
  const Path path = circle(20);
  const SpeedPlan plan(path, kPlan);
  const double allowed = std::sqrt(5.0 * 20);
  EXPECT_NEAR(plan.acceleration(path, 30, allowed), 0, 0.05);
  EXPECT_LT(plan.acceleration(path, 30, allowed + 1), -1);
}

TEST(SpeedPlan, AcceleratesLessWhereTheTyresAreUsedForTheCurve) {
  const Path path = circle(20);
  const SpeedPlan plan(path, kPlan);
  // At 5 m/s a quarter of the lateral acceleration is used: 25 / 20 of 5.
  EXPECT_NEAR(plan.acceleration(path, 30, 5), 6 * std::sqrt(1 - 1.0 / 16), 0.01);
}

/// Straight for `metres` metres, then a curve with a radius of 10 m.
Path bend_after(int metres) {
  Polyline line;
  for (int i = 0; i < metres; ++i) line.push_back({static_cast<double>(i), 0});
  for (int i = 0; i < 30; ++i) {
    const double angle = i / 10.0;
    line.push_back({metres + 10 * std::sin(angle), 10 - 10 * std::cos(angle)});
  }
  return Path(line);
}

TEST(SpeedPlan, BrakesForACurveInSight) {
  const Path path = bend_after(20);
  const SpeedPlan plan(path, kPlan);
  EXPECT_LT(plan.acceleration(path, 0, 18), -4) << "as planned, or harder";
  EXPECT_GT(plan.acceleration(path, 0, 8), 0) << "slow enough already";
}

TEST(SpeedPlan, DoesNotSeeBeyondItsPreview) {
  // The curve, 40 m ahead, allows sqrt(5 * 10 + 2 * 4 * 40) = 19.2 m/s here.
  const Path path = bend_after(40);
  EXPECT_GT(SpeedPlan(path, kPlan).acceleration(path, 0, 19.5), 0);
  SpeedPlanParameters far = kPlan;
  far.preview_m = 60;
  EXPECT_LT(SpeedPlan(path, far).acceleration(path, 0, 19.5), 0);
}

TEST(SpeedPlan, BrakesEarlierTheSlowerItsActuatorsAre) {
  const Path path = bend_after(25);
  SpeedPlanParameters late = kPlan;
  late.latency_s = 0.5;
  const double prompt = SpeedPlan(path, kPlan).acceleration(path, 0, 15);
  EXPECT_LT(SpeedPlan(path, late).acceleration(path, 0, 15), prompt);
}

}  // namespace
}  // namespace jaywalk::lane
