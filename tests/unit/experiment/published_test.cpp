// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/published/published.h"

#include <array>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

const PublishedRows kShown{
    .behaviours = {"random_action", "random_behaviour", "proximity", "election", "intersect"},
    .left_out = {}};
constexpr std::array kPublished = {"random_action", "random_behaviour", "proximity", "election"};
constexpr std::array kPublishedAgents = {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 15U, 20U};

std::optional<Estimate> figure(const char* measure, const char* behaviour, std::uint32_t agents) {
  return published_figure(kShown, *find_measure(measure), behaviour, agents);
}

TEST(PublishedFigures, HaveValuesAndIntervals) {
  const auto accuracy = figure("accuracy", "random_action", 1);
  ASSERT_TRUE(accuracy);
  EXPECT_EQ(accuracy->value, 16.0);
  EXPECT_FALSE(accuracy->low);
  const auto score = figure("score", "random_action", 1);
  ASSERT_TRUE(score);
  EXPECT_EQ(score->low, 74.265);
  EXPECT_EQ(score->high, 77.895);
  EXPECT_EQ(figure("score", "proximity", 1)->value, 86.99);
  EXPECT_EQ(figure("score", "election", 1)->value, 86.42);
}

TEST(PublishedFigures, CoverFourBehavioursAndTwelveAgentNumbers) {
  for (const char* behaviour : kPublished) {
    EXPECT_TRUE(has_published_figures(behaviour));
    for (const std::uint32_t agents : kPublishedAgents) {
      for (const char* measure : {"accuracy", "score", "combined_normalised", "ticks_all", "cpu"}) {
        EXPECT_TRUE(figure(measure, behaviour, agents))
            << measure << ' ' << behaviour << ' ' << agents;
      }
    }
  }
  EXPECT_FALSE(has_published_figures("intersect"));
  EXPECT_FALSE(figure("accuracy", "intersect", 1));
  EXPECT_FALSE(figure("accuracy", "election", 11));
  EXPECT_FALSE(figure("code_lines", "election", 1));
}

// The combined score was published, too: it is that of the published score and accuracy.
TEST(PublishedFigures, AgreeWithEachOther) {
  for (const char* behaviour : kPublished) {
    for (const std::uint32_t agents : kPublishedAgents) {
      const double score = *figure("score", behaviour, agents)->value;
      const double accuracy = *figure("accuracy", behaviour, agents)->value;
      EXPECT_NEAR((score * accuracy / 1000 + 0.45) / 4.71,
                  *figure("combined_normalised", behaviour, agents)->value, 0.001)
          << behaviour << ' ' << agents;
    }
  }
}

TEST(PublishedFigures, HaveScoresWithinTheirIntervals) {
  for (const char* behaviour : kPublished) {
    for (const std::uint32_t agents : kPublishedAgents) {
      const Estimate score = *figure("score", behaviour, agents);
      EXPECT_NEAR((*score.low + *score.high) / 2, *score.value, 0.001)
          << behaviour << ' ' << agents;
      EXPECT_LT(*score.low, *score.high);
    }
  }
}

TEST(PublishedFigures, AreThoseOfTheRowsThatMayBeShown) {
  const PublishedRows one{.behaviours = {"proximity"}, .left_out = "election runs another program"};
  const Measure& accuracy = *find_measure("accuracy");
  EXPECT_TRUE(published_figure(one, accuracy, "proximity", 1));
  EXPECT_FALSE(published_figure(one, accuracy, "election", 1));
  EXPECT_FALSE(published_figure({}, accuracy, "proximity", 1));
}

}  // namespace
}  // namespace jaywalk
