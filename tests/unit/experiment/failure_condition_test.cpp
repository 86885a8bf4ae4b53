// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/failure_condition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

Summary with_accuracy(std::uint64_t percent) {
  return {.tests = 100, .successes = percent, .ticks_all = {.count = 100, .mean = 7.5}};
}

bool verdict(const char* text, std::uint64_t percent) {
  const Comparison comparison{.summaries = {with_accuracy(percent)}};
  return fails(parse_failure_condition(text).value(), comparison, 0);
}

TEST(FailureCondition, ComparesAMeasureWithANumber) {
  EXPECT_TRUE(verdict("accuracy<40", 39));
  EXPECT_FALSE(verdict("accuracy<40", 40));
  EXPECT_TRUE(verdict("accuracy<=40", 40));
  EXPECT_TRUE(verdict("accuracy > 39.5", 40));
  EXPECT_FALSE(verdict("accuracy>=41", 40));
  EXPECT_TRUE(verdict("accuracy_pct == 40", 40));
  EXPECT_FALSE(verdict("accuracy!=40", 40));
  EXPECT_TRUE(verdict("ticks_all<8", 0));
}

TEST(FailureCondition, IsMetByAMeasureWithoutAValue) {
  EXPECT_TRUE(verdict("score<1000", 0));
  EXPECT_TRUE(verdict("score>1000", 0));
  const Comparison errored{.summaries = {{.tests = 100, .errored = 100}}};
  EXPECT_TRUE(fails(parse_failure_condition("accuracy<40").value(), errored, 0));
  EXPECT_FALSE(fails(parse_failure_condition("errored>100").value(), errored, 0));
}

TEST(FailureCondition, RefusesWhatIsNoCondition) {
  for (const char* text :
       {"", "accuracy", "accuracy<", "<40", "accuracy=40", "accuracy<4x", "accuracy<nan"}) {
    EXPECT_FALSE(parse_failure_condition(text).ok()) << text;
  }
}

TEST(FailureCondition, SuggestsTheMeasureThatWasMeant) {
  const auto condition = parse_failure_condition("acuracy<40");
  EXPECT_THAT(condition.diagnostics().render(), HasSubstr("unknown measure 'acuracy'"));
  EXPECT_THAT(condition.diagnostics().render(), HasSubstr("did you mean 'accuracy'?"));
}

}  // namespace
}  // namespace jaywalk
