// SPDX-License-Identifier: Apache-2.0
// A vehicle's view with a defect of perception.

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/env_vehicle/spied_defect.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The middle of the vehicle's body and of its lane.
constexpr double kMiddleM = 6;

TEST(Latency, ShowsTheFirstPictureUntilOneIsOldEnough) {
  SpiedDefect late("latency", 0.3);
  for (const double time : {0.0, 0.1, 0.2}) {
    const auto seen = late.sees(time, {person(1, 50 - time, 4)});
    EXPECT_DOUBLE_EQ(seen.at(0).gap_m, 50) << time;
  }
  EXPECT_DOUBLE_EQ(late.sees(0.3, {person(1, 49.7, 4)}).at(0).gap_m, 50) << "just 0.3 s ago";
  EXPECT_DOUBLE_EQ(late.sees(0.4, {person(1, 49.6, 4)}).at(0).gap_m, 49.9);
}

TEST(Latency, ShowsStopLinesLateToo) {
  SpiedDefect late("latency", 0.2);
  std::vector<StopLine> lines{{20, false}};
  late.view.stop_lines = lines;
  late.sees(0, {});
  lines[0].closed = true;
  late.sees(0.1, {});
  EXPECT_FALSE(late.stop_lines().at(0).closed);
  late.sees(0.3, {});
  EXPECT_TRUE(late.stop_lines().at(0).closed);
}

TEST(Latency, StillShowsWhoHasLeft) {
  SpiedDefect late("latency", 0.2);
  late.sees(0, {person(1, 20, 4)});
  EXPECT_THAT(late.numbers(0.1, {}), ElementsAre(1));
  EXPECT_THAT(late.numbers(0.2, {}), ElementsAre(1));
  EXPECT_THAT(late.numbers(0.3, {}), IsEmpty());
}

TEST(ShortRange, EndsAtItsSeverity) {
  SpiedDefect near("short-range", 20);
  EXPECT_THAT(near.numbers({person(1, 20, 4), person(2, 20.01, 4), person(3, -1, 4)}),
              ElementsAre(1, 3));
}

TEST(NarrowView, HoldsWhoReachesIntoHalfItsAngleOnEitherSide) {
  // Of 90 degrees there are 45 on either side: as far aside as ahead.
  SpiedDefect narrow("narrow-view", 90);
  EXPECT_THAT(
      narrow.numbers({person(1, 5, kMiddleM + 4.9), person(2, 5, kMiddleM + 5.1),
                      person(3, 5, kMiddleM - 0.5 - 4.9), person(4, 5, kMiddleM - 0.5 - 5.1)}),
      ElementsAre(1, 3));
}

TEST(NarrowView, HoldsWhoStandsBeforeTheMiddleOfTheFront) {
  SpiedDefect narrow("narrow-view", 1);
  EXPECT_THAT(narrow.numbers({person(1, 0.1, kMiddleM - 0.25), person(2, 100, kMiddleM + 0.8),
                              person(3, 100, kMiddleM + 0.9)}),
              ElementsAre(1, 2))
      << "half a degree is 0.873 m at 100 m";
}

TEST(BlindToStanding, SeesWhoMovesAnyWay) {
  SpiedDefect blind("blind-to-standing", 1);
  EXPECT_THAT(blind.numbers({person(1, 20, 4), person(2, 20, 4, 0.1), person(3, 20, 4, 0, -0.1),
                             person(4, 20, 4, 0.07, 0.07), person(5, 20, 4, 0.08, 0.08)}),
              ElementsAre(2, 3, 5))
      << "0.07 each way are 0.099 m/s";
}

TEST(OwnLaneOnly, GoesByTheMiddleOfTheBox) {
  SpiedDefect defect("own-lane-only", 1);
  EXPECT_THAT(defect.numbers({person(1, 20, 2.7), person(2, 20, 2.75), person(3, 20, 8.75),
                              person(4, 20, 8.8)}),
              ElementsAre(2, 3));
}

TEST(OwnPathOnly, GoesByTheSidesOfTheBody) {
  SpiedDefect defect("own-path-only", 1);
  EXPECT_THAT(defect.numbers(
                  {person(1, 20, 4), person(2, 20, 4.1), person(3, 20, 7.4), person(4, 20, 7.5)}),
              ElementsAre(2, 3))
      << "who only touches the side is not over it";
}

TEST(SlowTracking, KnowsWhoWasThereFromTheBeginning) {
  SpiedDefect slow("slow-tracking", 0.5);
  EXPECT_THAT(slow.numbers(0, {person(1, 20, 4)}), ElementsAre(1));
}

TEST(SlowTracking, SeesWhoComesIntoViewSoMuchLater) {
  SpiedDefect slow("slow-tracking", 0.5);
  slow.numbers(0, {});
  EXPECT_THAT(slow.numbers(0.1, {person(1, 20, 4)}), IsEmpty());
  EXPECT_THAT(slow.numbers(0.5, {person(1, 20, 4)}), IsEmpty());
  EXPECT_THAT(slow.numbers(0.6, {person(1, 20, 4)}), ElementsAre(1));
}

TEST(SlowTracking, BeginsAnewForWhoWasHidden) {
  SpiedDefect slow("slow-tracking", 0.5);
  slow.numbers(0, {person(1, 20, 4)});
  slow.numbers(0.1, {});
  EXPECT_THAT(slow.numbers(0.2, {person(1, 20, 4)}), IsEmpty());
  EXPECT_THAT(slow.numbers(0.7, {person(1, 20, 4)}), ElementsAre(1));
}

TEST(ClassChange, GivesEverybodyANewNumberInEachPeriod) {
  SpiedDefect change("class-change", 1);
  const unsigned at_first = change.numbers(0.9, {person(1, 20, 4)}).at(0);
  const unsigned then = change.numbers(1, {person(1, 20, 4)}).at(0);
  const unsigned still = change.numbers(1.9, {person(1, 20, 4)}).at(0);
  const unsigned at_last = change.numbers(2, {person(1, 20, 4)}).at(0);
  EXPECT_EQ(at_first, 1U);
  EXPECT_NE(then, at_first);
  EXPECT_EQ(still, then);
  EXPECT_NE(at_last, then);
}

TEST(ClassChange, KnowsNoSpeedInTheFirstHalfOfAPeriod) {
  SpiedDefect change("class-change", 1);
  const std::vector<SeenActor> walking{person(1, 20, 4, 1.5, -0.5)};
  EXPECT_EQ(change.sees(0.2, walking).at(0).speed_right_mps, 1.5) << "nobody has changed yet";
  EXPECT_EQ(change.sees(1.2, walking).at(0).speed_right_mps, 0);
  EXPECT_EQ(change.sees(1.2, walking).at(0).speed_ahead_mps, 0);
  EXPECT_EQ(change.sees(1.5, walking).at(0).speed_right_mps, 1.5);
  EXPECT_EQ(change.sees(1.9, walking).at(0).speed_ahead_mps, -0.5);
}

TEST(ClassChange, KeepsTheNumbersOfTwoApart) {
  SpiedDefect change("class-change", 0.5);
  for (const double time : {0.0, 0.7, 1.3, 2500.0}) {
    const auto numbers = change.numbers(time, {person(1, 20, 4), person(2, 30, 4)});
    EXPECT_EQ(numbers.at(1) - numbers.at(0), 1U) << time;
  }
}

TEST(MergedGroup, TakesTheNearForAPartOfTheOneWithTheLowestNumber) {
  SpiedDefect merged("merged-group", 2);
  EXPECT_THAT(merged.numbers({person(1, 20, 4), person(2, 22, 4), person(3, 20, 6.1)}),
              ElementsAre(1, 3));
}

TEST(MergedGroup, DoesNotReachFromPartToPart) {
  SpiedDefect merged("merged-group", 2);
  EXPECT_THAT(merged.numbers({person(1, 20, 4), person(2, 21.5, 4), person(3, 23, 4)}),
              ElementsAre(1, 3))
      << "the third is near the second, who is no longer there";
}

TEST(OffCrossing, SeesPedestriansNearStopLinesAlone) {
  SpiedDefect off("off-crossing", 6);
  const std::vector<StopLine> lines{{30, false}};
  off.view.stop_lines = lines;
  EXPECT_THAT(
      off.numbers({person(1, 23.9, 4), person(2, 24, 4), person(3, 36, 4), person(4, 36.1, 4)}),
      ElementsAre(2, 3));
}

TEST(OffCrossing, SeesVehiclesEverywhere) {
  SpiedDefect off("off-crossing", 6);
  SeenActor car = person(1, 50, 4);
  car.kind = ActorKind::vehicle;
  EXPECT_THAT(off.numbers({car, person(2, 50, 4)}), ElementsAre(1));
}

TEST(NearObstacle, MissesWhoIsSoCloseToOne) {
  SpiedDefect near("near-obstacle", 1);
  const std::vector<SeenObstacle> obstacles{{.gap_m = 20, .far_m = 24, .left_m = 1, .right_m = 3}};
  near.view.obstacles = obstacles;
  EXPECT_THAT(
      near.numbers({person(1, 22, 4), person(2, 22, 4.1), person(3, 19, 2), person(4, 18.9, 2),
                    person(5, 25, 2), person(6, 25.1, 2), person(7, 22, 0)}),
      ElementsAre(2, 4, 6))
      << "before, behind and beside it";
}

TEST(NearObstacle, MeasuresTheCornerAlongTheDiagonal) {
  SpiedDefect near("near-obstacle", 1);
  const std::vector<SeenObstacle> obstacles{{.gap_m = 20, .far_m = 24, .left_m = 1, .right_m = 3}};
  near.view.obstacles = obstacles;
  EXPECT_THAT(near.numbers({person(1, 19.3, 3.7), person(2, 19.2, 3.8)}), ElementsAre(2))
      << "0.99 m and 1.13 m";
}

TEST(NearBlind, MissesWhoIsCloserThanItsShadow) {
  SpiedDefect blind("near-blind", 3);
  EXPECT_THAT(blind.numbers({person(1, 2.99, 4), person(2, 3, 4)}), ElementsAre(2));
}

TEST(FrozenFrames, TakesTurnsWithSeeing) {
  SpiedDefect frozen("frozen-frames", 0.5);
  EXPECT_DOUBLE_EQ(frozen.sees(0, {person(1, 50, 4)}).at(0).gap_m, 50);
  EXPECT_DOUBLE_EQ(frozen.sees(0.4, {person(1, 46, 4)}).at(0).gap_m, 46);
  EXPECT_DOUBLE_EQ(frozen.sees(0.5, {person(1, 45, 4)}).at(0).gap_m, 46);
  EXPECT_DOUBLE_EQ(frozen.sees(0.9, {person(1, 41, 4)}).at(0).gap_m, 46);
  EXPECT_DOUBLE_EQ(frozen.sees(1, {person(1, 40, 4)}).at(0).gap_m, 40);
}

TEST(LateralBias, MovesTheWholeBox) {
  SpiedDefect bias("lateral-bias", 0.8);
  const SeenActor seen = bias.sees({person(1, 20, 4)}).at(0);
  EXPECT_DOUBLE_EQ(seen.left_m, 4.8);
  EXPECT_DOUBLE_EQ(seen.right_m, 5.3);
  EXPECT_DOUBLE_EQ(seen.gap_m, 20);
}

TEST(RangeBias, MovesTheGapAlone) {
  SpiedDefect bias("range-bias", 3);
  const SeenActor seen = bias.sees({person(1, 20, 4)}).at(0);
  EXPECT_DOUBLE_EQ(seen.gap_m, 23);
  EXPECT_DOUBLE_EQ(seen.left_m, 4);
}

TEST(BlindSides, AreTheTwoHalvesOfTheBody) {
  const std::vector<SeenActor> people{person(1, 20, 5), person(2, 20, kMiddleM - 0.25),
                                      person(3, 20, 7)};
  EXPECT_THAT(SpiedDefect("blind-left", 1).numbers(people), ElementsAre(2, 3));
  EXPECT_THAT(SpiedDefect("blind-right", 1).numbers(people), ElementsAre(1, 2));
}

TEST(FastAsNoise, MissesWhoIsFasterThanItsFilter) {
  SpiedDefect noise("fast-as-noise", 2.5);
  EXPECT_THAT(
      noise.numbers({person(1, 20, 4, 1.5, 2), person(2, 20, 4, 1.6, 2), person(3, 20, 4, -3)}),
      ElementsAre(1))
      << "1.5 and 2 m/s make 2.5";
}

TEST(PerceptionDefects, LeaveTheAnswerAlone) {
  for (const DefectModel& each : defect_models()) {
    if (each.family != DefectFamily::perception && each.family != DefectFamily::prediction)
      continue;
    SpiedDefect defect(each.name, each.severities.front());
    EXPECT_EQ(defect.answers(0, -3.25), -3.25) << each.name;
  }
}

}  // namespace
}  // namespace jaywalk
