// SPDX-License-Identifier: Apache-2.0
// Single decisions of the models of vehicles, worked out by hand.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "env/vehicle/careful_driver.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {
namespace {

/// A vehicle in its lane, 3 m to 9 m from the left.
class Decisions {
 public:
  explicit Decisions(std::unique_ptr<VehicleController> controller)
      : controller_(std::move(controller)) {}

  /// Somebody 0.5 m wide is that far ahead.
  double with_person(double time_s, double gap_m, double left_m = 5, double right_mps = 0,
                     double ahead_mps = 0) {
    const std::vector<SeenActor> people{{.id = 1,
                                         .gap_m = gap_m,
                                         .left_m = left_m,
                                         .right_m = left_m + 0.5,
                                         .speed_ahead_mps = ahead_mps,
                                         .speed_right_mps = right_mps}};
    return decide(time_s, people, {});
  }
  double alone(double time_s) { return decide(time_s, {}, {}); }
  double with_line(double time_s, double gap_m) {
    const std::vector<StopLine> lines{{gap_m, true}};
    return decide(time_s, {}, lines);
  }

  double speed_mps = 10;
  double period_s = 0.05;

 private:
  double decide(double time_s, std::span<const SeenActor> actors, std::span<const StopLine> lines) {
    return controller_
        ->decide({.time_s = time_s,
                  .period_s = period_s,
                  .speed_mps = speed_mps,
                  .cruise_mps = 10,
                  .left_m = 4.5,
                  .right_m = 7.5,
                  .lane_left_m = 3,
                  .lane_right_m = 9,
                  .actors = actors,
                  .stop_lines = lines})
        .acceleration_mps2;
  }

  std::unique_ptr<VehicleController> controller_;
};

TEST(ConstantModel, NeedsNoController) { EXPECT_EQ(make_constant({}), nullptr); }

TEST(BrakingModel, BrakesAsHardAsItMust) {
  Decisions braking(make_braking({.reaction_s = 0}));
  EXPECT_DOUBLE_EQ(braking.with_person(0, 22), -2.5) << "100 / (2 * (22 - 2))";
  EXPECT_DOUBLE_EQ(braking.with_person(0.05, 7), -6) << "10 m/s2 are more than it can";
}

TEST(BrakingModel, RollsTowardsWhomItDoesNotYetBrakeFor) {
  Decisions braking(make_braking({.reaction_s = 0}));
  braking.speed_mps = 8;
  EXPECT_DOUBLE_EQ(braking.with_person(0, 100), 0) << "it gathers no speed";
  EXPECT_DOUBLE_EQ(braking.alone(0.05), 2) << "it does on a free road";
}

TEST(BrakingModel, EndsBrakingWhereHalfOfWhatBeganItIsEnough) {
  Decisions braking(make_braking({.reaction_s = 0}));
  EXPECT_LT(braking.with_person(0, 22), -2);
  braking.speed_mps = 7;
  EXPECT_DOUBLE_EQ(braking.with_person(1, 22), -49.0 / 40) << "1.225 m/s2: it goes on";
  braking.speed_mps = 6;
  EXPECT_DOUBLE_EQ(braking.with_person(2, 22), 0) << "0.9 m/s2";
  braking.speed_mps = 7;
  EXPECT_DOUBLE_EQ(braking.with_person(3, 22), 0) << "and does not begin again below 2 m/s2";
}

TEST(BrakingModel, HasItsOwnStandoff) {
  Decisions braking(make_braking({.reaction_s = 0, .standoff_m = 12}));
  EXPECT_DOUBLE_EQ(braking.with_person(0, 22), -5);
}

TEST(EmergencyBrakingModel, ActsBelowItsTimeToCollision) {
  Decisions aeb(make_aeb({}));
  EXPECT_EQ(aeb.with_person(0, 11.01), 0) << "1.101 s";
  EXPECT_EQ(aeb.with_person(0.05, 10.99), -9);
}

TEST(EmergencyBrakingModel, PredictsWhoWalksIntoItsPath) {
  Decisions aeb(make_aeb({}));
  // At 1.5 m/s from 3 m to 4.5 m in the second until the AV is there: over the path from 4.2 m on.
  EXPECT_EQ(aeb.with_person(0, 10, 3, 1.5), -9);
  EXPECT_EQ(aeb.with_person(0.05, 10, 3, 0.5), 0) << "at 4 m by then";
  EXPECT_EQ(aeb.with_person(0.1, 10, 7, 1.5), -9) << "who leaves it is in it now";
}

TEST(EmergencyBrakingModel, StaysWhileSomebodyIsRightBeforeIt) {
  Decisions aeb(make_aeb({}));
  aeb.speed_mps = 0;
  EXPECT_EQ(aeb.with_person(0, 9.9), -9);
  EXPECT_EQ(aeb.with_person(0.05, 10.1), 2) << "farther than its cruising speed lasts a second";
  EXPECT_EQ(aeb.with_person(0.1, 9.9, 1), 2) << "beside its path";
}

TEST(EmergencyBrakingModel, DoesNotActForWhoIsFaster) {
  Decisions aeb(make_aeb({}));
  EXPECT_EQ(aeb.with_person(0, 5, 5, 0, 10), 0);
  EXPECT_EQ(aeb.with_person(0.05, -0.5), 0) << "nor for who is beside its front";
}

TEST(EmergencyBrakingModel, WaitsForItsReactionWithoutGatheringSpeed) {
  Decisions aeb(make_aeb({.reaction_s = 0.3}));
  aeb.speed_mps = 8;
  EXPECT_EQ(aeb.with_person(1, 5), 0);
  EXPECT_EQ(aeb.with_person(1.25, 5), 0);
  EXPECT_EQ(aeb.with_person(1.3, 5), -9);
  EXPECT_EQ(aeb.alone(1.35), 2);
  EXPECT_EQ(aeb.with_person(1.4, 5), 0) << "a new threat";
}

TEST(EmergencyBrakingModel, StopsAtLinesAsAnyDriver) {
  Decisions aeb(make_aeb({}));
  EXPECT_DOUBLE_EQ(aeb.with_line(0, 20), -2.5);
}

TEST(IntelligentDriver, OnAFreeRoadFollowsItsFormula) {
  Decisions idm(make_idm({}));
  EXPECT_DOUBLE_EQ(idm.alone(0), 0) << "2 * (1 - 1)";
  idm.speed_mps = 5;
  EXPECT_DOUBLE_EQ(idm.alone(0.05), 2 * (1 - 0.0625));
  idm.speed_mps = 0;
  EXPECT_DOUBLE_EQ(idm.alone(0.1), 2);
}

TEST(IntelligentDriver, BehindALeaderFollowsItsFormula) {
  Decisions idm(make_idm({}));
  idm.speed_mps = 5;
  // Desired gap: 2 + 5 * 1.5 + 5 * (5 - 3) / (2 * sqrt(2 * 2)) = 12 m.
  EXPECT_NEAR(idm.with_person(0, 24, 5, 0, 3), 2 * (0.9375 - 0.25), 1e-12);
  EXPECT_NEAR(idm.with_person(0.05, 12, 5, 0, 3), 2 * (0.9375 - 1), 1e-12);
}

TEST(IntelligentDriver, BrakesNoHarderThanItCan) {
  Decisions idm(make_idm({}));
  EXPECT_EQ(idm.with_person(0, 0.1), -8);
  Decisions weak(make_idm({.deceleration_mps2 = 3}));
  EXPECT_EQ(weak.with_person(0, 0.1), -3);
}

TEST(CarefulDriver, RollsWhileTheFootChangesThePedal) {
  Decisions careful(std::make_unique<CarefulDriver>());
  careful.speed_mps = 8;
  EXPECT_EQ(careful.with_person(0, 50), 2) << "not yet perceived";
  EXPECT_EQ(careful.with_person(0.35, 50), 2);
  EXPECT_EQ(careful.with_person(0.4, 50), 0) << "perceived: it no longer accelerates";
  EXPECT_NEAR(careful.with_person(1.1, 50), 0, 1e-9);
  // The braking grows from 0 by 12.65 m/s3 * 0.05 s; the mean of the period counts.
  EXPECT_NEAR(careful.with_person(1.15, 50), -12.65 * 0.05 / 2, 1e-9);
  EXPECT_NEAR(careful.with_person(1.2, 50), -12.65 * 0.05 * 1.5, 1e-9);
}

TEST(CarefulDriver, BeginsWithinAPeriod) {
  Decisions careful(std::make_unique<CarefulDriver>());
  careful.period_s = 0.1;
  careful.with_person(0, 50);
  // From 1.15 s to 1.2 s of a period that began at 1.1 s.
  EXPECT_NEAR(careful.with_person(1.1, 50), -(12.65 * 0.05 / 2 * 0.05) / 0.1, 1e-9);
}

TEST(CarefulDriver, BrakesNoHarderThanACompetentOne) {
  Decisions careful(std::make_unique<CarefulDriver>());
  for (int i = 0; i < 60; ++i) careful.with_person(0.05 * i, 50);
  EXPECT_NEAR(careful.with_person(3, 50), -kCompetentBrakingMps2, 1e-9);
}

TEST(CarefulDriver, ReleasesTheBrakeAtOnce) {
  Decisions careful(std::make_unique<CarefulDriver>());
  for (int i = 0; i < 60; ++i) careful.with_person(0.05 * i, 50);
  EXPECT_EQ(careful.alone(3), 0) << "at cruising speed";
  careful.speed_mps = 5;
  EXPECT_EQ(careful.alone(3.05), 2);
}

TEST(CarefulDriver, PerceivesALineAsItPerceivesARisk) {
  Decisions careful(std::make_unique<CarefulDriver>());
  EXPECT_EQ(careful.with_line(0, 20), 0);
  EXPECT_EQ(careful.with_line(1.1, 20), 0);
  EXPECT_LT(careful.with_line(1.15, 20), 0);
  Decisions forgetful(std::make_unique<CarefulDriver>());
  forgetful.with_line(0, 20);
  forgetful.alone(1);
  EXPECT_EQ(forgetful.with_line(1.2, 20), 0) << "the line opened in between";
}

/// Where the front comes to with a closed line at 40 m, by the drive of a minute and more; the
/// speed is the one at its end.
double front_after_a_minute(Decisions& driver) {
  double front_m = 0;
  for (int i = 0; i < 1200; ++i) {
    const double change = driver.with_line(driver.period_s * i, 40 - front_m) * driver.period_s;
    const Motion next = drive_on(driver.speed_mps, change, 10, driver.period_s);
    driver.speed_mps = next.speed;
    front_m += next.way;
  }
  return front_m;
}

TEST(CarefulDriver, StandsAtALineForAsLongAsItIsClosed) {
  Decisions careful(std::make_unique<CarefulDriver>());
  EXPECT_NEAR(front_after_a_minute(careful), 40, 0.3);
  EXPECT_EQ(careful.speed_mps, 0);
}

TEST(CarefulDriver, DrivesOnWhenTheLineOpens) {
  Decisions careful(std::make_unique<CarefulDriver>());
  front_after_a_minute(careful);
  EXPECT_EQ(careful.alone(60), 2);
}

TEST(OtherModels, StandAtALineForAsLongAsItIsClosed) {
  for (const auto& make : {make_braking, make_aeb, make_idm}) {
    Decisions driver(make({}));
    const double front_m = front_after_a_minute(driver);
    EXPECT_GT(front_m, 36) << "the standoff is 2 m at most";
    EXPECT_LT(front_m, 40.3);
    EXPECT_NEAR(driver.speed_mps, 0, 0.05) << "idm comes to a stand ever more slowly";
  }
}

}  // namespace
}  // namespace jaywalk
