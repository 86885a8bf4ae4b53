// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/parameters.h"

#include <functional>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(CrossingParameters, DefaultToTheCaseStudy) {
  const CrossingParameters paper;
  EXPECT_EQ(grid(paper).rows, 12);
  EXPECT_EQ(grid(paper).cells, 66);
  EXPECT_EQ(band_rows(paper), (std::vector<Interval>{{0, 1}, {2, 5}, {6, 9}, {10, 11}}));
  EXPECT_EQ(band_kind(paper, 1), BandKind::pavement);
  EXPECT_EQ(band_kind(paper, 2), BandKind::lane);
  EXPECT_EQ(band_kind(paper, 10), BandKind::pavement);
  EXPECT_EQ(zone_rows(paper), (Interval{2, 5}));
  EXPECT_EQ(zone_ahead(paper), (Interval{1, 6}));
  EXPECT_TRUE(problems(paper).empty());
}

TEST(CrossingParameters, TurnAWindowOfTimesToCollisionIntoCells) {
  CrossingParameters published;
  // 12 m of stopping distance are 1.33 s or 8 cells at 6 cells per second; 14 cells are 2.33 s.
  published.zone.ttc = {1.33, 2.33};
  EXPECT_EQ(zone_ahead(published), (Interval{9, 14}));
  published.av.speed = 3;
  // Middles of cells are reached after (k - 0.5) / 3 s: cell 5 after 1.5 s, cell 7 after 2.17 s.
  EXPECT_EQ(zone_ahead(published), (Interval{5, 7}));
}

TEST(CrossingParameters, PreferCellsAheadToTheWindow) {
  CrossingParameters parameters;
  parameters.zone.ahead = Interval{9, 14};
  EXPECT_EQ(zone_ahead(parameters), (Interval{9, 14}));
}

TEST(CrossingParameters, LetTheZoneFollowTheAv) {
  CrossingParameters parameters;
  parameters.zone.rows = ZoneRows::av;
  EXPECT_EQ(zone_rows(parameters), (Interval{3, 4}));
  parameters.zone.rows = ZoneRows::given;
  parameters.zone.given_rows = {4, 7};
  EXPECT_EQ(zone_rows(parameters), (Interval{4, 7}));
}

TEST(CrossingParameters, MeasureFromTheEndOfTheStoppingDistanceWhenAsked) {
  CrossingParameters parameters;
  parameters.av.start = -8;
  parameters.av.stopping_distance = 8;
  EXPECT_EQ(zone_origin(parameters, 0), -8);
  parameters.zone.origin = ZoneOrigin::stopping_distance;
  EXPECT_EQ(zone_origin(parameters, 0), 0);
  EXPECT_EQ(zone_origin(parameters, 11), 66);
}

TEST(CrossingParameters, RoundPositionsOfAFractionalSpeedDownToCells) {
  CrossingParameters parameters;
  parameters.av.speed = 5.5;
  EXPECT_EQ(zone_origin(parameters, 1), 5);
  EXPECT_EQ(zone_origin(parameters, 2), 11);
}

TEST(CrossingParameters, StayWithinBoundsWhateverTheSpeed) {
  CrossingParameters parameters;
  parameters.av.speed = 1e12;
  parameters.zone.ttc = {0, 3600};
  EXPECT_GT(zone_origin(parameters, 1000), parameters.road_end);
  EXPECT_GT(zone_ahead(parameters).last, parameters.length);
}

// The rest of a tick are the cells of the zone that the AV has not swept.
TEST(CrossingParameters, CarryOverWholeCellsOfADriveThatIsTheZonesSweep) {
  CrossingParameters carrying;
  carrying.av.carry_over = true;
  EXPECT_TRUE(problems(carrying).empty());
  const auto refused = [&](const std::function<void(CrossingParameters&)>& change) {
    CrossingParameters parameters = carrying;
    change(parameters);
    const auto found = problems(parameters);
    return found.size() == 1 && found[0].path == "world.av.carry_over";
  };
  EXPECT_TRUE(refused([](auto& world) { world.av.speed = 5.5; }));
  EXPECT_TRUE(refused([](auto& world) { world.av.vehicle.model = "braking"; }));
  EXPECT_TRUE(refused([](auto& world) { world.zone.ahead = Interval{9, 14}; }));
  EXPECT_TRUE(refused([](auto& world) { world.end = TestEnd::road; }));
  EXPECT_TRUE(refused([](auto& world) { world.aftermath = 1; }));
  EXPECT_TRUE(refused([](auto& world) { world.time_limit_s = 5; }));
  EXPECT_TRUE(refused([](auto& world) { world.road_end = 5; }));
  EXPECT_FALSE(refused([](auto& world) { world.av.speed = 3; }));
}

TEST(CrossingParameters, SayWhatDoesNotFitTogether) {
  CrossingParameters parameters;
  parameters.av.rows = {11, 12};
  ASSERT_EQ(problems(parameters).size(), 1U);
  EXPECT_EQ(problems(parameters)[0].path, "world.av.rows");
  EXPECT_EQ(problems(parameters)[0].message, "rows 11 to 12 are not within the grid's 0 to 11");

  parameters = {};
  parameters.av.rows = {0, 1};  // on the pavement, while the zone must be the lane's
  ASSERT_EQ(problems(parameters).size(), 1U);
  EXPECT_EQ(problems(parameters)[0].path, "world.zone.rows");

  parameters = {};
  parameters.zone.ahead = Interval{6, 1};
  ASSERT_EQ(problems(parameters).size(), 1U);
  EXPECT_EQ(problems(parameters)[0].path, "world.zone.ahead");

  parameters = {};
  parameters.spawn.dead_zones[5] = 3;
  ASSERT_EQ(problems(parameters).size(), 1U);
  EXPECT_EQ(problems(parameters)[0].message,
            "row 5 is not a row of a pavement, where agents spawn");

  parameters = {};
  parameters.spawn.dead_zones = {{0, 66}, {1, 66}, {10, 70}, {11, 66}};
  ASSERT_EQ(problems(parameters).size(), 1U);
  EXPECT_EQ(problems(parameters)[0].message, "no cell of a pavement is left to spawn on");

  parameters = {};
  parameters.av.start = 65;
  ASSERT_EQ(problems(parameters).size(), 1U);
  EXPECT_EQ(problems(parameters)[0].path, "world.road_end");
}

TEST(CrossingParameters, LetNoActorBeginInAnObstacle) {
  CrossingParameters parameters;
  parameters.obstacles = {{{7, 7}, {40, 43}}};
  const auto problem = [&](Position start) {
    parameters.actors = {
        {.name = "van", .kind = ActorKind::vehicle, .start = start, .way = Direction::back}};
    const std::vector<ParameterProblem> found = problems(parameters);
    return found.empty() ? "" : found.front().message;
  };
  EXPECT_EQ(problem({7, 43}),
            "'van' cannot start in row 7, cell 43: that is blocked or not on the grid");
  EXPECT_EQ(problem({7, 44}),
            "'van' cannot start in row 7, cell 44: its body reaches into a blocked cell");
  EXPECT_EQ(problem({7, 45}), "") << "its front touches the obstacle";
}

}  // namespace
}  // namespace jaywalk
