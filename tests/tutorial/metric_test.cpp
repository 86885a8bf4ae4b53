// SPDX-License-Identifier: Apache-2.0
// The metric that docs/internals/add_metric.md adds works as the page says.

#include <gtest/gtest.h>

#include "experiment/judge/metrics/metrics.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

// The AV is 4 m long and passes a pedestrian 1 m beside its side, 2 m a tick: their boxes are less
// than 2 m apart while its middle is less than 2 + 0.25 + sqrt(3) m before or behind.
TEST(MetricTutorial, HasAMetricThatCountsSeconds) {
  const Recording past = drive(0.5, {steps({0, 0}, {0, 2}, 11), steps({2.25, 10}, {0, 0}, 11)});
  const Ground ground = road();
  const Metric* const metric = find_metric("time_near");
  ASSERT_NE(metric, nullptr);
  const auto value = measured(*metric, TestView(past, ground));
  ASSERT_TRUE(value);
  EXPECT_DOUBLE_EQ(value->value, 1.5);
  EXPECT_EQ(value->tick, 4U);
}

TEST(MetricTutorial, LeavesTheOtherMetricsWhereTheyAre) {
  EXPECT_NE(find_metric("min_ttc"), nullptr);
  EXPECT_EQ(metrics().back().name, "time_near");
}

}  // namespace
}  // namespace jaywalk
