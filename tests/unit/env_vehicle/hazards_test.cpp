// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/hazards.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "env/vehicle/careful_driver.h"
#include "env/vehicle/sight.h"

namespace jaywalk {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Strip kLane{3, 9};

SeenActor actor(unsigned id, double gap_m, double left_m, double ahead_mps = 0) {
  return {.id = id,
          .gap_m = gap_m,
          .left_m = left_m,
          .right_m = left_m + 0.5,
          .speed_ahead_mps = ahead_mps};
}

/// At 10 m/s, 0.1 s to the next decision.
VehicleView view_of(std::span<const SeenActor> actors, double time_s = 0) {
  return {.time_s = time_s,
          .period_s = 0.1,
          .speed_mps = 10,
          .cruise_mps = 10,
          .left_m = 4.5,
          .right_m = 7.5,
          .lane_left_m = 3,
          .lane_right_m = 9,
          .actors = actors,
          .stop_lines = {}};
}

TEST(IsOver, TakesMoreThanAnEdge) {
  EXPECT_FALSE(is_over(2.5, 3, kLane));
  EXPECT_TRUE(is_over(2.5, 3.01, kLane));
  EXPECT_TRUE(is_over(8.99, 9.5, kLane));
  EXPECT_FALSE(is_over(9, 9.5, kLane));
  EXPECT_TRUE(is_over(0, 20, kLane)) << "wider than the strip";
}

TEST(IsOver, CanAskWhereSomebodyWillBe) {
  SeenActor walker = actor(1, 20, 2);
  walker.speed_right_mps = 1;
  EXPECT_FALSE(is_over(walker, kLane, 0.5));
  EXPECT_TRUE(is_over(walker, kLane, 0.6));
  EXPECT_TRUE(is_over(walker, kLane, 6.9));
  EXPECT_FALSE(is_over(walker, kLane, 7));
}

TEST(IsRisk, EndsBesideTheFront) {
  EXPECT_TRUE(is_risk(actor(1, 0, 4), kLane));
  EXPECT_TRUE(is_risk(actor(1, -0.01, 4), kLane)) << "rounding";
  EXPECT_FALSE(is_risk(actor(1, -0.02, 4), kLane));
  EXPECT_FALSE(is_risk(actor(1, 10, 2), kLane));
}

TEST(ClosedLine, IsTheNearestAhead) {
  const std::vector<StopLine> lines{{30, true}, {20, true}, {10, false}, {-1.1, true}};
  VehicleView view = view_of({});
  EXPECT_FALSE(closed_line(view));
  view.stop_lines = lines;
  EXPECT_DOUBLE_EQ(closed_line(view)->gap_m, 20);
  EXPECT_DOUBLE_EQ(closed_line(view)->speed_mps, 0);
}

TEST(ClosedLine, StillHoldsAVehicleThatStandsALittleBeyond) {
  const std::vector<StopLine> lines{{-1, true}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_TRUE(closed_line(view));
}

TEST(Risks, AreRememberedSinceTheyBegan) {
  Risks risks;
  EXPECT_FALSE(risks.first_s());
  const std::vector<SeenActor> one{actor(7, 30, 4)};
  risks.look(view_of(one, 1), kLane);
  const std::vector<SeenActor> two{actor(7, 20, 4), actor(8, 25, 4)};
  risks.look(view_of(two, 2), kLane);
  EXPECT_EQ(risks.first_s(), 1);
  EXPECT_EQ(risks.all().at(8).since_s, 2);
  EXPECT_EQ(risks.all().at(7).hazard.gap_m, 20) << "where they are now";
}

TEST(Risks, BeginAnewForWhoLeftTheLane) {
  Risks risks;
  const std::vector<SeenActor> inside{actor(7, 30, 4)};
  const std::vector<SeenActor> outside{actor(7, 30, 1)};
  risks.look(view_of(inside, 1), kLane);
  risks.look(view_of(outside, 2), kLane);
  EXPECT_TRUE(risks.all().empty());
  risks.look(view_of(inside, 3), kLane);
  EXPECT_EQ(risks.first_s(), 3);
}

TEST(Risks, WhoComesTowardsTheVehicleCountsAsStanding) {
  Risks risks;
  const std::vector<SeenActor> people{actor(1, 30, 4, -2), actor(2, 30, 4, 2)};
  risks.look(view_of(people), kLane);
  EXPECT_EQ(risks.all().at(1).hazard.speed_mps, 0);
  EXPECT_EQ(risks.all().at(2).hazard.speed_mps, 2);
}

TEST(Perception, PerceivesTheNearestOfThoseWhoWereThereLongEnough) {
  Perception perception(0.5);
  const std::vector<SeenActor> first{actor(1, 40, 4)};
  const std::vector<SeenActor> both{actor(1, 40, 4), actor(2, 20, 4)};
  EXPECT_FALSE(perception.perceive(view_of(first, 0), kLane));
  EXPECT_FALSE(perception.perceive(view_of(both, 0.4), kLane));
  EXPECT_DOUBLE_EQ(perception.perceive(view_of(both, 0.5), kLane)->gap_m, 40);
  EXPECT_DOUBLE_EQ(perception.perceive(view_of(both, 0.9), kLane)->gap_m, 20);
}

TEST(Perception, SeesClosedLinesAtOnce) {
  Perception perception(0.5);
  const std::vector<StopLine> lines{{25, true}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_DOUBLE_EQ(perception.perceive(view, kLane)->gap_m, 25);
}

TEST(RequiredDeceleration, IsTheSquareOfTheClosingSpeedByTwiceTheRoom) {
  const VehicleView view = view_of({});
  EXPECT_DOUBLE_EQ(required_deceleration(view, {22, 0}, 2), 2.5);
  EXPECT_DOUBLE_EQ(required_deceleration(view, {22, 4}, 2), 0.9);
  EXPECT_EQ(required_deceleration(view, {22, 10}, 2), 0) << "as fast";
  EXPECT_EQ(required_deceleration(view, {22, 12}, 2), 0) << "faster";
  EXPECT_EQ(required_deceleration(view, {2, 0}, 2), kInf) << "no room left";
}

TEST(LineStop, BeginsWithComfortableBrakingAndGoesOnUntilTheLineOpens) {
  LineStop stop;
  std::vector<StopLine> lines{{30, true}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_FALSE(stop.braking(view, 8)) << "100 / 60 is less than 2 m/s2";
  lines[0].gap_m = 25;
  view.front_m = 5;
  EXPECT_DOUBLE_EQ(*stop.braking(view, 8), 2);
  lines[0].gap_m = 20;
  view.front_m = 10;
  view.speed_mps = 4;
  EXPECT_DOUBLE_EQ(*stop.braking(view, 8), 0.4) << "it has begun";
  lines[0].closed = false;
  EXPECT_FALSE(stop.braking(view, 8));
}

TEST(LineStop, BrakesNoHarderThanItCan) {
  LineStop stop;
  const std::vector<StopLine> lines{{5, true}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_DOUBLE_EQ(*stop.braking(view, 8), 8) << "10 m/s2 are needed";
}

TEST(LineStop, PerceivesEachLineByItself) {
  LineStop stop(1);
  std::vector<StopLine> lines{{20, true}, {60, false}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_FALSE(stop.braking(view, 8)) << "it has only just closed";
  view.time_s += 1;
  EXPECT_DOUBLE_EQ(*stop.braking(view, 8), 2.5);
  // It ran the first line, before the second closed.
  view.front_m = 45;
  lines = {{-25, true}, {15, true}};
  view.stop_lines = lines;
  EXPECT_FALSE(stop.braking(view, 8)) << "what it knew of the first line is not of the second";
  view.time_s += 0.9;
  EXPECT_FALSE(stop.braking(view, 8));
  view.time_s += 0.1;
  EXPECT_GT(*stop.braking(view, 8), 3);
}

TEST(LineStop, DoesNotBrakeForTheNextLineBecauseItBrakedForTheLast) {
  LineStop stop;
  std::vector<StopLine> lines{{5, true}, {45, true}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_TRUE(stop.braking(view, 8));
  view.front_m = 7;
  lines = {{-2, true}, {38, true}};
  view.stop_lines = lines;
  EXPECT_FALSE(stop.braking(view, 8)) << "100 / 76 is less than 2 m/s2";
}

TEST(LineStop, KnowsALineThatALateSensorSeesElsewhere) {
  LineStop stop(1);
  std::vector<StopLine> lines{{20, true}};
  VehicleView view = view_of({});
  view.stop_lines = lines;
  EXPECT_FALSE(stop.braking(view, 8));
  view.time_s += 1;
  lines[0].gap_m = 20.3;
  EXPECT_TRUE(stop.braking(view, 8));
}

TEST(Resume, ComesToTheCruisingSpeedWithoutOvershooting) {
  VehicleView view = view_of({});
  EXPECT_EQ(resume(view, 2), 0);
  view.speed_mps = 5;
  EXPECT_EQ(resume(view, 2), 2);
  view.speed_mps = 9.9;
  EXPECT_NEAR(resume(view, 2), 1, 1e-9) << "0.1 m/s in 0.1 s";
  view.speed_mps = 12;
  EXPECT_EQ(resume(view, 2), -2) << "who is too fast slows as gently";
}

TEST(DriveOn, MovesWithTheMeanOfBothSpeeds) {
  const Motion motion = drive_on(10, -2, 12, 0.5);
  EXPECT_DOUBLE_EQ(motion.speed, 8);
  EXPECT_DOUBLE_EQ(motion.way, 4.5);
}

TEST(DriveOn, StaysBetweenStandingAndTheHighestSpeed) {
  EXPECT_DOUBLE_EQ(drive_on(11, 5, 12, 1).speed, 12);
  EXPECT_DOUBLE_EQ(drive_on(11, 5, 12, 1).way, 11.5);
  // From 2 m/s at 4 m/s2 it stands after half of the second.
  const Motion stopped = drive_on(2, -4, 12, 1);
  EXPECT_EQ(stopped.speed, 0);
  EXPECT_DOUBLE_EQ(stopped.way, 0.5);
  EXPECT_EQ(drive_on(0, -1, 12, 1).way, 0);
}

TEST(PeriodsOf, AreNoLongerThanTheControllerAllows) {
  const CarefulDriver driver;
  EXPECT_EQ(periods_of(driver, 1), 20);
  EXPECT_EQ(periods_of(driver, 0.05), 1);
  EXPECT_EQ(periods_of(driver, 0.06), 2);
  EXPECT_EQ(periods_of(driver, 0.01), 1);
}

/// From a vehicle 4 m long whose front is at 100 m, and whose body is 4 m to 6 m from the left.
Sight looking(std::span<const Rectangle> obstacles = {}) {
  return {.body = {4, 6}, .front_m = 100, .length_m = 4, .range_m = 50, .obstacles = obstacles};
}

RoadUserBox box_at(double left, double near) {
  return {.id = 3, .box = {left, left + 0.5, near, near + 0.5}};
}

TEST(See, MeasuresFromTheFront) {
  const auto seen = see(looking(), {.id = 3,
                                    .kind = ActorKind::cyclist,
                                    .box = {1, 1.5, 120, 122},
                                    .speed_mps = 2,
                                    .heading_rad = std::numbers::pi / 6});
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->id, 3U);
  EXPECT_EQ(seen->kind, ActorKind::cyclist);
  EXPECT_DOUBLE_EQ(seen->gap_m, 20);
  EXPECT_DOUBLE_EQ(seen->left_m, 1);
  EXPECT_DOUBLE_EQ(seen->right_m, 1.5);
  EXPECT_DOUBLE_EQ(seen->length_m, 2);
  EXPECT_NEAR(seen->speed_ahead_mps, 1, 1e-12);
  EXPECT_NEAR(seen->speed_right_mps, std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(seen->heading_rad, std::numbers::pi / 3, 1e-12) << "clockwise from its way";
}

TEST(See, EndsAtTheRange) {
  EXPECT_TRUE(see(looking(), box_at(5, 150)));
  EXPECT_FALSE(see(looking(), box_at(5, 150.1)));
}

TEST(See, EndsBehindTheVehicle) {
  EXPECT_TRUE(see(looking(), box_at(8, 95.6))) << "its far side is at 96.1 m, beside the rear";
  EXPECT_FALSE(see(looking(), box_at(8, 95.5)));
}

TEST(See, DoesNotLookThroughObstacles) {
  const std::vector<Rectangle> car{{1, 3, 105, 109}};
  // From (5, 100) to (1.25, 112.25) the line is at x = 2.7 where the car begins.
  EXPECT_FALSE(see(looking(car), box_at(1, 112)));
  EXPECT_TRUE(see(looking(car), box_at(3.5, 112))) << "beside it";
  EXPECT_TRUE(see(looking(car), box_at(1, 104))) << "before it";
}

TEST(StandsBetween, NeedsMoreThanACorner) {
  const Rectangle square{0, 1, 0, 1};
  EXPECT_TRUE(stands_between(square, {-1, 0.5}, {2, 0.5}));
  EXPECT_FALSE(stands_between(square, {-1, 1}, {1, 3})) << "passes beside";
  EXPECT_FALSE(stands_between(square, {-1, 0}, {1, 2})) << "touches the corner at (0, 1)";
  EXPECT_FALSE(stands_between(square, {-2, 0.5}, {-1, 0.5})) << "ends before it";
  EXPECT_TRUE(stands_between(square, {0.5, 0.5}, {5, 5})) << "begins inside";
  EXPECT_FALSE(stands_between(square, {2, -1}, {2, 3})) << "parallel to its side";
}

TEST(Rectangle, OwnsItsLeftAndNearSides) {
  const Rectangle square{0, 1, 0, 1};
  EXPECT_TRUE(square.contains({0, 0}));
  EXPECT_FALSE(square.contains({1, 0}));
  EXPECT_FALSE(square.contains({0, 1}));
  EXPECT_FALSE(square.overlaps({1, 2, 0, 1})) << "neighbours do not overlap";
  EXPECT_TRUE(square.overlaps({0.9, 2, 0.9, 2}));
}

TEST(Rectangle, SurroundsPoints) {
  const std::vector<Point> points{{2, 5}, {-1, 7}, {0, 6}};
  const Rectangle around = surrounding(points);
  EXPECT_EQ(around.left, -1);
  EXPECT_EQ(around.right, 2);
  EXPECT_EQ(around.near, 5);
  EXPECT_EQ(around.far, 7);
  EXPECT_EQ(around.middle().x_m, 0.5);
  EXPECT_EQ(around.middle().y_m, 6);
}

}  // namespace
}  // namespace jaywalk
