// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/spawn.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

constexpr std::size_t kDraws = 8000;

std::map<int, int> draws_by_row(const CrossingParameters& parameters) {
  std::map<int, int> counts;
  for (const Position& position : spawn(parameters, kDraws, 7)) ++counts[position.x];
  return counts;
}

TEST(Spawn, LeavesTheDeadZonesOut) {
  const CrossingParameters paper;
  const std::map<int, int> dead{{0, 18}, {1, 12}, {10, 36}, {11, 54}};
  std::map<int, int> nearest;
  for (const Position& position : spawn(paper, kDraws, 1)) {
    ASSERT_TRUE(dead.contains(position.x)) << position.x;
    ASSERT_LE(position.y, 65);
    nearest.try_emplace(position.x, position.y);
    nearest[position.x] = std::min(nearest[position.x], position.y);
  }
  EXPECT_EQ(nearest, dead);  // with 2000 draws a row, every first cell turns up
}

TEST(Spawn, ChoosesTheRowFirst) {
  for (const auto& [row, count] : draws_by_row({})) EXPECT_NEAR(count, kDraws / 4.0, 160) << row;
}

TEST(Spawn, ChoosesAmongAllCellsWhenAsked) {
  CrossingParameters parameters;
  parameters.spawn.choose = SpawnChoice::cell;
  // 48, 54, 30 and 12 cells: 144 in all.
  std::map<int, int> counts = draws_by_row(parameters);
  EXPECT_NEAR(counts[0], kDraws * 48 / 144.0, 170);
  EXPECT_NEAR(counts[1], kDraws * 54 / 144.0, 175);
  EXPECT_NEAR(counts[10], kDraws * 30 / 144.0, 150);
  EXPECT_NEAR(counts[11], kDraws * 12 / 144.0, 100);
}

TEST(Spawn, DependsOnTheSeed) {
  const CrossingParameters paper;
  EXPECT_EQ(spawn(paper, 20, 1), spawn(paper, 20, 1));
  EXPECT_NE(spawn(paper, 20, 1), spawn(paper, 20, 2));
}

TEST(Spawn, BeginsALargeGroupLikeASmallOne) {
  const CrossingParameters paper;
  const std::vector<Position> small = spawn(paper, 3, 5);
  const std::vector<Position> large = spawn(paper, 20, 5);
  EXPECT_TRUE(std::equal(small.begin(), small.end(), large.begin()));
}

TEST(Spawn, KeepsBodiesOutOfObstacles) {
  CrossingParameters parameters;
  parameters.spawn.dead_zones.clear();
  parameters.cell_m = 0.4;
  parameters.obstacles = {{{0, 0}, {20, 20}}};
  const std::vector<Position> cells = free_spawn_cells(parameters);
  const auto may_begin = [&](Position where) {
    return std::ranges::find(cells, where) != cells.end();
  };
  EXPECT_FALSE(may_begin({0, 20}));
  EXPECT_FALSE(may_begin({0, 19})) << "a body of 0.5 m in a cell of 0.4 m";
  EXPECT_FALSE(may_begin({1, 21}));
  EXPECT_TRUE(may_begin({0, 18}));
  EXPECT_EQ(cells.size(), 4U * 66 - 6);
}

TEST(Spawn, FollowsOtherBandsAndDeadZones) {
  CrossingParameters parameters;
  parameters.bands = {{BandKind::lane, 2, Direction::forward}, {BandKind::pavement, 1}};
  parameters.spawn.dead_zones = {{2, 60}};
  for (const Position& position : spawn(parameters, 50, 3)) {
    EXPECT_EQ(position.x, 2);
    EXPECT_GE(position.y, 60);
  }
}

}  // namespace
}  // namespace jaywalk
