// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/openscenario/road_plan.h"
#include "tests/unit/export/crossings.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string drive_of(const CrossingParameters& world) {
  return to_opendrive(plan_roads(world), world.cell_m);
}

std::size_t occurrences(const std::string& text, std::string_view of) {
  std::size_t count = 0;
  for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) ++count;
  return count;
}

/// The numbers of an attribute, in the order of the document.
std::vector<double> attributes(const std::string& text, const std::string& name) {
  std::vector<double> values;
  const std::string begin = " " + name + "=\"";
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
    const std::string value =
        text.substr(at + begin.size(), text.find('"', at + begin.size()) - at);
    if (value.find_first_of("-.0123456789") == 0) values.push_back(std::stod(value));
  }
  return values;
}

TEST(OpenDrive, SaysHowLargeTheWorldIs) {
  EXPECT_THAT(drive_of({}), HasSubstr("<header revMajor=\"1\" revMinor=\"6\" name=\"jaywalk "
                                      "crossing\" version=\"1\" north=\"99.0000\" south=\"0\" "
                                      "east=\"18.0000\" west=\"0\"/>"));
}

TEST(OpenDrive, WritesLanesFromTheFarLeftToTheFarRight) {
  const std::string text = drive_of({});
  const std::size_t left = text.find("<lane id=\"2\" type=\"sidewalk\"");
  const std::size_t centre = text.find("<lane id=\"0\" type=\"none\"");
  const std::size_t right = text.find("<lane id=\"-2\" type=\"sidewalk\"");
  ASSERT_NE(left, std::string::npos);
  ASSERT_NE(right, std::string::npos);
  EXPECT_LT(left, centre);
  EXPECT_LT(centre, right);
  EXPECT_THAT(text, HasSubstr("<width sOffset=\"0\" a=\"6.0000\" b=\"0\" c=\"0\" d=\"0\"/>"));
}

TEST(OpenDrive, HasNoSideWithoutLanes) {
  CrossingParameters world;
  world.bands = {{BandKind::pavement, 2}, {BandKind::lane, 4, Direction::back}};
  const std::string text = drive_of(world);
  EXPECT_THAT(text, Not(HasSubstr("<left>")));
  EXPECT_THAT(text, HasSubstr("<right>"));
}

TEST(OpenDrive, DrivesOnTheLeft) {
  const std::string text = drive_of({});
  EXPECT_EQ(occurrences(text, "rule=\"LHT\""), occurrences(text, "<road "));
}

TEST(OpenDrive, PutsAnObjectAtItsMiddleWithItsOutlineAround) {
  CrossingParameters world;
  world.obstacles = {{{0, 1}, {4, 7}}};
  const std::string text = drive_of(world);
  // Cells 4 to 7 are 6 m to 12 m along; rows 0 and 1 lie on the left side of x = 9 m, 6 m to 9 m
  // away.
  EXPECT_THAT(text, HasSubstr("<object type=\"obstacle\" id=\"1\" name=\"obstacle1\" s=\"9.0000\" "
                              "t=\"7.5000\""));
  EXPECT_THAT(text, HasSubstr("length=\"6.0000\" width=\"3.0000\" height=\"1.5\""));
  EXPECT_THAT(attributes(text, "u"), testing::ElementsAre(-3, 3, 3, -3));
  EXPECT_THAT(attributes(text, "v"), testing::ElementsAre(-1.5, -1.5, 1.5, 1.5));
}

TEST(OpenDrive, KeepsTheOriginOfAnObjectOnTheRoad) {
  CrossingParameters world;
  world.obstacles = {{{0, 1}, {64, 75}}};
  const std::string text = drive_of(world);
  // Its middle would be at 105 m; the outline still reaches from 96 m to 114 m.
  EXPECT_THAT(text, HasSubstr("name=\"obstacle1\" s=\"99.0000\""));
  EXPECT_THAT(attributes(text, "u"), testing::ElementsAre(-3, 15, 15, -3));
}

TEST(OpenDrive, SetsSignalsWithTheirController) {
  const std::string text = drive_of(crosswalk_world(CrosswalkKind::signalled, {20, 22}));
  EXPECT_THAT(text, HasSubstr("<signal s=\"30.0000\" t=\"6.0000\" id=\"1\" name=\"signal1\" "
                              "dynamic=\"yes\" orientation=\"+\""));
  EXPECT_THAT(text, HasSubstr("id=\"2\" name=\"signal1\" dynamic=\"yes\" orientation=\"-\""));
  EXPECT_THAT(text, HasSubstr("<controller id=\"1\" name=\"signal1\">\n"
                              "    <control signalId=\"1\" type=\"0\"/>\n"
                              "    <control signalId=\"2\" type=\"0\"/>\n"
                              "  </controller>\n"));
}

TEST(OpenDrive, OfARoadAloneHasNoLinksSignalsOrJunctions) {
  const std::string text = drive_of({});
  for (const char* element : {"<link>", "<signals>", "<controller", "<junction", "<objects>"}) {
    EXPECT_THAT(text, Not(HasSubstr(element)));
  }
}

TEST(OpenDriveJunction, LinksRoadsToIt) {
  const std::string text = drive_of(junction_world());
  EXPECT_EQ(occurrences(text, "<successor elementType=\"junction\" elementId=\"1001\"/>"), 2U);
  EXPECT_EQ(occurrences(text, "<predecessor elementType=\"junction\" elementId=\"1001\"/>"), 2U);
}

TEST(OpenDriveJunction, HasARoadForEachWayThroughIt) {
  const CrossingParameters world = junction_world();
  const RoadPlan plan = plan_roads(world);
  const std::string text = to_opendrive(plan, world.cell_m);
  EXPECT_EQ(occurrences(text, "junction=\"1001\""), plan.junctions[0].connections.size());
  EXPECT_EQ(occurrences(text, "contactPoint=\"start\">\n      <laneLink"),
            plan.junctions[0].connections.size());
  EXPECT_THAT(text, HasSubstr("<junction id=\"1001\" name=\"junction 1001\">"));
}

/// A plan of one connection between two lane ends.
RoadPlan bend(LaneEnd from, LaneEnd to) {
  RoadPlan plan;
  plan.junctions = {{.id = 7, .connections = {{.road = 100, .from = from, .to = to}}}};
  return plan;
}

TEST(OpenDriveJunction, GoesStraightWhereTheLanesLieOpposite) {
  const std::string text = to_opendrive(
      bend({.road = 1, .lane = 1, .width_m = 3}, {.road = 2, .lane = 1, .x_m = 10, .width_m = 3}),
      1);
  EXPECT_THAT(text, HasSubstr("length=\"10.0000\" id=\"100\" junction=\"7\""));
  EXPECT_THAT(text, HasSubstr("bU=\"10.000000\" cU=\"0.000000\" dU=\"0.000000\" aV=\"0\" bV=\"0\" "
                              "cV=\"0.000000\" dV=\"0.000000\""));
}

TEST(OpenDriveJunction, TurnsWithTheHeadingsOfBothLanes) {
  const double quarter = std::acos(0.0);
  const std::string text =
      to_opendrive(bend({.road = 1, .lane = 1, .width_m = 3},
                        {.road = 2, .x_m = 5, .y_m = 5, .heading_rad = quarter, .width_m = 3}),
                   1);
  const double b = attributes(text, "bU")[0];
  const double c = attributes(text, "cU")[0];
  const double d = attributes(text, "dU")[0];
  const double cv = attributes(text, "cV")[0];
  const double dv = attributes(text, "dV")[0];
  EXPECT_NEAR(b + c + d, 5, 1e-5) << "it ends where the other lane begins";
  EXPECT_NEAR(cv + dv, 5, 1e-5);
  EXPECT_GT(b, 0) << "it begins along its lane";
  EXPECT_NEAR(b + 2 * c + 3 * d, 0, 1e-5) << "it ends along the other lane";
  EXPECT_GT(2 * cv + 3 * dv, 0);
}

TEST(OpenDriveJunction, IsAsLongAsItsCurve) {
  const double quarter = std::acos(0.0);
  const std::string text =
      to_opendrive(bend({.road = 1, .width_m = 3},
                        {.road = 2, .x_m = 5, .y_m = 5, .heading_rad = quarter, .width_m = 3}),
                   1);
  const double length = attributes(text, "length")[0];
  EXPECT_GT(length, std::hypot(5, 5)) << "longer than the chord";
  EXPECT_LT(length, 10) << "shorter than the way round the corner";
  EXPECT_NEAR(length, 5 * quarter, 0.2) << "nearly a quarter of a circle";
}

TEST(OpenDriveJunction, WidensFromTheOneLaneToTheOther) {
  const std::string text = to_opendrive(
      bend({.road = 1, .lane = 1, .width_m = 3}, {.road = 2, .lane = -2, .x_m = 10, .width_m = 5}),
      1);
  EXPECT_THAT(text, HasSubstr("<laneOffset s=\"0\" a=\"-1.5000\" b=\"-0.100000\""));
  EXPECT_THAT(text, HasSubstr("<width sOffset=\"0\" a=\"3.0000\" b=\"0.200000\""));
  EXPECT_THAT(text, HasSubstr("<link><predecessor id=\"1\"/><successor id=\"-2\"/></link>"));
}

TEST(OpenDrive, IsADocument) {
  const std::string text = drive_of(junction_world());
  EXPECT_THAT(text, StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenDRIVE>\n"));
  EXPECT_THAT(text, testing::EndsWith("</OpenDRIVE>\n"));
  for (const char* element : {"road", "lanes", "laneSection", "object", "junction", "planView"}) {
    EXPECT_EQ(occurrences(text, std::string("<") + element + ">") +
                  occurrences(text, std::string("<") + element + " "),
              occurrences(text, std::string("</") + element + ">"))
        << element;
  }
}

}  // namespace
}  // namespace jaywalk
