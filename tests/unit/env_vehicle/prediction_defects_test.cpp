// SPDX-License-Identifier: Apache-2.0
// Where a vehicle with a defect of prediction expects whom it sees.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/env_vehicle/spied_defect.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ConstantVelocity, SeesWhoWalksSteadilyInTheirPlace) {
  SpiedDefect constant("constant-velocity", 0.5);
  // Walks 1 m/s to the right; the vehicle comes 10 m/s nearer.
  for (const double time : {0.0, 0.2, 0.4, 0.5, 0.7}) {
    const SeenActor seen = constant.sees(time, {person(1, 50 - 10 * time, time, 1)}).at(0);
    EXPECT_NEAR(seen.gap_m, 50 - 10 * time, 1e-9) << time;
    EXPECT_NEAR(seen.left_m, time, 1e-9) << time;
  }
}

TEST(ConstantVelocity, LetsWhoStopsWalkOnForThatLong) {
  SpiedDefect constant("constant-velocity", 0.5);
  constant.sees(0, {person(1, 50, 0, 2)});
  constant.sees(0.25, {person(1, 47.5, 0.5)});
  const SeenActor seen = constant.sees(0.5, {person(1, 45, 0.5)}).at(0);
  EXPECT_NEAR(seen.left_m, 1, 1e-9) << "half a second at 2 m/s from 0";
  EXPECT_NEAR(seen.right_m, 1.5, 1e-9);
  EXPECT_EQ(seen.speed_right_mps, 2);
  EXPECT_NEAR(constant.sees(0.75, {person(1, 42.5, 0.5)}).at(0).left_m, 0.5, 1e-9)
      << "now it knows that they stand";
}

TEST(ConstantVelocity, KnowsNothingOldAtFirst) {
  SpiedDefect constant("constant-velocity", 0.5);
  constant.sees(0, {person(1, 50, 0, 2)});
  EXPECT_DOUBLE_EQ(constant.sees(0.25, {person(1, 47.5, 0.4)}).at(0).left_m, 0.4);
}

TEST(ConstantVelocity, SeesWhoIsNewWhereTheyAre) {
  SpiedDefect constant("constant-velocity", 0.5);
  constant.sees(0, {});
  EXPECT_DOUBLE_EQ(constant.sees(0.5, {person(1, 30, 4, 1)}).at(0).left_m, 4);
}

TEST(KerbStanding, TakesWhoSetsOutToStandStill) {
  SpiedDefect kerb("kerb-standing", 1);
  kerb.sees(0, {person(1, 50, 2)});
  const SeenActor seen = kerb.sees(0.5, {person(1, 45, 2.75, 1.5)}).at(0);
  EXPECT_DOUBLE_EQ(seen.left_m, 2);
  EXPECT_DOUBLE_EQ(seen.speed_right_mps, 0);
  EXPECT_DOUBLE_EQ(seen.gap_m, 45) << "the vehicle's own way is known";
}

TEST(KerbStanding, EndsSoLongAfterSettingOut) {
  SpiedDefect kerb("kerb-standing", 1);
  kerb.sees(0, {person(1, 50, 2)});
  EXPECT_DOUBLE_EQ(kerb.sees(1, {person(1, 40, 3.5, 1.5)}).at(0).left_m, 2);
  EXPECT_DOUBLE_EQ(kerb.sees(1.1, {person(1, 39, 3.65, 1.5)}).at(0).left_m, 3.65);
}

TEST(KerbStanding, IsNotForgottenByWhoStopsInTheLane) {
  SpiedDefect kerb("kerb-standing", 1);
  kerb.sees(0, {person(1, 50, 2)});
  kerb.sees(0.5, {person(1, 45, 3, 1.5)});
  EXPECT_DOUBLE_EQ(kerb.sees(0.6, {person(1, 44, 3)}).at(0).left_m, 3) << "stands in the lane";
  EXPECT_DOUBLE_EQ(kerb.sees(0.7, {person(1, 43, 3.2, 1.5)}).at(0).left_m, 3.2);
}

TEST(KerbStanding, DoesNotConcernWhoNeverStood) {
  SpiedDefect kerb("kerb-standing", 1);
  kerb.sees(0, {person(1, 50, 2, 1.5)});
  EXPECT_DOUBLE_EQ(kerb.sees(0.5, {person(1, 45, 2.75, 1.5)}).at(0).left_m, 2.75);
}

TEST(StopsAtKerb, PutsWhoComesFromTheLeftBackToTheEdge) {
  SpiedDefect stops("stops-at-kerb", 0.5);
  // The lane begins at 3 m: 0.25 m of the box are in it.
  const SeenActor seen = stops.sees({person(1, 20, 2.75, 1.5)}).at(0);
  EXPECT_DOUBLE_EQ(seen.right_m, 3);
  EXPECT_DOUBLE_EQ(seen.left_m, 2.5);
  EXPECT_EQ(seen.speed_right_mps, 0);
}

TEST(StopsAtKerb, PutsWhoComesFromTheRightBackToTheEdge) {
  SpiedDefect stops("stops-at-kerb", 0.5);
  const SeenActor seen = stops.sees({person(1, 20, 8.75, -1.5)}).at(0);
  EXPECT_DOUBLE_EQ(seen.left_m, 9);
  EXPECT_EQ(seen.speed_right_mps, 0);
}

TEST(StopsAtKerb, LeavesWhoIsStillOutsideInTheirPlace) {
  SpiedDefect stops("stops-at-kerb", 0.5);
  const SeenActor seen = stops.sees({person(1, 20, 2, 1.5)}).at(0);
  EXPECT_DOUBLE_EQ(seen.left_m, 2);
  EXPECT_EQ(seen.speed_right_mps, 0) << "they will stop";
}

TEST(StopsAtKerb, BelievesWhoIsFarEnoughIn) {
  SpiedDefect stops("stops-at-kerb", 0.5);
  const SeenActor seen = stops.sees({person(1, 20, 3, 1.5)}).at(0);
  EXPECT_DOUBLE_EQ(seen.left_m, 3);
  EXPECT_EQ(seen.speed_right_mps, 1.5);
}

TEST(ForgetsTurners, ForSoLongAfterTheTurn) {
  SpiedDefect forgets("forgets-turners", 2);
  EXPECT_THAT(forgets.numbers(0, {person(1, 50, 4, 1)}), ElementsAre(1));
  EXPECT_THAT(forgets.numbers(1, {person(1, 40, 5, -1)}), IsEmpty());
  EXPECT_THAT(forgets.numbers(2.9, {person(1, 21, 4, -1)}), IsEmpty());
  EXPECT_THAT(forgets.numbers(3, {person(1, 20, 4, -1)}), ElementsAre(1));
}

TEST(ForgetsTurners, NoticesATurnAfterAStand) {
  SpiedDefect forgets("forgets-turners", 2);
  forgets.numbers(0, {person(1, 50, 4, 1)});
  EXPECT_THAT(forgets.numbers(1, {person(1, 40, 5)}), ElementsAre(1)) << "to stand is not to turn";
  EXPECT_THAT(forgets.numbers(2, {person(1, 30, 5, 1)}), ElementsAre(1)) << "goes on as before";
  forgets.numbers(3, {person(1, 20, 6)});
  EXPECT_THAT(forgets.numbers(4, {person(1, 10, 6, -1)}), IsEmpty());
}

TEST(IgnoresAlong, WhoWalksMoreAlongThanAcross) {
  SpiedDefect ignores("ignores-along", 1);
  EXPECT_THAT(
      ignores.numbers({person(1, 20, 4, 1, 1.1), person(2, 20, 4, 1, -1.1), person(3, 20, 4, 1, 1),
                       person(4, 20, 4), person(5, 20, 4, 0, 0.05)}),
      ElementsAre(3, 4, 5));
}

TEST(GroupAsFirst, MovesTheOthersWithTheFirst) {
  SpiedDefect group("group-as-first", 2);
  // The second walks a metre behind the first, then turns back.
  group.sees(0, {person(1, 20, 4, 1), person(2, 21, 4, 1)});
  const auto seen = group.sees(1, {person(1, 10, 5, 1), person(2, 11, 3, -1)});
  EXPECT_DOUBLE_EQ(seen.at(1).left_m, 5);
  EXPECT_DOUBLE_EQ(seen.at(1).right_m, 5.5);
  EXPECT_DOUBLE_EQ(seen.at(1).gap_m, 11);
  EXPECT_DOUBLE_EQ(seen.at(1).speed_right_mps, 1);
}

TEST(GroupAsFirst, DoesNotTakeInWhoIsFartherAway) {
  SpiedDefect group("group-as-first", 2);
  group.sees(0, {person(1, 20, 4), person(2, 22.1, 4)});
  EXPECT_DOUBLE_EQ(group.sees(1, {person(1, 10, 5), person(2, 12.1, 2)}).at(1).left_m, 2);
}

TEST(GroupAsFirst, EndsWhenOneOfThemIsNotSeen) {
  SpiedDefect group("group-as-first", 2);
  group.sees(0, {person(1, 20, 4), person(2, 21, 4)});
  group.sees(1, {person(2, 11, 1)});
  EXPECT_DOUBLE_EQ(group.sees(2, {person(1, 3, 4), person(2, 1, 0)}).at(1).left_m, 0)
      << "4 m apart when both are seen again";
}

TEST(TrustsWalkers, IgnoresWhoWillBeOutOfThePath) {
  // 20 m at 10 m/s take 2 s.
  SpiedDefect trusts("trusts-walkers", 1);
  EXPECT_THAT(trusts.numbers({person(1, 20, 5, 1.3), person(2, 20, 5, 1.2), person(3, 20, 5)}),
              ElementsAre(2, 3))
      << "from 5 m the first walks to 7.6 m, beyond the body's side at 7.5 m";
}

TEST(TrustsWalkers, MindsWhoIsNotOvertaken) {
  SpiedDefect trusts("trusts-walkers", 1);
  EXPECT_THAT(trusts.numbers({person(1, 20, 5, 3, 10)}), ElementsAre(1))
      << "as fast as the vehicle";
}

}  // namespace
}  // namespace jaywalk
