// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/measures/measures.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TestResult success(std::uint32_t ticks, double score) {
  return {.succeeded = true, .ticks = ticks, .score = score};
}

TestResult failure(std::uint32_t ticks) {
  return {.succeeded = false, .ticks = ticks, .score = -11};
}

double value(const char* name, const std::vector<TestResult>& tests) {
  return find_measure(name)->estimate(summarise(tests)).value.value();
}

TEST(Measures, TakeTheScoreFromSuccessfulTestsOnly) {
  const std::vector<TestResult> tests = {success(2, 96), failure(11), success(4, 90), failure(11)};
  EXPECT_EQ(value("score", tests), 93.0);
  EXPECT_EQ(value("accuracy", tests), 50.0);
  EXPECT_DOUBLE_EQ(value("combined", tests), 93.0 * 50 / 1000);
  EXPECT_DOUBLE_EQ(value("combined_normalised", tests), (4.65 + 0.45) / 4.71);
}

TEST(Measures, CountTheTicksOfFailedTestsInTheMeanOverAll) {
  const std::vector<TestResult> tests = {success(2, 96), failure(11), success(4, 90), failure(11)};
  EXPECT_EQ(value("ticks_success", tests), 3.0);
  EXPECT_EQ(value("ticks_all", tests), 7.0);
}

TEST(Measures, DoNotExistWithoutASuccessfulTest) {
  const std::array tests = {failure(11), failure(11)};
  const Summary summary = summarise(tests);
  for (const char* name : {"score", "combined", "combined_normalised", "ticks_success"}) {
    EXPECT_FALSE(find_measure(name)->estimate(summary).value) << name;
  }
  EXPECT_EQ(find_measure("accuracy")->estimate(summary).value, 0.0);
  EXPECT_EQ(find_measure("ticks_all")->estimate(summary).value, 11.0);
}

TEST(Measures, HaveNoIntervalForASingleSuccess) {
  const std::array tests = {success(3, 95), failure(11)};
  const Estimate score = find_measure("score")->estimate(summarise(tests));
  EXPECT_TRUE(score.value);
  EXPECT_FALSE(score.low);
  EXPECT_FALSE(score.high);
}

TEST(Measures, AreFoundByNameAndByColumn) {
  EXPECT_EQ(find_measure("accuracy"), find_measure("accuracy_pct"));
  EXPECT_NE(find_measure("accuracy"), nullptr);
  EXPECT_EQ(find_measure("acuracy"), nullptr);
}

}  // namespace
}  // namespace jaywalk
