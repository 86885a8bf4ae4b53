// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "env/crossing/layout.h"
#include "env/crossing/parameters.h"

namespace jaywalk {
namespace {

TEST(Ground, HasTheBandsOfTheCrossingInMetres) {
  const Ground paper = ground(CrossingParameters{});
  ASSERT_EQ(paper.areas.size(), 4U);
  EXPECT_EQ(paper.areas[0].kind, AreaKind::pavement);
  EXPECT_TRUE(contains(paper.areas[0], {1.5, 50}));
  ASSERT_NE(paper.av_lane(), nullptr);
  EXPECT_TRUE(contains(*paper.av_lane(), {3, 50})) << "its edge belongs to it";
  EXPECT_TRUE(contains(*paper.av_lane(), {8.9, 98.9}));
  EXPECT_FALSE(contains(*paper.av_lane(), {9.1, 50}));
  EXPECT_FALSE(contains(*paper.av_lane(), {5, 99.1}));
}

TEST(Ground, OfAMapHasItsRoadsAndTheAvsWay) {
  CrossingParameters parameters;
  parameters.map = {"....", ">>x>", ">>x>", "..x."};
  parameters.bands = {{BandKind::pavement, 1}, {BandKind::lane, 2}, {BandKind::pavement, 1}};
  parameters.length = 4;
  parameters.av.rows = {1, 2};
  const Ground map = ground(parameters);
  ASSERT_NE(map.av_lane(), nullptr);
  EXPECT_TRUE(contains(*map.av_lane(), {2, 3}));
  EXPECT_FALSE(contains(*map.av_lane(), {1, 3}));
  const auto on_road = [&](Point point) {
    for (const Area& area : map.areas) {
      if (area.kind == AreaKind::lane && contains(area, point)) return true;
    }
    return false;
  };
  EXPECT_TRUE(on_road({5.25, 3.75})) << "the side road";
  EXPECT_FALSE(on_road({5.25, 0.75}));
}

}  // namespace
}  // namespace jaywalk
