// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/frame_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

/// The case study's world: rows 0 and 1 are pavement, 2 to 5 the AV's lane, 6 to 9 the other one.
class FrameCellsTest : public testing::Test {
 protected:
  FrameCellsTest() { parameters_.av.start = 10; }

  Crossing world(std::vector<Position> start) {
    return Crossing(parameters_, vocabulary_, std::move(start));
  }
  /// A row of letters, from one cell to another.
  static std::string row(const Crossing& crossing, int row, int from, int to) {
    const FrameCells cells(crossing);
    std::string text;
    for (int y = from; y <= to; ++y) text += cells.at({row, y}).letter;
    return text;
  }
  void add_actor(ActorKind kind, Position start, std::size_t crosswalk = 0) {
    parameters_.actors.push_back({.name = "a" + std::to_string(parameters_.actors.size()),
                                  .kind = kind,
                                  .start = start,
                                  .crosswalk = crosswalk});
  }

  SymbolTable symbols_;
  CrossingVocabulary vocabulary_{symbols_};
  CrossingParameters parameters_;
};

TEST_F(FrameCellsTest, ShowTheAvWithItsEdgeAndItsZone) {
  const Crossing crossing = world({});
  EXPECT_EQ(row(crossing, 3, 6, 18), "  ==>::::::  ");
  EXPECT_EQ(row(crossing, 2, 6, 18), "     ::::::  ") << "the zone is as broad as the lane";
  EXPECT_EQ(row(crossing, 6, 6, 18), "             ");
}

TEST_F(FrameCellsTest, ShowPavementsAndLanes) {
  const Crossing crossing = world({});
  EXPECT_EQ(row(crossing, 0, 40, 44), ".....");
  EXPECT_EQ(row(crossing, 7, 40, 44), "     ");
}

TEST_F(FrameCellsTest, NumberPedestrians) {
  const Crossing crossing = world({{0, 40}, {1, 42}, {6, 41}});
  EXPECT_EQ(row(crossing, 0, 39, 43), ".1...");
  EXPECT_EQ(row(crossing, 1, 39, 43), "...2.");
  EXPECT_EQ(row(crossing, 6, 39, 43), "  3  ");
}

TEST_F(FrameCellsTest, CountOnWithLettersAndThenGiveUp) {
  const Crossing crossing = world(std::vector<Position>(37, {0, 40}));
  EXPECT_EQ(letter_of(crossing, 8), '9');
  EXPECT_EQ(letter_of(crossing, 9), 'a');
  EXPECT_EQ(letter_of(crossing, 34), 'z');
  EXPECT_EQ(letter_of(crossing, 35), '&');
  EXPECT_EQ(letter_of(crossing, 36), '&');
}

TEST_F(FrameCellsTest, ShowSeveralInOneCellByAStar) {
  const Crossing crossing = world({{0, 40}, {0, 40}});
  EXPECT_EQ(row(crossing, 0, 39, 41), ".*.");
}

TEST_F(FrameCellsTest, ShowPedestriansOverTheZone) {
  const Crossing crossing = world({{3, 14}});
  EXPECT_EQ(row(crossing, 3, 10, 16), ">:::1::");
}

TEST_F(FrameCellsTest, DrawCyclistsAndVehiclesAsLongAsTheyAre) {
  add_actor(ActorKind::cyclist, {7, 30});
  add_actor(ActorKind::vehicle, {8, 40});
  parameters_.actors[1].way = Direction::back;
  const Crossing crossing = world({});
  EXPECT_THAT(row(crossing, 7, 20, 60), testing::HasSubstr("C"));
  const std::string vehicle = row(crossing, 8, 30, 50);
  EXPECT_GE(std::ranges::count(vehicle, 'V'), 3) << vehicle;
  EXPECT_EQ(vehicle[10], 'V') << "round its middle";
}

TEST_F(FrameCellsTest, ShowObstaclesBuildingsAndJunctions) {
  parameters_.obstacles = {{{0, 1}, {40, 42}}};
  EXPECT_EQ(row(world({}), 1, 38, 44), "..XXX..");
  CrossingParameters& drawn = parameters_;
  drawn = {};
  drawn.bands = {{BandKind::pavement, 1}, {BandKind::lane, 2}, {BandKind::pavement, 1}};
  drawn.map = {"##....", ">>xx>>", ">>xx>>", "......"};
  drawn.length = 6;
  drawn.av.rows = {1, 1};
  drawn.av.start = -10;
  const Crossing crossing = world({});
  EXPECT_EQ(row(crossing, 0, 0, 5), "##....");
  EXPECT_EQ(row(crossing, 2, 0, 5), "  ++  ");
}

TEST_F(FrameCellsTest, ShowCrosswalksAndWhatTheirSignalsShow) {
  parameters_.crosswalks = {{CrosswalkKind::signalled, {40, 41}}};
  add_actor(ActorKind::signal, {0, 0});
  const Crossing crossing = world({});
  EXPECT_EQ(row(crossing, 7, 38, 43), "  ||  ");
  EXPECT_EQ(row(crossing, 1, 38, 43), "..G...") << "on the pavement beside it";
  EXPECT_EQ(row(crossing, 10, 38, 43), "..G...") << "and on the other one";
  EXPECT_EQ(row(crossing, 0, 38, 43), "......");
}

TEST_F(FrameCellsTest, KeepTheZoneInWhichThePreconditionWasMet) {
  Crossing crossing = world({{3, 13}});
  std::vector<ActionResult> results;
  crossing.execute({}, results);
  crossing.advance();
  ASSERT_TRUE(crossing.result().success);
  const AvSituation situation = av_situation(crossing);
  EXPECT_EQ(situation.zone, (Interval{11, 16}));
  EXPECT_GT(situation.edge, 10) << "though the AV has gone on";
  const FrameCells cells(crossing);
  EXPECT_NE(cells.at({3, 13}).style, FrameCells(world({{0, 13}})).at({0, 13}).style)
      << "who was met has another colour";
}

TEST_F(FrameCellsTest, GiveEachKindOfGroundAColourOfItsOwn) {
  const Crossing crossing = world({});
  const FrameCells cells(crossing);
  EXPECT_NE(cells.at({0, 40}).style, cells.at({7, 40}).style);
  EXPECT_NE(cells.at({3, 10}).style, cells.at({3, 12}).style);
}

TEST_F(FrameCellsTest, HaveALegendOfWhatOccurs) {
  EXPECT_THAT(legend(world({})), ElementsAre("=> AV", ": zone", "1 pedestrian", "* several"));
  parameters_.obstacles = {{{0, 1}, {40, 42}}};
  parameters_.crosswalks = {{CrosswalkKind::zebra, {30, 31}}};
  add_actor(ActorKind::cyclist, {7, 30});
  const std::vector<std::string> entries = legend(world({}));
  EXPECT_THAT(entries, Contains("C cyclist"));
  EXPECT_THAT(entries, Contains("| zebra"));
  EXPECT_THAT(entries, Contains("X parked car"));
  EXPECT_THAT(entries, Not(Contains("V vehicle")));
  EXPECT_THAT(entries, Not(Contains("| signalled crosswalk")));
}

}  // namespace
}  // namespace jaywalk
