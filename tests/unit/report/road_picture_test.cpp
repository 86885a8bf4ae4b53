// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/charts/plot.h"

namespace jaywalk::reporting {
namespace {

using testing::HasSubstr;

/// A lane between two pavements: `wide` m across and `length` m along, from (2, 10).
Ground strip(double wide, double length) {
  const auto area = [&](AreaKind kind, double left, double right) {
    return Area{kind, {{left, 10}, {right, 10}, {right, 10 + length}, {left, 10 + length}}, false};
  };
  return {{area(AreaKind::lane, 3, 1 + wide), area(AreaKind::pavement, 2, 3),
           area(AreaKind::pavement, 1 + wide, 2 + wide)}};
}

TEST(RoadPicture, RunsAlongTheRoadFromMarginToMargin) {
  const Ground ground = strip(20, 100);
  const RoadPicture picture(ground);
  EXPECT_DOUBLE_EQ(picture.across(10), 6);
  EXPECT_DOUBLE_EQ(picture.across(110), 514);
  EXPECT_DOUBLE_EQ(picture.across(60), 260) << "the middle of 520";
  EXPECT_DOUBLE_EQ(picture.down(2), 2);
}

TEST(RoadPicture, IsTrueToScale) {
  const Ground ground = strip(20, 100);
  const RoadPicture picture(ground);
  EXPECT_DOUBLE_EQ(picture.length(10), 50.8);
  EXPECT_DOUBLE_EQ(picture.breadth(10), picture.length(10));
}

TEST(RoadPicture, BroadensALongRoadSoThatItCanBeSeen) {
  const Ground ground = strip(10, 1000);
  const RoadPicture picture(ground);
  EXPECT_DOUBLE_EQ(picture.breadth(10), 60);
  EXPECT_LT(picture.length(10), 6);
}

TEST(RoadPicture, FlattensABroadPlace) {
  const Ground ground = strip(100, 100);
  EXPECT_DOUBLE_EQ(RoadPicture(ground).breadth(100), 260);
}

TEST(RoadPicture, DrawsLanesOverPavementsAndContentOverBoth) {
  const Ground ground = strip(20, 100);
  const std::string svg = RoadPicture(ground).draw("where they walk", "<circle/>");
  EXPECT_THAT(svg, HasSubstr("aria-label=\"where they walk\""));
  EXPECT_LT(svg.rfind("class=\"pavement\""), svg.find("class=\"lane\""));
  EXPECT_LT(svg.rfind("<polygon"), svg.find("<circle/>"));
}

TEST(RoadPicture, MarksMetresAlongTheWay) {
  const Ground ground = strip(20, 100);
  const std::string svg = RoadPicture(ground).draw("road", "");
  for (const char* mark : {">20<", ">40<", ">100<"}) EXPECT_THAT(svg, HasSubstr(mark));
}

TEST(RoadPicture, LeavesRoomForALegendBelowTheMarks) {
  const Ground ground = strip(20, 100);
  const RoadPicture picture(ground);
  EXPECT_DOUBLE_EQ(picture.legend_line(), picture.breadth(20) + 34);
}

TEST(RoadPicture, OfNoGroundIsAFrame) {
  const Ground nothing;
  const RoadPicture picture(nothing);
  EXPECT_DOUBLE_EQ(picture.across(0), 6);
  EXPECT_DOUBLE_EQ(picture.across(1), 514);
  EXPECT_THAT(picture.draw("road", ""), HasSubstr("<svg "));
}

}  // namespace
}  // namespace jaywalk::reporting
