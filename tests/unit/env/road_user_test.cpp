// SPDX-License-Identifier: Apache-2.0
// The road users of a crossing's ground, and how far they move.

#include "env/crossing/road_user.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

/// Five rows of ten cells: pavement, two lanes, pavement, pavement; a parked car on the first lane.
CrossingParameters drawn_ground() {
  CrossingParameters parameters;
  parameters.map = {
      "..........", ">>>>##>>>>", "<<<<<<<<<<", "....xx....", "..........",
  };
  parameters.length = 10;
  parameters.bands = {{BandKind::pavement, 5}};
  return parameters;
}

RoadUser somebody(double x, double y, ActorKind kind = ActorKind::pedestrian) {
  RoadUser body;
  body.kind = kind;
  body.place = {x, y};
  return body;
}

TEST(Surfaces, AreLettersOfAMap) {
  EXPECT_EQ(find_surface('.'), Surface::pavement);
  EXPECT_EQ(find_surface('>'), Surface::lane);
  EXPECT_EQ(find_surface('<'), Surface::lane);
  EXPECT_EQ(find_surface('x'), Surface::lane);
  EXPECT_EQ(find_surface('#'), Surface::blocked);
  EXPECT_FALSE(find_surface(' '));
}

TEST(Layouts, OfAMapAreAsItIsDrawn) {
  const Layout layout(drawn_ground());
  EXPECT_EQ(layout.grid().rows, 5);
  EXPECT_EQ(layout.grid().cells, 10);
  EXPECT_EQ(layout.at({0, 3}), Surface::pavement);
  EXPECT_EQ(layout.at({1, 4}), Surface::blocked);
  EXPECT_TRUE(layout.is_road({3, 4}));
  EXPECT_FALSE(layout.is_road({3, 3}));
}

TEST(Layouts, LayCrosswalksOverLanesAlone) {
  CrossingParameters parameters = drawn_ground();
  Crosswalk crosswalk;
  crosswalk.cells = {4, 6};
  parameters.crosswalks = {crosswalk};
  const Layout layout(parameters);
  EXPECT_EQ(layout.at({2, 4}), Surface::crosswalk);
  EXPECT_EQ(layout.at({0, 4}), Surface::pavement);
  EXPECT_EQ(layout.at({1, 4}), Surface::blocked) << "not over what is blocked";
  EXPECT_EQ(layout.at({1, 6}), Surface::crosswalk);
  EXPECT_EQ(layout.at({2, 7}), Surface::lane);
}

TEST(Layouts, CutObstaclesAtTheEdgeOfTheGrid) {
  CrossingParameters parameters = drawn_ground();
  Obstacle obstacle;
  obstacle.rows = {4, 9};
  obstacle.cells = {-3, 1};
  parameters.obstacles = {obstacle};
  const Layout layout(parameters);
  EXPECT_FALSE(layout.is_free({4, 0}));
  EXPECT_FALSE(layout.is_free({4, 1}));
  EXPECT_TRUE(layout.is_free({4, 2}));
  EXPECT_FALSE(layout.is_free({5, 0})) << "not on the grid";
}

TEST(Steps, MoveAndTurn) {
  const Layout layout(drawn_ground());
  RoadUser body = somebody(0, 2);
  EXPECT_EQ(step(body, layout, Direction::right, 1, 7), "");
  EXPECT_EQ(body.place.x, 1);
  EXPECT_EQ(body.place.y, 2);
  EXPECT_EQ(body.facing, Direction::right);
  EXPECT_EQ(body.step_in(7), 1);
  EXPECT_EQ(body.step_in(8), 0) << "in another tick it stands";
}

TEST(Steps, MayBePartsOfACell) {
  const Layout layout(drawn_ground());
  RoadUser body = somebody(0, 0);
  for (int tick = 1; tick <= 10; ++tick)
    EXPECT_EQ(step(body, layout, Direction::right, 0.1, tick), "");
  EXPECT_EQ(body.place.x, 1) << "exactly";
}

TEST(Steps, AreCutAtTheEdgeAndRefusedThere) {
  const Layout layout(drawn_ground());
  RoadUser body = somebody(4, 8);
  EXPECT_EQ(step(body, layout, Direction::forward, 5, 1), "");
  EXPECT_EQ(body.place.y, 9);
  EXPECT_EQ(step(body, layout, Direction::forward, 1, 2),
            "a step forward from (4,9) leaves the grid");
  EXPECT_EQ(step(body, layout, Direction::right, 1, 2), "a step right from (4,9) leaves the grid");
  EXPECT_EQ(body.place.y, 9);
}

TEST(Steps, AreBlockedByWhatIsOnTheWay) {
  const Layout layout(drawn_ground());
  RoadUser body = somebody(0, 4);
  EXPECT_EQ(step(body, layout, Direction::right, 1, 1), "a step right from (0,4) is blocked");
  EXPECT_EQ(step(body, layout, Direction::right, 2, 1), "a step right from (0,4) is blocked")
      << "not over it either";
  EXPECT_EQ(body.place.x, 0);
  RoadUser car = somebody(1, 2, ActorKind::vehicle);
  EXPECT_EQ(step(car, layout, Direction::forward, 8, 1), "a step forward from (1,2) is blocked");
}

// The middle of row 0 is 0.5 cells before the parked car of row 1, a pedestrian's body reaches 0.25
// m.
TEST(Steps, KeepBodiesOutOfWhatIsBlocked) {
  const Layout layout(drawn_ground());
  const double body_cells = 0.25 / layout.cell_m();
  RoadUser body = somebody(0, 4);
  EXPECT_EQ(step(body, layout, Direction::right, 0.3, 1), "");
  EXPECT_EQ(step(body, layout, Direction::right, 0.1, 2), "a step right from (0.3,4) is blocked");
  EXPECT_EQ(step(body, layout, Direction::right, 0.5 - body_cells - 0.3, 3), "") << "touches it";
  EXPECT_EQ(step(body, layout, Direction::forward, 3, 4), "") << "along it";
  EXPECT_EQ(step(body, layout, Direction::right, 0.5, 5), "");
}

TEST(Steps, KeepBodiesOutOfCorners) {
  const Layout layout(drawn_ground());
  RoadUser near = somebody(0, 3.4);
  EXPECT_EQ(step(near, layout, Direction::right, 0.5, 1), "a step right from (0,3.4) is blocked");
  RoadUser clear = somebody(0, 3.3);
  EXPECT_EQ(step(clear, layout, Direction::right, 0.5, 1), "");
}

TEST(Steps, TurnNobodyIntoWhatIsBlocked) {
  const Layout layout(drawn_ground());
  RoadUser cyclist = somebody(0, 3, ActorKind::cyclist);
  cyclist.facing = Direction::right;
  EXPECT_EQ(step(cyclist, layout, Direction::right, 1, 1), "");
  EXPECT_EQ(step(cyclist, layout, Direction::back, 0, 2), "a step back from (1,3) is blocked")
      << "lengthways it is 1.8 m";
}

TEST(Steps, LeadAwayFromWhatABodyLiesOver) {
  CrossingParameters small = drawn_ground();
  small.cell_m = 0.3;
  const Layout layout(small);
  RoadUser body = somebody(0, 4);
  EXPECT_EQ(step(body, layout, Direction::back, 0.1, 1), "");
  EXPECT_EQ(step(body, layout, Direction::back, 3, 2), "");
  EXPECT_EQ(step(body, layout, Direction::forward, 2, 3), "a step forward from (0,0.9) is blocked");
}

TEST(Steps, LeadVehiclesOffTheRoad) {
  const Layout layout(drawn_ground());
  RoadUser car = somebody(2, 1, ActorKind::vehicle);
  EXPECT_EQ(step(car, layout, Direction::back, 3, 1), "");
  EXPECT_TRUE(car.gone);
  EXPECT_EQ(car.place.y, -2);
  EXPECT_EQ(step(car, layout, Direction::back, 3, 2), "it has left the road");
}

TEST(Steps, GoOnForThoseWhoAreGoneUntilTheyAreOutOfSight) {
  const Layout layout(drawn_ground());
  RoadUser car = somebody(2, 1, ActorKind::cyclist);
  ASSERT_EQ(step(car, layout, Direction::back, 3, 1), "");
  leave(car, layout, 6, 2);
  EXPECT_EQ(car.place.y, -5);
  EXPECT_EQ(car.step_in(2), 3);
  leave(car, layout, 6, 3);
  EXPECT_EQ(car.place.y, -8);
  leave(car, layout, 6, 4);
  EXPECT_EQ(car.place.y, -8) << "8 cells beyond the edge nobody sees it";
  EXPECT_EQ(car.step_in(4), 0);
}

TEST(Steps, OfThoseWhoMayNotLeaveNeverDo) {
  EXPECT_TRUE(somebody(0, 0, ActorKind::vehicle).may_leave());
  EXPECT_TRUE(somebody(0, 0, ActorKind::cyclist).may_leave());
  EXPECT_FALSE(somebody(0, 0, ActorKind::pedestrian).may_leave());
}

TEST(Directions, HaveHeadingsAndAreFoundByThem) {
  for (const Direction each :
       {Direction::left, Direction::right, Direction::forward, Direction::back}) {
    EXPECT_EQ(nearest_direction(heading_rad(each)), each);
    EXPECT_EQ(nearest_direction(heading_rad(each) + 0.7), each);
    EXPECT_EQ(nearest_direction(heading_rad(each) - 0.7), each);
    EXPECT_EQ(nearest_direction(heading_rad(each) + 2 * std::numbers::pi), each);
  }
}

TEST(HalfExtents, FollowTheWayABodyFaces) {
  RoadUser car = somebody(0, 0, ActorKind::vehicle);
  const BoxSize size = size_of(ActorKind::vehicle);
  car.facing = Direction::forward;
  EXPECT_EQ(half_extent(car).length_m, size.length_m / 2);
  car.facing = Direction::left;
  EXPECT_EQ(half_extent(car).length_m, size.width_m / 2);
  EXPECT_EQ(half_extent(car).width_m, size.length_m / 2);
}

TEST(Words, OfSignalsAndCrosswalks) {
  EXPECT_EQ(name(SignalColour::green), "green");
  EXPECT_EQ(name(SignalColour::red), "red");
  EXPECT_EQ(name(CrosswalkKind::zebra), "zebra");
  EXPECT_EQ(name(CrosswalkKind::signalled), "signalled");
}

}  // namespace
}  // namespace jaywalk
