#include "experiment/published/published.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(PublishedFigures, HaveValuesAndIntervals) {
  const auto accuracy = published_figure(*find_measure("accuracy"), "random_action", 1);
  ASSERT_TRUE(accuracy);
  EXPECT_EQ(accuracy->value, 16.0);
  EXPECT_FALSE(accuracy->low);
  const auto score = published_figure(*find_measure("score"), "random_action", 1);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->low, 74.265);
  EXPECT_EQ(score->high, 77.895);
}

TEST(PublishedFigures, CoverFourBehavioursAndTwelveAgentNumbers) {
  for (const char* behaviour : {"random_action", "random_behaviour", "proximity", "election"}) {
    for (const std::uint32_t agents : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 15U, 20U}) {
      for (const char* measure : {"accuracy", "score", "combined_normalised", "ticks_all", "cpu"}) {
        EXPECT_TRUE(published_figure(*find_measure(measure), behaviour, agents))
            << measure << ' ' << behaviour << ' ' << agents;
      }
    }
  }
  EXPECT_FALSE(published_figure(*find_measure("accuracy"), "intersect", 1));
  EXPECT_FALSE(published_figure(*find_measure("accuracy"), "election", 11));
  EXPECT_FALSE(published_figure(*find_measure("code_lines"), "election", 1));
}

}  // namespace
}  // namespace jaywalk
