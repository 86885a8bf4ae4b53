// SPDX-License-Identifier: Apache-2.0
// Each item of situations.def by drives made by hand: where its bins begin and end.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "experiment/judge/metrics/metrics.h"
#include "experiment/judge/situations/situations.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

/// The bin's name that a test covers, seen from the first pedestrian at a tick.
std::string bin_at(std::string_view name, Recording recording, std::uint32_t tick = 1,
                   const Ground& ground = road()) {
  recording.add(RecordedEvent{.tick = tick, .actor = 1, .kind = "precondition"});
  const SituationBins bins = covered_bins(recording, ground);
  const auto items = situation_items();
  const auto item = std::ranges::find(items, name, &SituationItem::name);
  const auto& found = bins[static_cast<std::size_t>(item - items.begin())];
  return found ? item->bins[*found] : "none";
}

/// Somebody who goes from one place to another beside an AV with some speed.
Recording step(Place from, Place to, double av_mps = 9) {
  return drive(1, {{{0, 0}, {0, av_mps}}, {from, to}});
}

TEST(StartSide, IsSeenFromTheMiddleOfTheAv) {
  EXPECT_EQ(bin_at("start_side", step({-0.01, 20}, {5, 20})), "left");
  EXPECT_EQ(bin_at("start_side", step({0, 20}, {-5, 20})), "right");
  EXPECT_EQ(bin_at("start_side", step({4, 20}, {-5, 20})), "right");
}

TEST(StartBand, IsASixthOfTheRoad) {
  // The road of these tests ends at 1000 m.
  const auto band = [](double y) { return bin_at("start_band", step({5, y}, {4, y})); };
  EXPECT_EQ(band(0), "1st sixth");
  EXPECT_EQ(band(166), "1st sixth");
  EXPECT_EQ(band(167), "2nd");
  EXPECT_EQ(band(500), "4th");
  EXPECT_EQ(band(999), "6th");
  EXPECT_EQ(band(2000), "6th") << "beyond its end";
  EXPECT_EQ(band(-50), "1st sixth") << "before its begin";
}

TEST(StartBand, IsNoneWithoutGround) {
  EXPECT_EQ(bin_at("start_band", step({5, 20}, {4, 20}), 1, {}), "none");
}

TEST(Approach, GoesByTheStepIntoThePrecondition) {
  EXPECT_EQ(bin_at("approach", step({-2, 20}, {-1, 20})), "from the left");
  EXPECT_EQ(bin_at("approach", step({2, 20}, {1, 20})), "from the right");
  EXPECT_EQ(bin_at("approach", step({1, 20}, {1, 21})), "along");
  EXPECT_EQ(bin_at("approach", step({1, 20}, {1, 19})), "along");
  EXPECT_EQ(bin_at("approach", step({1, 20}, {1, 20})), "standing");
}

TEST(Approach, OfASlantingStepIsItsLongerPart) {
  EXPECT_EQ(bin_at("approach", step({-2, 20}, {-1, 20.5})), "from the left");
  EXPECT_EQ(bin_at("approach", step({-2, 20}, {-1.5, 21})), "along");
}

TEST(EntryTtc, IsMeasuredFromWhereTheAvWasBefore) {
  // Its leading edge is at 2 m; it drives 10 m/s.
  const auto ttc = [](double y) { return bin_at("entry_ttc", step({1, y}, {1, y}, 10)); };
  EXPECT_EQ(ttc(3.9), "0-0.2 s");
  EXPECT_EQ(ttc(4.1), "0.2-0.4 s");
  EXPECT_EQ(ttc(6.1), "0.4-0.6 s");
  EXPECT_EQ(ttc(8.1), "0.6-0.8 s");
  EXPECT_EQ(ttc(10.1), "0.8 s-");
  EXPECT_EQ(ttc(100), "0.8 s-");
  EXPECT_EQ(ttc(0), "0-0.2 s") << "behind the edge already";
}

TEST(EntryTtc, TakesItsBordersForTheBinThatBegins) {
  EXPECT_EQ(bin_at("entry_ttc", step({1, 4}, {1, 4}, 10)), "0.2-0.4 s");
}

TEST(EntryTtc, IsNoneOfAnAvThatStands) {
  EXPECT_EQ(bin_at("entry_ttc", step({1, 5}, {1, 5}, 0)), "none");
}

TEST(ImpactPoint, IsAQuarterOfTheAvsWidth) {
  // The AV's body is from -1 m to 1 m.
  const auto point = [](double x) { return bin_at("impact_point", step({x, 20}, {x, 20})); };
  EXPECT_EQ(point(-1.01), "left of it");
  EXPECT_EQ(point(-0.9), "25 %");
  EXPECT_EQ(point(-0.26), "25 %");
  EXPECT_EQ(point(-0.24), "50 %");
  EXPECT_EQ(point(0.24), "50 %");
  EXPECT_EQ(point(0.26), "75 %");
  EXPECT_EQ(point(0.9), "75 %");
  EXPECT_EQ(point(1.01), "right of it");
}

TEST(EntryTime, CountsFromTheBeginningOfTheTest) {
  const Recording recording = drive(1, {steps({0, 0}, {0, 9}, 13), steps({5, 200}, {0, 0}, 13)});
  EXPECT_EQ(bin_at("entry_time", recording, 1), "0-3 s");
  EXPECT_EQ(bin_at("entry_time", recording, 2), "0-3 s");
  EXPECT_EQ(bin_at("entry_time", recording, 3), "3-6 s");
  EXPECT_EQ(bin_at("entry_time", recording, 8), "6-9 s");
  EXPECT_EQ(bin_at("entry_time", recording, 9), "9 s-");
  EXPECT_EQ(bin_at("entry_time", recording, 12), "9 s-");
}

TEST(EntryTime, IsInSecondsWhateverTheTick) {
  const Recording recording = drive(0.5, {steps({0, 0}, {0, 4.5}, 9), steps({5, 200}, {0, 0}, 9)});
  EXPECT_EQ(bin_at("entry_time", recording, 5), "0-3 s");
  EXPECT_EQ(bin_at("entry_time", recording, 6), "3-6 s");
}

TEST(AvSpeed, IsThatBeforeTheTick) {
  const auto speed = [](double mps) { return bin_at("av_speed", step({5, 50}, {5, 50}, mps)); };
  EXPECT_EQ(speed(0), "0-3 m/s");
  EXPECT_EQ(speed(2.9), "0-3 m/s");
  EXPECT_EQ(speed(3), "3-6 m/s");
  EXPECT_EQ(speed(6.1), "6-9 m/s");
  EXPECT_EQ(speed(9), "9 m/s-");
  EXPECT_EQ(speed(30), "9 m/s-");
}

/// So many others stand in the road beside the one who meets the precondition.
Recording among(std::size_t others, Place where) {
  std::vector<std::vector<Place>> ways{steps({0, 0}, {0, 9}, 2), steps({1, 20}, {0, 0}, 2)};
  for (std::size_t i = 0; i < others; ++i) ways.push_back(steps(where, {0, 0}, 2));
  return drive(1, ways);
}

TEST(Others, AreCountedUpToThree) {
  EXPECT_EQ(bin_at("others", among(0, {4, 40})), "none");
  EXPECT_EQ(bin_at("others", among(1, {4, 40})), "1");
  EXPECT_EQ(bin_at("others", among(2, {4, 40})), "2");
  EXPECT_EQ(bin_at("others", among(3, {4, 40})), "3 or more");
  EXPECT_EQ(bin_at("others", among(7, {4, 40})), "3 or more");
}

TEST(Others, StandInTheRoad) {
  EXPECT_EQ(bin_at("others", among(2, {-5, 40})), "none") << "on the pavement";
}

TEST(Pairs, CombineTheBinsOfTheirItems) {
  const Recording recording = step({-2, 4.1}, {-1.5, 4.1}, 10);
  EXPECT_EQ(bin_at("side_and_ttc", recording), "left, 0.2-0.4 s");
  EXPECT_EQ(bin_at("point_and_approach", recording), "left of it, from the left");
}

TEST(Pairs, AreNoneWhereOneOfTheirItemsIs) {
  EXPECT_EQ(bin_at("side_and_ttc", step({1, 5}, {1, 5}, 0)), "none");
}

/// Which steps of a pedestrian are natural, tick by tick, `y` or `n`.
std::string natural(const std::vector<Place>& places) {
  std::vector<Actor> actors{{"av", ActorKind::vehicle, 4, 2},
                            {"p", ActorKind::pedestrian, 0.5, 0.5}};
  Recording recording(1, actors);
  double heading = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place from = places[i == 0 ? 0 : i - 1];
    const double dx = places[i].x - from.x;
    const double dy = places[i].y - from.y;
    const double speed = std::hypot(dx, dy);
    if (speed > 0) heading = std::atan2(dy, dx);
    recording.add(Scene{{0, -50, 0, 1.5707963}, {places[i].x, places[i].y, speed, heading}});
  }
  const Ground ground = road();
  const TestView view(recording, ground);
  std::string text;
  for (std::size_t tick = 1; tick < view.ticks(); ++tick) {
    text += is_natural_step(view, 1, tick) ? 'y' : 'n';
  }
  return text;
}

TEST(NaturalSteps, DoNotTurnStraightBack) {
  EXPECT_EQ(natural({{-5, 0}, {-4, 0}, {-3, 0}, {-4, 0}}), "yyn");
  EXPECT_EQ(natural({{-5, 0}, {-4, 0}, {-4, 1}, {-5, 1}}), "yyy") << "quarter turns";
}

TEST(NaturalSteps, MayTurnBackAfterAStand) {
  EXPECT_EQ(natural({{-6, 0}, {-5, 0}, {-5, 0}, {-6, 0}}), "yyy");
}

TEST(NaturalSteps, DoNotStandInTheRoad) {
  EXPECT_EQ(natural({{-4, 0}, {-2, 0}, {-2, 0}, {0, 0}}), "yny");
  EXPECT_EQ(natural({{-5, 0}, {-5, 0}, {-5, 0}}), "yy") << "on the pavement they may";
}

}  // namespace
}  // namespace jaywalk
