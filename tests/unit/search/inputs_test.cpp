// SPDX-License-Identifier: Apache-2.0
// Inputs of searches, what they are worth, and the ranges that a search reads.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/sut.h"
#include "search/suts/crossing_space.h"
#include "search/test_input.h"
#include "tests/helpers/config_nodes.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

using test::list;
using test::map;
using test::scalar;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Forms, HaveNamesThatAreRead) {
  for (const Form form : {Form::vector, Form::sequence, Form::points}) {
    EXPECT_EQ(parse_form(name(form)), form);
  }
  EXPECT_EQ(parse_form("vectors"), std::nullopt);
  EXPECT_EQ(parse_form(""), std::nullopt);
}

TEST(SearchSpaces, DescribeInputsWithFourDigits) {
  const Square space;
  EXPECT_EQ(space.describe({Form::vector, {0.5, -1.0 / 3}}), "0.5 -0.3333");
  EXPECT_EQ(space.describe({Form::vector, {}}), "");
}

TEST(SearchSpaces, DistinguishAnyTwoNumbersUnlessTheySayOtherwise) {
  EXPECT_THAT(Square().distinct_values(), ElementsAre(0, 0));
}

TEST(FitnessTest, IsTheShareOfTheWayFromHarmlessToWorst) {
  const Fitness fitness{.harmless = 2, .worst = 6};
  EXPECT_EQ(fitness.of({.measures = {2}}), 0);
  EXPECT_EQ(fitness.of({.measures = {5}}), 0.75);
  EXPECT_EQ(fitness.of({.measures = {6}}), 1);
  EXPECT_EQ(fitness.of({.measures = {100}}), 1) << "beyond the worst";
  EXPECT_EQ(fitness.of({.measures = {-100}}), 0);
}

TEST(FitnessTest, MayRiseAsAMeasureFalls) {
  const Fitness distance{.harmless = 10, .worst = 0};
  EXPECT_EQ(distance.of({.measures = {10}}), 0);
  EXPECT_EQ(distance.of({.measures = {4}}), 0.6);
  EXPECT_EQ(distance.of({.measures = {0}}), 1);
}

TEST(FitnessTest, TakesTheMeasureThatIsMeant) {
  const Fitness second{.measure = 1};
  EXPECT_EQ(second.of({.measures = {1, 0.25}}), 0.25);
  EXPECT_EQ(second.of({.measures = {1}}), 0) << "which is not there";
}

TEST(FitnessTest, OfATestWithoutResultIsNothing) {
  EXPECT_EQ(Fitness().of({.error = "no such road", .measures = {1}}), 0);
}

TEST(FitnessTest, FailsFromItsBoundOn) {
  const Fitness fitness{.fails_at = 0.5};
  EXPECT_TRUE(fitness.fails(0.5));
  EXPECT_FALSE(fitness.fails(0.499));
}

TEST(Measures, AreFoundByName) {
  constexpr std::array kMeasures{MeasureKind{"near", ""}, MeasureKind{"far", ""}};
  EXPECT_EQ(find_measure(kMeasures, "far"), 1U);
  EXPECT_EQ(find_measure(kMeasures, "nowhere"), std::nullopt);
}

TEST(RandomSequences, HaveNeighboursThatHardlyDiffer) {
  Random random(1);
  std::vector<double> values;
  append_random(values, 2000, random);
  ASSERT_EQ(values.size(), 2000U);
  double last = 0;
  double widest = 0;
  for (const double value : values) {
    EXPECT_LE(std::fabs(value), 1);
    EXPECT_LE(std::fabs(value - last), kMostDifference + 1e-12);
    widest = std::max(widest, std::fabs(value - last));
    last = value;
  }
  EXPECT_GT(widest, 0.95 * kMostDifference) << "the whole range is used";
}

TEST(RandomSequences, GoOnWhereASequenceEnds) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> values{0.9};
    append_random(values, 1, random);
    EXPECT_EQ(values[0], 0.9);
    EXPECT_GE(values[1], 0.9 - kMostDifference);
  }
}

TEST(RandomSequences, AreOfEachUsualLength) {
  Random random(3);
  const SequenceBounds bounds{.least = 1, .usual = 10, .spread = 2};
  std::vector<int> lengths(20);
  for (int i = 0; i < 500; ++i) {
    const TestInput input = draw_sequence(bounds, random);
    EXPECT_EQ(input.form, Form::sequence);
    ++lengths.at(input.values.size());
  }
  for (std::size_t length = 0; length < lengths.size(); ++length) {
    if (length >= 8 && length <= 12) {
      EXPECT_GT(lengths[length], 50) << length;
    } else {
      EXPECT_EQ(lengths[length], 0) << length;
    }
  }
}

/// The dimensions read from a map of ranges, and the errors about it.
struct Dimensions {
  void read(const ConfigNode& node) { read_dimensions(node, ConfigReader(diagnostics), all); }

  std::vector<Dimension> all;
  Diagnostics diagnostics;
};

TEST(Dimensions, ArePairsOfNumbers) {
  Dimensions read;
  read.read(map({{"world.av.speed", list({"4", "14.5"})}}));
  ASSERT_EQ(read.all.size(), 1U);
  EXPECT_EQ(read.all[0].key, "world.av.speed");
  EXPECT_EQ(read.all[0].kind, Dimension::Kind::number);
  EXPECT_EQ(read.all[0].from, 4);
  EXPECT_EQ(read.all[0].to, 14.5);
}

TEST(Dimensions, AreWholeNumbersWithAStep) {
  Dimensions read;
  read.read(map({{"world.length", map({{"whole", list({"10", "20"})}, {"step", scalar("5")}})},
                 {"world.width", map({{"whole", list({"1", "3"})}})}}));
  ASSERT_EQ(read.all.size(), 2U);
  EXPECT_EQ(read.all[0].kind, Dimension::Kind::whole);
  EXPECT_EQ(read.all[0].step, 5);
  EXPECT_EQ(read.all[1].step, 1);
}

TEST(Dimensions, AreWordsAndListsOfNumbersThatAreNoPair) {
  Dimensions read;
  read.read(
      map({{"a", list({"zebra", "signalled"})}, {"b", list({"1", "2", "4"})}, {"c", list({"2"})}}));
  ASSERT_EQ(read.all.size(), 3U);
  for (const Dimension& each : read.all) {
    EXPECT_EQ(each.kind, Dimension::Kind::word) << each.key;
  }
  EXPECT_THAT(read.all[1].words, ElementsAre("1", "2", "4"));
}

TEST(Dimensions, MayStandInMapsWithinMaps) {
  Dimensions read;
  read.read(map({{"world", map({{"av", map({{"speed", list({"1", "2"})}})}})}}));
  ASSERT_EQ(read.all.size(), 1U);
  EXPECT_EQ(read.all[0].key, "world.av.speed");
}

TEST(Dimensions, TakeThePlaceOfEarlierOnesOfTheirKey) {
  Dimensions read;
  read.read(map({{"a", list({"1", "2"})}, {"b", list({"1", "2"})}}));
  read.read(map({{"a", map({{"whole", list({"5", "6"})}})}}));
  ASSERT_EQ(read.all.size(), 2U);
  EXPECT_EQ(read.all[1].key, "a");
  EXPECT_EQ(read.all[1].kind, Dimension::Kind::whole);
}

TEST(Dimensions, SayWhatIsNone) {
  Dimensions read;
  read.read(scalar("speed"));
  read.read(
      map({{"a", scalar("3")}, {"b", list({"2", "1"})}, {"c", map({{"whole", scalar("1")}})}}));
  EXPECT_TRUE(read.all.empty());
  EXPECT_EQ(read.diagnostics.error_count(), 4U);
  EXPECT_THAT(read.diagnostics.render(), HasSubstr("keys of the scenario and their ranges"));
}

}  // namespace
}  // namespace jaywalk::search
