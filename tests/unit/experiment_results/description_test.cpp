// SPDX-License-Identifier: Apache-2.0
#include "experiment/results/description.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

ExperimentDescription plan() {
  ExperimentDescription description;
  description.behaviours = {{.name = "a"}, {.name = "b"}};
  description.agents = {1, 5, 20};
  description.tests = 10;
  return description;
}

TEST(TestId, CountsInTheOrderOfThePlanFrom1) {
  EXPECT_EQ(test_id(plan(), {.behaviour = 0, .agents = 1, .number = 0}), 1);
  EXPECT_EQ(test_id(plan(), {.behaviour = 0, .agents = 5, .number = 3}), 14);
  EXPECT_EQ(test_id(plan(), {.behaviour = 1, .agents = 20, .number = 9}), 60);
}

TEST(TestId, CountsFromTheFirstTestOfThePlan) {
  ExperimentDescription description = plan();
  description.first_test = 100;
  EXPECT_EQ(test_id(description, {.behaviour = 0, .agents = 1, .number = 104}), 5);
  EXPECT_EQ(find_test(description, 5)->number, 104U);
}

TEST(FindTest, IsTheInverseOfTestId) {
  for (std::int64_t id = 1; id <= 60; ++id) {
    const auto test = find_test(plan(), id);
    ASSERT_TRUE(test);
    EXPECT_EQ(test_id(plan(), *test), id);
  }
  EXPECT_FALSE(find_test(plan(), 0));
  EXPECT_FALSE(find_test(plan(), 61));
}

TEST(Shard, IsReadFromItsIndexAndCount) {
  EXPECT_EQ(parse_shard("2/4"), (Shard{.index = 2, .count = 4}));
  for (const char* wrong : {"", "0/4", "5/4", "2", "2/", "/4", "2/4x", "-1/4", "2/ 4"}) {
    EXPECT_FALSE(parse_shard(wrong)) << wrong;
  }
}

TEST(Shards, ShareTheTestsAmongThem) {
  for (const std::uint32_t count : {1U, 2U, 3U, 7U, 13U}) {
    for (const std::uint64_t first : {0U, 1U, 8U}) {
      std::uint64_t all = 0;
      for (std::uint32_t index = 1; index <= count; ++index) {
        ExperimentDescription description = plan();
        description.first_test = first;
        description.shard = {.index = index, .count = count};
        std::uint64_t own = 0;
        for (std::uint64_t test = first; test < first + 10; ++test) {
          own += description.shard.has(test) ? 1U : 0U;
        }
        EXPECT_EQ(tests_in_shard(description), own);
        all += own;
      }
      EXPECT_EQ(all, 10U);
    }
  }
}

TEST(Difference, NamesTheFirstThingThatIsNotTheSame) {
  ExperimentDescription other = plan();
  EXPECT_EQ(difference(plan(), other), "");
  other.shard = {.index = 2, .count = 4};
  EXPECT_EQ(difference(plan(), other), "");
  other.agents = {1, 5};
  EXPECT_EQ(difference(plan(), other), "the numbers of agents are 1,5,20 and 1,5");
  other.seed = 3;
  EXPECT_EQ(difference(plan(), other), "the seeds are 0 and 3");
}

TEST(Difference, SeesTheTextsOfTheInputsAndNotTheirPaths) {
  ExperimentDescription one = plan();
  ExperimentDescription other = plan();
  one.inputs = {{.path = "a.asl", .text = "!a.", .sha256 = "1"}};
  other.inputs = {{.path = "/elsewhere/a.asl", .text = "!a.", .sha256 = "1"}};
  EXPECT_EQ(difference(one, other), "");
  other.inputs.front().sha256 = "2";
  EXPECT_EQ(difference(one, other), "the text of 'a.asl' is not the same");
}

}  // namespace
}  // namespace jaywalk
