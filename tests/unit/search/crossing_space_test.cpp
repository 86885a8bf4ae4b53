// SPDX-License-Identifier: Apache-2.0
#include "search/suts/crossing_space.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk::search {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Dimension number(std::string key, double from, double to) {
  return {.key = std::move(key), .from = from, .to = to};
}
Dimension whole(std::string key, double from, double to, int step = 1) {
  return {
      .key = std::move(key), .from = from, .to = to, .step = step, .kind = Dimension::Kind::whole};
}
Dimension word(std::string key, std::vector<std::string> words) {
  return {.key = std::move(key), .kind = Dimension::Kind::word, .words = std::move(words)};
}

TestInput at(std::vector<double> values) { return {Form::vector, std::move(values)}; }

TEST(CrossingSpace, SpreadsNumbersEvenly) {
  const CrossingSpace space({number("world.av.speed", 4, 14)}, "walk", {});
  EXPECT_THAT(space.settings(at({-1})), ElementsAre("world.av.speed=4"));
  EXPECT_THAT(space.settings(at({0})), ElementsAre("world.av.speed=9"));
  EXPECT_THAT(space.settings(at({0.5})), ElementsAre("world.av.speed=11.5"));
  EXPECT_THAT(space.settings(at({1})), ElementsAre("world.av.speed=14"));
}

TEST(CrossingSpace, GivesWholeNumbersEqualShares) {
  const CrossingSpace space({whole("world.width", 2, 8, 2)}, "walk", {});
  EXPECT_THAT(space.settings(at({-1})), ElementsAre("world.width=2"));
  EXPECT_THAT(space.settings(at({-0.51})), ElementsAre("world.width=2"));
  EXPECT_THAT(space.settings(at({-0.49})), ElementsAre("world.width=4"));
  EXPECT_THAT(space.settings(at({0.49})), ElementsAre("world.width=6"));
  EXPECT_THAT(space.settings(at({1})), ElementsAre("world.width=8"));
}

TEST(CrossingSpace, ChoosesWords) {
  const CrossingSpace space({word("world.kind", {"a", "b", "c"})}, "walk", {});
  EXPECT_THAT(space.settings(at({-1})), ElementsAre("world.kind=a"));
  EXPECT_THAT(space.settings(at({0})), ElementsAre("world.kind=b"));
  EXPECT_THAT(space.settings(at({1})), ElementsAre("world.kind=c"));
}

TEST(CrossingSpace, CountsTheValuesOfEachDimension) {
  const CrossingSpace space({number("a", 0, 1), whole("b", 1, 10, 3), word("c", {"x", "y"})},
                            "walk", {});
  EXPECT_EQ(space.dimension(), 3U);
  EXPECT_THAT(space.distinct_values(), ElementsAre(0, 4, 2)) << "0: as many as there are numbers";
}

TEST(CrossingSpace, WithoutDimensionsIsOneTest) {
  const CrossingSpace space({}, "walk", {});
  EXPECT_EQ(space.dimension(), 1U);
  EXPECT_THAT(space.distinct_values(), ElementsAre(1));
  EXPECT_THAT(space.settings(at({0})), IsEmpty());
}

TEST(CrossingSpace, RefusesWhatIsNoVectorWithinItsRanges) {
  const CrossingSpace space({number("a", 0, 1), number("b", 0, 1)}, "walk", {});
  EXPECT_EQ(space.check(at({0, 1})).message, "");
  EXPECT_EQ(space.check(at({0})).message, "expected a vector of 2 numbers");
  EXPECT_EQ(space.check({Form::points, {0, 1}}).message, "expected a vector of 2 numbers");
  EXPECT_EQ(space.check(at({0, 1.01})).message, "a number is not from -1 to 1");
}

TEST(CrossingSpace, DrawsTestsThatAreValid) {
  const CrossingSpace space({number("a", 0, 1), number("b", 0, 1)}, "walk", {});
  Random random(3);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(space.check(space.draw_initial(random)).message, "");
}

TEST(CrossingSpace, TellsParametersOfItsBehaviourFromSettingsOfTheWorld) {
  const CrossingSpace space(
      {number("world.av.speed", 4, 14), number("behaviours.walk.parameters.radius", 0, 10),
       word("behaviours.walk.parameters.way", {"left", "right"}),
       number("behaviours.run.parameters.radius", 0, 10)},
      "walk", {});
  const TestInput input = at({-1, 0, 1, 1});
  EXPECT_THAT(space.world_settings(input),
              ElementsAre("world.av.speed=4", "behaviours.run.parameters.radius=10"));
  const auto parameters = space.parameters(input);
  ASSERT_EQ(parameters.size(), 2U);
  EXPECT_EQ(parameters[0].name, "radius");
  EXPECT_EQ(parameters[0].values.at(0), ParameterValue(5.0));
  EXPECT_EQ(parameters[1].name, "way");
  EXPECT_EQ(parameters[1].values.at(0), ParameterValue(std::string("right")));
}

TEST(CrossingSpace, ReadsParametersThatAreNoPlainWordsAsAScenario) {
  const CrossingSpace space({word("behaviours.walk.parameters.p", {"[1, 2]", "x"}),
                             word("behaviours.walk.parameters.q", {"true", "false"})},
                            "walk", {});
  EXPECT_THAT(space.parameters(at({0, 0})), IsEmpty());
  EXPECT_EQ(space.world_settings(at({-1, -1})).size(), 2U);
}

TEST(CrossingSpace, SearchesStartsInRowsAndTheirCells) {
  const CrossingSpace space(
      {}, "walk",
      {.searched = 2, .rows = {0, 5}, .cells = {{1, 2, 3, 4}, {7, 9}}, .given = {}, .moves = {}});
  EXPECT_EQ(space.dimension(), 4U);
  EXPECT_THAT(space.distinct_values(), ElementsAre(2, 4, 2, 4));
  const auto starts = space.starts(at({-1, 1, 1, 1}));
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_EQ(starts[0].x, 0);
  EXPECT_EQ(starts[0].y, 4);
  EXPECT_EQ(starts[1].x, 5);
  EXPECT_EQ(starts[1].y, 9);
}

TEST(CrossingSpace, ChoosesAmongGivenStartsWithTheirMoves) {
  const CrossingSpace space(
      {number("world.av.speed", 4, 14)}, "walk",
      {.rows = {}, .cells = {}, .given = {{{1, 2}}, {{3, 4}}}, .moves = {"lr", "rr"}});
  EXPECT_EQ(space.dimension(), 2U);
  EXPECT_EQ(space.starts(at({0, 1})).at(0).x, 3);
  EXPECT_THAT(space.settings(at({-1, -1})),
              ElementsAre("world.av.speed=4", "behaviours.walk.parameters.moves=lr"));
  EXPECT_EQ(space.parameters(at({0, 1})).at(0).values.at(0), ParameterValue(std::string("rr")));
  EXPECT_EQ(space.describe(at({0, 1})), "world.av.speed 9, from row 3, cell 4, moves rr");
}

TEST(CrossingSpace, DescribesTestsByTheNamesOfParameters) {
  const CrossingSpace space({number("behaviours.walk.parameters.radius", 0, 10)}, "walk", {});
  EXPECT_EQ(space.describe(at({0})), "radius 5");
  EXPECT_THAT(space.starts(at({0})), IsEmpty()) << "chance decides";
}

}  // namespace
}  // namespace jaywalk::search
