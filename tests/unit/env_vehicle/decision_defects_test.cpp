// SPDX-License-Identifier: Apache-2.0
// A vehicle's answers under defects of decision and of actuation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/env_vehicle/spied_defect.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Confirmation, HoldsBackTheBeginningOfEachBraking) {
  SpiedDefect confirms("confirmation", 0.5);
  EXPECT_EQ(confirms.answers(1, -6), 0);
  EXPECT_EQ(confirms.answers(1.4, -6), 0);
  EXPECT_EQ(confirms.answers(1.5, -6), -6);
  EXPECT_EQ(confirms.answers(1.6, 1), 1) << "driving is never held back";
  EXPECT_EQ(confirms.answers(1.7, -6), 0) << "another braking";
}

TEST(Confirmation, TakesCoastingForNoBraking) {
  SpiedDefect confirms("confirmation", 0.5);
  EXPECT_EQ(confirms.answers(0, -0.1), -0.1);
  EXPECT_EQ(confirms.answers(0.4, -0.2), 0);
  EXPECT_EQ(confirms.answers(0.8, -0.2), 0) << "0.4 s after it began";
}

TEST(BrakesOnce, ForgetsWhoLeftTheLaneAfterItBrakedForThem) {
  SpiedDefect once("brakes-once", 1);
  once.answers(0, -6);
  EXPECT_THAT(once.numbers(0.1, {person(1, 20, 4)}), ElementsAre(1)) << "the answer stays -6";
  EXPECT_THAT(once.numbers(0.2, {person(1, 19, 1)}), IsEmpty()) << "out of the lane";
  EXPECT_THAT(once.numbers(0.3, {person(1, 18, 4)}), IsEmpty()) << "and in again";
}

TEST(BrakesOnce, MindsWhoItHasNotBrakedFor) {
  SpiedDefect once("brakes-once", 1);
  once.numbers(0, {person(1, 20, 4)});
  once.numbers(0.1, {person(1, 19, 1)});
  EXPECT_THAT(once.numbers(0.2, {person(1, 18, 4)}), ElementsAre(1));
}

TEST(ResumesEarly, IgnoresWhoHasPassedTheMiddleOfTheLane) {
  SpiedDefect resumes("resumes-early", 1);
  EXPECT_THAT(resumes.numbers({person(1, 20, 6.1, 1), person(2, 20, 5.9, 1), person(3, 20, 5.4, -1),
                               person(4, 20, 5.6, -1), person(5, 20, 8)}),
              ElementsAre(2, 4, 5))
      << "who stands is not on the way out";
}

TEST(NearestOnly, CountsThePavementToo) {
  SpiedDefect nearest("nearest-only", 1);
  EXPECT_THAT(nearest.numbers({person(1, 20, 5), person(2, 15, 0), person(3, -1, 5)}),
              ElementsAre(2));
  EXPECT_THAT(nearest.numbers({person(3, -1, 5)}), IsEmpty()) << "who is beside the front";
}

TEST(NearestOnly, TakesTheFirstOfEquals) {
  SpiedDefect nearest("nearest-only", 1);
  EXPECT_THAT(nearest.numbers({person(1, 20, 5), person(2, 20, 7)}), ElementsAre(1));
}

TEST(ComfortBraking, CutsBrakingAlone) {
  SpiedDefect comfort("comfort-braking", 3);
  EXPECT_EQ(comfort.answers(0, -6), -3);
  EXPECT_EQ(comfort.answers(0, -2), -2);
  EXPECT_EQ(comfort.answers(0, 5), 5);
}

TEST(OffWhenSlow, DoesNotBrakeBelowItsSpeed) {
  SpiedDefect off("off-when-slow", 2);
  off.view.speed_mps = 1.99;
  EXPECT_EQ(off.answers(0, -6), 0);
  EXPECT_EQ(off.answers(0, 1), 1);
  off.view.speed_mps = 2;
  EXPECT_EQ(off.answers(0, -6), -6);
}

TEST(OffWhenFast, DoesNotBrakeAboveItsSpeed) {
  SpiedDefect off("off-when-fast", 8);
  off.view.speed_mps = 8.01;
  EXPECT_EQ(off.answers(0, -6), 0);
  EXPECT_EQ(off.answers(0, 1), 1);
  off.view.speed_mps = 8;
  EXPECT_EQ(off.answers(0, -6), -6);
}

TEST(Creeps, NeverGoesBelowItsSpeed) {
  SpiedDefect creeps("creeps", 1);
  creeps.view.speed_mps = 1.2;
  EXPECT_DOUBLE_EQ(creeps.answers(0, -9), -2) << "0.2 m/s in a period of 0.1 s";
  creeps.view.speed_mps = 10;
  EXPECT_EQ(creeps.answers(0, -9), -9);
}

TEST(Creeps, ComesUpToItsSpeedGently) {
  SpiedDefect creeps("creeps", 1);
  creeps.view.speed_mps = 0;
  EXPECT_EQ(creeps.answers(0, 0), 1);
  creeps.view.speed_mps = 0.95;
  EXPECT_NEAR(creeps.answers(0, 0), 0.5, 1e-12) << "0.05 m/s are left";
  EXPECT_EQ(creeps.answers(0, 3), 3) << "whoever wants more gets it";
}

TEST(GivesUp, DrivesOnAfterSoLongABraking) {
  SpiedDefect gives_up("gives-up", 2);
  gives_up.view.speed_mps = 4;
  EXPECT_EQ(gives_up.answers(0, -5), -5);
  EXPECT_EQ(gives_up.answers(1.9, -5), -5);
  EXPECT_EQ(gives_up.answers(2, -5), 2);
}

TEST(GivesUp, CountsStandingAsWaiting) {
  SpiedDefect gives_up("gives-up", 2);
  gives_up.view.speed_mps = 0;
  EXPECT_EQ(gives_up.answers(0, 0), 0);
  EXPECT_EQ(gives_up.answers(2, 0), 2);
}

TEST(GivesUp, BeginsAnewAfterItDroveOn) {
  SpiedDefect gives_up("gives-up", 2);
  gives_up.view.speed_mps = 4;
  gives_up.answers(0, -5);
  EXPECT_EQ(gives_up.answers(1, 1), 1);
  EXPECT_EQ(gives_up.answers(2, -5), -5);
  EXPECT_EQ(gives_up.answers(3.9, -5), -5);
}

TEST(GivesUp, RollingAtFullSpeedIsNoWaiting) {
  SpiedDefect gives_up("gives-up", 2);
  EXPECT_EQ(gives_up.answers(0, 0), 0);
  EXPECT_EQ(gives_up.answers(5, -5), -5);
}

TEST(ZebraOnly, SeesNoPedestriansAndLeavesTheLines) {
  SpiedDefect zebra("zebra-only", 1);
  const std::vector<StopLine> lines{{20, true}};
  zebra.view.stop_lines = lines;
  SeenActor cyclist = person(2, 20, 5);
  cyclist.kind = ActorKind::cyclist;
  EXPECT_THAT(zebra.numbers({person(1, 20, 5), cyclist}), ElementsAre(2));
  EXPECT_TRUE(zebra.stop_lines().at(0).closed);
}

TEST(BlindAfterStop, SeesNobodyForSoLongAfterMovingOff) {
  SpiedDefect blind("blind-after-stop", 1.5);
  blind.view.speed_mps = 0;
  EXPECT_THAT(blind.numbers(0, {person(1, 5, 5)}), ElementsAre(1)) << "while it stands";
  blind.view.speed_mps = 0.5;
  EXPECT_THAT(blind.numbers(1, {person(1, 5, 5)}), IsEmpty());
  EXPECT_THAT(blind.numbers(2.4, {person(1, 5, 5)}), IsEmpty());
  EXPECT_THAT(blind.numbers(2.5, {person(1, 5, 5)}), ElementsAre(1));
}

TEST(BlindAfterStop, IsNotSoWithoutAStop) {
  SpiedDefect blind("blind-after-stop", 1.5);
  EXPECT_THAT(blind.numbers(0, {person(1, 5, 5)}), ElementsAre(1));
  EXPECT_THAT(blind.numbers(0.1, {person(1, 4, 5)}), ElementsAre(1));
}

TEST(SlowBrakes, GrowEvenlyToEightMetresPerSecondSquared) {
  // In 2 s to 8 m/s2: 0.4 m/s2 more in each period of 0.1 s.
  SpiedDefect slow("slow-brakes", 2);
  EXPECT_NEAR(slow.answers(0, -8), -0.4, 1e-12);
  EXPECT_NEAR(slow.answers(0.1, -8), -0.8, 1e-12);
  EXPECT_NEAR(slow.answers(0.2, -1), -1, 1e-12) << "no more than is wanted";
  EXPECT_NEAR(slow.answers(0.3, -8), -1.4, 1e-12);
}

TEST(SlowBrakes, AreReleasedAtOnce) {
  SpiedDefect slow("slow-brakes", 2);
  for (int i = 0; i < 10; ++i) slow.answers(0.1 * i, -8);
  EXPECT_EQ(slow.answers(1, 1), 1);
  EXPECT_NEAR(slow.answers(1.1, -8), -0.4, 1e-12);
}

TEST(LowFriction, LimitsBothWays) {
  SpiedDefect icy("low-friction", 0.2);
  EXPECT_DOUBLE_EQ(icy.answers(0, -9), -0.2 * kGravityMps2);
  EXPECT_DOUBLE_EQ(icy.answers(0, 5), 0.2 * kGravityMps2);
  EXPECT_EQ(icy.answers(0, -1), -1);
}

TEST(BrakeFade, WeakensAllBrakingsButTheFirst) {
  SpiedDefect hot("brake-fade", 50);
  EXPECT_EQ(hot.answers(0, -8), -8);
  EXPECT_EQ(hot.answers(0.1, -8), -8) << "still the first";
  EXPECT_EQ(hot.answers(0.2, 1), 1);
  EXPECT_EQ(hot.answers(0.3, -8), -4);
  EXPECT_EQ(hot.answers(0.4, 1), 1) << "driving does not fade";
}

TEST(PedalChange, RollsBetweenThePedals) {
  SpiedDefect pedals("pedal-change", 0.3);
  EXPECT_EQ(pedals.answers(0, 1), 1) << "the foot is on the accelerator";
  EXPECT_EQ(pedals.answers(0.1, -6), 0);
  EXPECT_EQ(pedals.answers(0.3, -6), 0);
  EXPECT_EQ(pedals.answers(0.4, -6), -6);
  EXPECT_EQ(pedals.answers(0.5, 1), 0) << "and back";
  EXPECT_EQ(pedals.answers(0.8, 1), 1);
}

TEST(PedalChange, IsGivenUpWhereTheOtherPedalIsWantedAgain) {
  SpiedDefect pedals("pedal-change", 0.3);
  pedals.answers(0, -6);
  EXPECT_EQ(pedals.answers(0.2, 1), 1) << "the foot has not left it";
  EXPECT_EQ(pedals.answers(0.3, -6), 0) << "the change begins anew";
  EXPECT_EQ(pedals.answers(0.6, -6), -6);
}

TEST(ActuationDelay, DoesEverythingSoMuchLater) {
  SpiedDefect delayed("actuation-delay", 0.3);
  EXPECT_EQ(delayed.answers(0, -6), 0);
  EXPECT_EQ(delayed.answers(0.1, 2), 0);
  EXPECT_EQ(delayed.answers(0.2, 0), 0);
  EXPECT_EQ(delayed.answers(0.3, 0), -6);
  EXPECT_EQ(delayed.answers(0.4, 0), 2);
  EXPECT_EQ(delayed.answers(0.5, -9), 0);
}

TEST(WeakBrakes, BrakeWithAShareAndDriveWithAll) {
  SpiedDefect weak("weak-brakes", 40);
  EXPECT_DOUBLE_EQ(weak.answers(0, -5), -2);
  EXPECT_EQ(weak.answers(0, 2), 2);
}

TEST(ActuationDefects, LeaveTheViewAlone) {
  for (const DefectModel& each : defect_models()) {
    if (each.family != DefectFamily::actuation) continue;
    SpiedDefect defect(each.name, each.severities.front());
    EXPECT_THAT(defect.numbers({person(1, 20, 5), person(2, -1, 5)}), ElementsAre(1, 2))
        << each.name;
  }
}

}  // namespace
}  // namespace jaywalk
