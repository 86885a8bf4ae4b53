// SPDX-License-Identifier: Apache-2.0
// Which choice a reward counts for, and how much.

#include "experiment/learning/episodes.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/networks/random.h"
#include "tests/unit/learning/choices.h"

namespace jaywalk {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing_learning::Choosers;
using testing_learning::policy_of_two_parts;

constexpr double kDiscount = 0.5;

struct Recorded {
  explicit Recorded(std::uint32_t agents) : choosers(agents) {}

  void ticks(int count) {
    for (int i = 0; i < count; ++i) episodes.tick();
  }
  /// The rewards of an agent's choices in a part of the policy.
  [[nodiscard]] std::vector<double> rewards(const std::string& part = "step",
                                            std::size_t agent = 0) const {
    std::vector<double> rewards;
    const Episode episode = episodes.episodes(part).at(agent);
    for (const Transition& each : episode) rewards.push_back(each.reward);
    return rewards;
  }

  Policy policy = policy_of_two_parts();
  Choosers choosers;
  EpisodeRecorder episodes{policy, kDiscount};
};

TEST(Episodes, HoldWhatWasObservedAndChosenAndHowProbableItWas) {
  Recorded made(1);
  made.choosers.features = {3, -0.5};
  made.choosers.choose(made.episodes, 0, 1);
  const std::vector<Episode> all = made.episodes.episodes("step");
  ASSERT_THAT(all, ElementsAre(SizeIs(1)));
  EXPECT_THAT(all[0][0].features, ElementsAre(3, -0.5));
  EXPECT_THAT(all[0][0].options, ElementsAre(0, 1));
  EXPECT_EQ(all[0][0].chosen, 1U);
  EXPECT_EQ(all[0][0].probability, 0.75);
}

TEST(Episodes, NumberOptionsAsThePolicyDoesNotAsTheyCame) {
  Recorded made(1);
  const LearnedChoice usual = made.choosers.choice(0, "step");
  const std::vector<std::string> turned{"stay", "go"};
  made.episodes.drawn({usual.agent, "step", usual.features, turned},
                      {.probabilities = std::array{0.25, 0.75}, .chosen = 0});
  const Episode episode = made.episodes.episodes("step").at(0);
  EXPECT_THAT(episode[0].options, ElementsAre(1, 0));
  EXPECT_EQ(episode[0].chosen, 0U) << "an index of these options";
  EXPECT_EQ(episode[0].probability, 0.25);
}

TEST(Episodes, LeaveOutChoicesOfPlansThatThePolicyDoesNotKnow) {
  Recorded made(1);
  const LearnedChoice usual = made.choosers.choice(0, "step");
  const std::vector<std::string> others{"go", "run"};
  const std::array probabilities{0.25, 0.75};
  made.episodes.drawn({usual.agent, "step", usual.features, others},
                      {.probabilities = probabilities});
  made.episodes.drawn({usual.agent, "sleep", usual.features, usual.options},
                      {.probabilities = probabilities});
  EXPECT_THAT(made.episodes.episodes("step"), IsEmpty());
  EXPECT_THAT(made.episodes.episodes("sleep"), IsEmpty());
  EXPECT_EQ(made.episodes.mean_return(), 0);
}

TEST(Episodes, CountARewardLessTheLongerAgoTheChoiceWas) {
  Recorded made(1);
  made.choosers.choose(made.episodes, 0, 0);
  made.episodes.add_reward(0, 8);
  EXPECT_THAT(made.rewards(), ElementsAre(8)) << "in the tick of the choice it counts in full";
  made.ticks(2);
  made.episodes.add_reward(0, 8);
  EXPECT_THAT(made.rewards(), ElementsAre(8 + 2));
}

TEST(Episodes, CountARewardForTheLatestChoiceAlone) {
  Recorded made(1);
  made.choosers.choose(made.episodes, 0, 0);
  made.ticks(1);
  made.choosers.choose(made.episodes, 0, 1);
  made.ticks(1);
  made.episodes.add_reward(0, 8);
  EXPECT_THAT(made.rewards(), ElementsAre(0, 4));
}

TEST(Episodes, DiscountWhatFollowsByTheTicksUntilTheNextChoice) {
  Recorded made(1);
  made.choosers.choose(made.episodes, 0, 0);
  made.choosers.choose(made.episodes, 0, 0);
  made.ticks(3);
  made.choosers.choose(made.episodes, 0, 0);
  const Episode episode = made.episodes.episodes("step").at(0);
  EXPECT_EQ(episode[0].discount, 1) << "two choices in one tick";
  EXPECT_THAT(episode[1].discount, DoubleEq(0.125));
}

TEST(Episodes, ForgetRewardsBeforeTheFirstChoice) {
  Recorded made(1);
  made.episodes.add_reward(0, 100);
  made.ticks(1);
  made.choosers.choose(made.episodes, 0, 0);
  EXPECT_THAT(made.rewards(), ElementsAre(0));
}

TEST(Episodes, CountARewardForEveryPartOfTheAgentAndForNobodyElse) {
  Recorded made(2);
  made.choosers.choose(made.episodes, 0, 0, "step");
  made.choosers.choose(made.episodes, 1, 0, "step");
  made.ticks(1);
  made.choosers.choose(made.episodes, 0, 0, "turn");
  made.episodes.add_reward(0, 8);
  EXPECT_THAT(made.rewards("step", 0), ElementsAre(4));
  EXPECT_THAT(made.rewards("turn", 0), ElementsAre(8));
  EXPECT_THAT(made.rewards("step", 1), ElementsAre(0));
}

TEST(Episodes, CountWhatTheEndBringsInTheTickThatIsOver) {
  Recorded made(1);
  made.choosers.choose(made.episodes, 0, 0);
  made.ticks(3);
  made.episodes.add_last_reward(0, 8);
  EXPECT_THAT(made.rewards(), ElementsAre(2)) << "two ticks after the choice, not three";
}

TEST(Episodes, OfATestWithoutATickCountWhatTheEndBringsInFull) {
  Recorded made(1);
  made.choosers.choose(made.episodes, 0, 0);
  made.episodes.add_last_reward(0, 8);
  EXPECT_THAT(made.rewards(), ElementsAre(8));
}

TEST(Episodes, ComeInTheOrderOfTheAgentsWhoeverChoseFirst) {
  Recorded made(3);
  for (const std::uint32_t agent : {2U, 0U}) {
    made.choosers.features = {static_cast<double>(agent)};
    made.choosers.choose(made.episodes, agent, 0);
  }
  const std::vector<Episode> all = made.episodes.episodes("step");
  ASSERT_THAT(all, SizeIs(2)) << "agent 1 never chose";
  EXPECT_THAT(all[0][0].features, ElementsAre(0));
  EXPECT_THAT(all[1][0].features, ElementsAre(2));
}

TEST(Episodes, HaveTheMeanOfWhatAgentsGotWhenTheyFirstChose) {
  Recorded made(2);
  made.ticks(4);
  made.choosers.choose(made.episodes, 0, 0);
  made.choosers.choose(made.episodes, 1, 0);
  made.episodes.add_reward(0, 8);
  made.ticks(1);
  made.episodes.add_reward(1, 4);
  EXPECT_THAT(made.episodes.mean_return(), DoubleEq((8.0 + 2.0) / 2));
}

// An agent that chooses again in between gets no more and no less by it.
TEST(Episodes, ReturnTheSameHoweverOftenTheAgentChooses) {
  networks::Random random(11);
  for (int round = 0; round < 50; ++round) {
    Recorded made(1);
    made.choosers.choose(made.episodes, 0, 0);
    double expected = 0;
    for (int tick = 0; tick < 20; ++tick) {
      if (random.uniform(0, 1) < 0.3) made.choosers.choose(made.episodes, 0, tick % 2 == 0 ? 0 : 1);
      const double reward = random.uniform(-5, 5);
      made.episodes.add_reward(0, reward);
      expected += reward * std::pow(kDiscount, tick);
      made.episodes.tick();
    }
    EXPECT_NEAR(made.episodes.mean_return(), expected, 1e-9) << "round " << round;
  }
}

TEST(Episodes, AskThePolicyToExplore) {
  Recorded made(1);
  Policy always_tries = policy_of_two_parts({.explores = 1, .explores_least = 1});
  always_tries.learn("step", std::vector<Episode>{
                                 {{.features = {1}, .options = {0, 1}, .chosen = 0, .reward = 9}},
                                 {{.features = {1}, .options = {0, 1}, .chosen = 1, .reward = 1}}});
  EpisodeRecorder episodes(always_tries, kDiscount);
  std::array<double, 2> probabilities{};
  EXPECT_EQ(episodes.weigh(made.choosers.choice(0, "step"), probabilities), "");
  EXPECT_THAT(probabilities, ElementsAre(DoubleEq(0.5), DoubleEq(0.5)));
}

TEST(Episodes, RefuseAnObservationOfAnotherLengthThanBefore) {
  Recorded made(2);
  made.choosers.choose(made.episodes, 0, 0);
  made.choosers.features = {1, 2};
  std::array<double, 2> probabilities{0.5, 0.5};
  EXPECT_EQ(made.episodes.weigh(made.choosers.choice(0, "step"), probabilities),
            "observation(step, Features) has had 1 numbers, now 2");
  EXPECT_EQ(made.episodes.weigh(made.choosers.choice(0, "turn"), probabilities), "")
      << "another part observes something else";
}

}  // namespace
}  // namespace jaywalk
