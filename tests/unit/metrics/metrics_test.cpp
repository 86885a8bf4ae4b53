// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/metrics/metrics.h"

#include <gtest/gtest.h>

#include "env/vehicle/careful_driver.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

std::optional<MetricValue> value_of(std::string_view metric, const Recording& recording) {
  const Ground ground = road();
  return measured(*find_metric(metric), TestView(recording, ground));
}

double number(std::string_view metric, const Recording& recording) {
  const auto value = value_of(metric, recording);
  EXPECT_TRUE(value) << metric;
  return value ? value->value : -1;
}

TEST(Metrics, MinimumDistanceLiesBetweenTicksAndSoDoesItsTime) {
  const Recording past = drive(1, {{{0, 0}, {0, 20}, {0, 40}}, steps({3, 10}, {0, 0}, 3)});
  const auto least = value_of("min_distance", past);
  ASSERT_TRUE(least);
  EXPECT_NEAR(least->value, 1.75, 1e-12);
  EXPECT_EQ(least->tick, 1U);
  EXPECT_EQ(least->actor, 1U);
  // The front comes beside its near side after 7.75 of 20 m.
  EXPECT_NEAR(number("min_distance_time", past), 0.3875, 1e-6);
  const Recording over = drive(0.5, {{{0, 0}, {0, 20}, {0, 40}}, steps({0, 30}, {0, 0}, 3)});
  EXPECT_EQ(number("min_distance", over), 0);
  EXPECT_NEAR(number("min_distance_time", over), 0.5 * 27.75 / 20, 1e-9);
}

TEST(Metrics, TheTestsValueIsTheWorstRoadUsers) {
  const Recording two =
      drive(1, {steps({0, 0}, {0, 10}, 3), steps({9, 10}, {0, 0}, 3), steps({3, 10}, {0, 0}, 3)});
  EXPECT_EQ(value_of("min_distance", two)->actor, 2U);
  EXPECT_NEAR(value_of("min_distance", two)->value, 1.75, 1e-12);
  const Recording later =
      drive(1, {steps({0, 0}, {0, 10}, 4), steps({9, 6}, {0, 0}, 4), steps({3, 26}, {0, 0}, 4)});
  EXPECT_NEAR(number("min_distance_time", later), 2.375, 1e-6) << "of the one who comes nearest";
}

TEST(Metrics, TimeToCollisionIsExposedAndIntegrated) {
  // 10 m before the pedestrian at 5 m/s, ticks of 0.5 s: TTC 2, 1.5, 1, 0.5, 0.
  const Recording approach = drive(0.5, {steps({0, 0}, {0, 2.5}, 5), steps({0, 12.25}, {0, 0}, 5)});
  EXPECT_EQ(number("min_ttc", approach), 0);
  EXPECT_EQ(value_of("min_ttc", approach)->tick, 4U);
  EXPECT_DOUBLE_EQ(number("tet", approach), 1.5);
  EXPECT_DOUBLE_EQ(number("tit", approach), 0.5 * (0 + 0.5 + 1));
  EXPECT_EQ(value_of("tet", approach)->tick, 2U);
  EXPECT_FALSE(value_of("min_ttc", moment(10, {5, 0}, {0, 0}))) << "no collision course";
}

TEST(Metrics, EncroachmentTimeIsSpentInTheSwathOfTheAv) {
  // It stands, then walks 5 m/s from tick 3 on: in the AV's way from 3.75 s to 4.25 s.
  std::vector<Place> way = steps({-5, 12}, {0, 0}, 4);
  for (const Place& place : steps({0, 12}, {5, 0}, 3)) way.push_back(place);
  const Recording after = drive(1, {steps({0, 0}, {0, 10}, 7), way});
  EXPECT_NEAR(number("encroachment_time", after), 0.5, 1e-9);
  EXPECT_EQ(value_of("encroachment_time", after)->tick, 3U);
  // The AV has left that part of its way at 1.425 s.
  EXPECT_NEAR(number("pet", after), 3.75 - 1.425, 1e-9);
}

TEST(Metrics, PostEncroachmentTimeCountsWhoeverIsSecond) {
  // Walks from the beginning: inside from 0.75 s to 1.25 s; at 5 m/s the AV comes at 1.95 s.
  const Recording before = drive(1, {steps({0, 0}, {0, 5}, 6), steps({-5, 12}, {5, 0}, 6)});
  EXPECT_NEAR(number("pet", before), 1.95 - 1.25, 1e-9);
  // At 10 m/s it comes at 0.975 s: both inside together.
  EXPECT_FALSE(value_of("pet", drive(1, {steps({0, 0}, {0, 10}, 6), steps({-5, 12}, {5, 0}, 6)})));
  // Nobody crosses the AV's way.
  EXPECT_FALSE(value_of("pet", drive(1, {steps({0, 0}, {0, 5}, 6), steps({-5, 12}, {0, 1}, 6)})));
}

TEST(Metrics, PostEncroachmentTimeTakesEachCrossingByItself) {
  // It crosses to and fro: first 0.75 s to 1.25 s, then 3.75 s to 4.25 s; the AV comes at
  // (11.75 - 2 + 15) / 10 = 2.475 s and goes at 2.925 s.
  const Recording twice =
      drive(1, {steps({0, -15}, {0, 10}, 7),
                {{-5, 12}, {0, 12}, {5, 12}, {5, 12}, {0, 12}, {-5, 12}, {-5, 12}}});
  EXPECT_NEAR(number("pet", twice), 3.75 - 2.925, 1e-9);
}

TEST(Metrics, WhoIsStillInsideHasNoEncroachmentTime) {
  EXPECT_FALSE(value_of("encroachment_time",
                        drive(1, {steps({0, 0}, {0, 10}, 2), steps({-5, 12}, {5, 0}, 2)})));
}

TEST(Metrics, OfAPredictionAreItsWorstTick) {
  const Recording ahead = drive(1, {steps({0, 0}, {0, 10}, 2), steps({0, 22.25}, {0, 0}, 2)});
  EXPECT_DOUBLE_EQ(number("max_drac", ahead), 5) << "10 m before it";
  EXPECT_EQ(value_of("max_drac", ahead)->tick, 1U);
  EXPECT_NEAR(number("max_btn", ahead), 5 / kCompetentBrakingMps2, 1e-12);
  EXPECT_NEAR(number("min_ttb", ahead), 1 - 10 / (2 * kCompetentBrakingMps2), 1e-12);
  EXPECT_DOUBLE_EQ(number("min_pret", moment(10, {-5, 12}, {2.5, 0})), 0.8);
}

TEST(Metrics, ImpactSpeedNeedsACollision) {
  EXPECT_FALSE(value_of("impact_speed", moment(10, {5, 12}, {0, 0})));
  const Recording over = drive(1, {steps({0, 0}, {0, 20}, 2), steps({0, 10}, {0, 0}, 2)});
  EXPECT_DOUBLE_EQ(number("impact_speed", over), 20);
  EXPECT_EQ(value_of("impact_speed", over)->tick, 1U);
}

TEST(Metrics, TimeInRoadIsSpentOnLanes) {
  const Recording crossing = drive(0.5, {steps({0, 0}, {0, 5}, 6), steps({-4, 90}, {3, 0}, 6)});
  EXPECT_DOUBLE_EQ(number("time_in_road", crossing), 4 * 0.5);
}

TEST(Metrics, OfATestWithoutRoadUsersDoNotExist) {
  const Recording alone = drive(1, {steps({0, 0}, {0, 10}, 3)});
  const Ground ground = road();
  for (const auto& value : measured_all(TestView(alone, ground))) EXPECT_FALSE(value);
}

}  // namespace
}  // namespace jaywalk
