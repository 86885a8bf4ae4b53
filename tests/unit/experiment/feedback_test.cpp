// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/feedback.h"

#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two tests cover each generation of two; the first item has the bins left and right.
class Feedback : public testing::Test {
 protected:
  /// A test that covers a bin of the first item is over.
  void finish(std::uint64_t number, std::uint32_t bin, std::uint32_t agents = 1) {
    const TestKey test{.agents = agents, .number = number};
    SituationBins bins(situation_items().size());
    bins[0] = bin;
    table_.add(test, bins);
    feedback_.finished(test);
  }
  std::optional<std::vector<CoveredBin>> told(std::uint64_t number, std::uint32_t agents = 1) {
    return feedback_.wait_for({.agents = agents, .number = number});
  }

  ExperimentPlan plan_{.behaviours = {"walk"}, .agents = {1, 3}, .tests = 5};
  SituationTable table_{plan_};
  CoverageFeedback feedback_{plan_, 2, table_};
};

const std::string kItem(situation_items()[0].name);

TEST_F(Feedback, IsNothingForTheFirstGeneration) {
  EXPECT_THAT(*told(0), IsEmpty());
  EXPECT_THAT(*told(1), IsEmpty());
}

TEST_F(Feedback, IsWhatTheGenerationsBeforeCovered) {
  finish(0, 0);
  finish(1, 0);
  EXPECT_THAT(*told(2), ElementsAre(CoveredBin{kItem, 1, 2}));
  finish(2, 1);
  finish(3, 0);
  EXPECT_THAT(*told(4), ElementsAre(CoveredBin{kItem, 1, 3}, CoveredBin{kItem, 2, 1}));
  EXPECT_THAT(*told(2), ElementsAre(CoveredBin{kItem, 1, 2})) << "as when it was first asked";
}

TEST_F(Feedback, IsTheSameInWhateverOrderTestsEnd) {
  finish(3, 0);
  finish(1, 1);
  finish(2, 0);
  finish(0, 0);
  EXPECT_THAT(*told(2), ElementsAre(CoveredBin{kItem, 1, 1}, CoveredBin{kItem, 2, 1}));
  EXPECT_THAT(*told(4), ElementsAre(CoveredBin{kItem, 1, 3}, CoveredBin{kItem, 2, 1}));
}

TEST_F(Feedback, BelongsToOneNumberOfAgents) {
  finish(0, 0);
  finish(1, 0);
  finish(0, 1, 3);
  finish(1, 1, 3);
  EXPECT_THAT(*told(2, 3), ElementsAre(CoveredBin{kItem, 2, 2}));
}

TEST_F(Feedback, WaitsForTheGenerationBefore) {
  finish(0, 0);
  std::optional<std::vector<CoveredBin>> found;
  {
    const std::jthread waiting([&] { found = told(2); });
    finish(1, 1);
  }
  ASSERT_TRUE(found);
  EXPECT_EQ(found->size(), 2U);
}

TEST_F(Feedback, EndsForAllWhereItIsGivenUp) {
  feedback_.give_up();
  EXPECT_FALSE(told(2));
  EXPECT_FALSE(told(0)) << "nobody begins another test";
}

TEST(FeedbackText, RoundTrips) {
  const std::vector<CoveredBin> feedback{{"entry_ttc", 3, 17}, {"start_side", 1, 40}};
  EXPECT_EQ(feedback_text(feedback), "entry_ttc 3 17; start_side 1 40");
  EXPECT_EQ(parse_feedback(feedback_text(feedback)), feedback);
  EXPECT_EQ(feedback_text({}), "");
  EXPECT_EQ(parse_feedback(""), std::vector<CoveredBin>());
}

TEST(FeedbackText, IsRefusedWhereItIsNone) {
  for (const char* text : {"a", "a 1", "a 1 x", "a x 1", " 1 2", "a 1 2;", "a 1 2; ",
                           "a 1 2; b 1 2; ", "; a 1 2", "a 1 2,b 1 2", "a -1 2", "a 0 2", "a  1 2",
                           "a 1  2", "a 12", "a 1 2 ", "a 1 99999999999999999999"}) {
    EXPECT_FALSE(parse_feedback(text)) << text;
  }
}

TEST(SituationTableOfAPlan, CoversNothingForTestsThatWereNotAdded) {
  const ExperimentPlan plan{.behaviours = {"a", "b"}, .agents = {1}, .tests = 3};
  SituationTable table(plan);
  SituationBins bins(situation_items().size());
  bins[1] = 4;
  table.add({.behaviour = 1, .agents = 1, .number = 2}, bins);
  EXPECT_EQ(table.coverage(0, 1, 3).covered(), 0U);
  EXPECT_EQ(table.coverage(0, 1, 3).tests(), 3U);
  EXPECT_EQ(table.coverage(1, 1, 2).covered(), 0U) << "of the first two";
  EXPECT_EQ(table.coverage(1, 1, 3).covered(), 1U);
  EXPECT_EQ(table.coverage(1, 1, 3).counts()[1][4], 1U);
}

}  // namespace
}  // namespace jaywalk
