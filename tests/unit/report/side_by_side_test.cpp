// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/player/player.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The AV's places along its way at each tick of half a second; two pedestrians who stand.
Recording drive_to(const std::vector<double>& places) {
  std::vector<Place> way;
  for (const double y : places) way.push_back({0, y});
  return drive(0.5, {way, std::vector<Place>(places.size(), {3, 30}),
                     std::vector<Place>(places.size(), {-3, 40})});
}

TEST(Parting, IsTheFirstTickAtWhichSomebodyIsElsewhere) {
  Recording one(1, {{"av", ActorKind::vehicle, 4, 2}});
  Recording other = one;
  for (const double y : {0.0, 5.0, 10.0}) one.add(Scene{{0, y, 5, 1.5}});
  for (const double y : {0.0, 5.0, 9.0}) other.add(Scene{{0, y, 5, 1.5}});
  EXPECT_EQ(parting(one, other), 2U);
  EXPECT_EQ(parting(other, one), 2U);
}

TEST(Parting, IsSeenInSpeedsToo) {
  Recording one(1, {{"av", ActorKind::vehicle, 4, 2}});
  Recording other = one;
  one.add(Scene{{0, 0, 5, 1.5}});
  other.add(Scene{{0, 0, 4, 1.5}});
  EXPECT_EQ(parting(one, other), 0U);
}

TEST(Parting, IsNotSeenInHeadings) {
  Recording one(1, {{"av", ActorKind::vehicle, 4, 2}});
  Recording other = one;
  one.add(Scene{{0, 0, 5, 1.5}});
  other.add(Scene{{0, 0, 5, 0}});
  EXPECT_EQ(parting(one, other), std::nullopt);
}

TEST(Parting, IsNoneWhereOneRunOnlyGoesOn) {
  Recording one(1, {{"av", ActorKind::vehicle, 4, 2}});
  Recording other = one;
  one.add(Scene{{0, 0, 5, 1.5}});
  other.add(Scene{{0, 0, 5, 1.5}});
  other.add(Scene{{0, 5, 5, 1.5}});
  EXPECT_EQ(parting(one, other), std::nullopt);
}

TEST(SideBySide, SaysThatBothDriveAlike) {
  const Recording recording = drive_to({0, 5, 10});
  EXPECT_EQ(side_by_side(recording, recording, "latency"), "both AVs drive alike\n");
}

TEST(SideBySide, BeginsWithTheTickBeforeTheyPart) {
  const std::string text =
      side_by_side(drive_to({0, 5, 10, 15}), drive_to({0, 5, 10, 18}), "latency");
  // The speed of tick 2 already differs: it is that of the stretch to the next place.
  EXPECT_THAT(text, StartsWith("they part in tick 2 (1.0 s)\n\n"));
  EXPECT_THAT(text, Not(HasSubstr("\n    0  ")));
  EXPECT_THAT(text, HasSubstr("\n    1     5.00  10.00    3.0,   30.0   -3.0,   40.0 |    5.00  "
                              "10.00    3.0,   30.0   -3.0,   40.0\n"));
  EXPECT_THAT(text, HasSubstr("\n    3    15.00  10.00"));
}

TEST(SideBySide, NamesTheColumns) {
  const std::string text = side_by_side(drive_to({0, 5}), drive_to({0, 6}), "weak-brakes=60");
  EXPECT_THAT(text, HasSubstr("       healthy "));
  EXPECT_THAT(text, HasSubstr("| weak-brakes=60\n"));
  EXPECT_THAT(text, HasSubstr("   AV m    m/s             p1             p2 |"));
}

TEST(SideBySide, LeavesARunThatHasEndedBlank) {
  const std::string text = side_by_side(drive_to({0, 5}), drive_to({0, 6, 12}), "latency");
  EXPECT_THAT(text, HasSubstr("\n    2  " + std::string(14 + 15 * 2, ' ') + " |   12.00"));
}

TEST(SideBySide, SaysWhatHappenedBehindTheTick) {
  Recording defective = drive_to({0, 6});
  defective.add(RecordedEvent{.tick = 1, .actor = 2, .kind = "collision", .text = "12 m/s"});
  Recording healthy = drive_to({0, 5});
  healthy.add(RecordedEvent{.tick = 1, .kind = "end"});
  EXPECT_THAT(side_by_side(healthy, defective, "latency"),
              HasSubstr("  healthy: end  latency: collision of p2 (12 m/s)\n"));
}

TEST(SideBySide, ShowsThoseFirstToWhomSomethingHappened) {
  std::vector<std::vector<Place>> ways{{{0, 0}, {0, 6}}};
  for (int i = 1; i <= 4; ++i) ways.push_back({{10.0 + i, 0}, {10.0 + i, 0}});
  Recording defective = drive(0.5, ways);
  defective.add(RecordedEvent{.tick = 1, .actor = 4, .kind = "collision"});
  ways[0] = {{0, 0}, {0, 5}};
  const std::string text = side_by_side(drive(0.5, ways), defective, "latency");
  EXPECT_THAT(text, HasSubstr("             p4             p1 |"));
  EXPECT_THAT(text, Not(HasSubstr("p2"))) << "two fit a line";
}

}  // namespace
}  // namespace jaywalk
