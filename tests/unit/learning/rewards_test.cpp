// SPDX-License-Identifier: Apache-2.0
// What ticks and ends of tests bring their agents, as `learning.reward` says it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/judge/situations/situations.h"
#include "experiment/learning/episodes.h"
#include "tests/unit/learning/choices.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::IsEmpty;
using testing_learning::Choosers;
using testing_learning::policy_of_two_parts;

/// A world in which nothing happens but what a test says of its result.
class ToldWorld final : public World {
 public:
  void perceive(AgentId, Percepts&) const override {}
  void execute(std::span<const ActionRequest>, std::span<ActionResult>) override {}
  void advance() override {}
  [[nodiscard]] bool finished() const override { return false; }
  [[nodiscard]] std::string_view kind() const override { return "told"; }
  [[nodiscard]] double tick_s() const override { return 1; }
  [[nodiscard]] int ticks() const override { return 0; }
  void begin(DriveBriefing) override {}
  void end() override {}
  [[nodiscard]] std::vector<Actor> actors() const override { return {}; }
  [[nodiscard]] Scene scene() const override { return {}; }
  [[nodiscard]] const WorldResult& result() const override { return told; }

  WorldResult told;
};

/// Agents that have chosen once, before the first tick; nothing is discounted.
struct Rewarded {
  explicit Rewarded(std::uint32_t agents, double discount = 1)
      : choosers(agents), episodes(policy, discount) {
    for (std::uint32_t i = 0; i < agents; ++i) choosers.choose(episodes, i, 0);
  }
  [[nodiscard]] std::vector<double> all() const {
    std::vector<double> rewards;
    for (const Episode& each : episodes.episodes("step")) rewards.push_back(each.back().reward);
    return rewards;
  }

  Policy policy = policy_of_two_parts();
  Choosers choosers;
  EpisodeRecorder episodes;
};

LearningSpec worth(RewardTerms terms, bool is_shared = false) {
  LearningSpec spec;
  spec.reward = std::move(terms);
  spec.is_shared = is_shared;
  return spec;
}

TEST(TickRewards, AreWhatTheTickAddedToRewardsLessCosts) {
  ToldWorld world;
  world.told.agents = {{.cost = 3, .reward = 1}};
  const LearningSpec spec = worth({.score = 2});
  Rewarded rewarded(1);
  TickRewards rewards(spec, rewarded.episodes);
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(0)) << "what was there before the first tick";
  world.told.agents = {{.cost = 4, .reward = 1}};
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(-2));
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(-2)) << "a tick that changes nothing";
  world.told.agents = {{.cost = 4, .reward = 11}};
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(18));
}

TEST(TickRewards, AreDiscountedFromTheTickInWhichTheyCame) {
  ToldWorld world;
  world.told.agents.resize(1);
  const LearningSpec spec = worth({.score = 1});
  Rewarded rewarded(1, 0.5);
  TickRewards rewards(spec, rewarded.episodes);
  rewards.tick(world);
  rewards.tick(world);  // the first tick
  world.told.agents[0].reward = 8;
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(4)) << "one tick after the choice";
}

TEST(TickRewards, OfATeamAreTheMeanForEverybody) {
  ToldWorld world;
  world.told.agents.resize(2);
  const LearningSpec spec = worth({.score = 1}, true);
  Rewarded rewarded(2);
  TickRewards rewards(spec, rewarded.episodes);
  rewards.tick(world);
  world.told.agents[1].reward = 10;
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(5, 5));
}

TEST(TickRewards, OfEachAreItsOwnWhereNothingIsShared) {
  ToldWorld world;
  world.told.agents.resize(2);
  const LearningSpec spec = worth({.score = 1});
  Rewarded rewarded(2);
  TickRewards rewards(spec, rewarded.episodes);
  rewards.tick(world);
  world.told.agents[0].cost = 1;
  world.told.agents[1].reward = 10;
  rewards.tick(world);
  EXPECT_THAT(rewarded.all(), ElementsAre(-1, 10));
}

TEST(NeedsRecording, IsSoForWhatIsJudgedMeasuredOrCoveredAlone) {
  EXPECT_FALSE(needs_recording({.score = 5, .precondition = 7}));
  EXPECT_TRUE(needs_recording({.violation = {{"a", 1}}}));
  EXPECT_TRUE(needs_recording({.robustness = {{"a", 1}}}));
  EXPECT_TRUE(needs_recording({.new_bins = -1}));
  EXPECT_TRUE(needs_recording({.natural_steps = 1}));
}

class EndRewards : public testing::Test {
 protected:
  /// The agents' rewards for the end of a test.
  std::vector<double> of(const LearningSpec& spec, const Recording& recording = Recording()) {
    outcome.agents.resize(agents);
    Rewarded rewarded(agents);
    const Ground ground = road();
    add_end_rewards(
        spec, {.outcome = outcome, .recording = recording, .ground = ground, .assertions = rules},
        covered, rewarded.episodes);
    return rewarded.all();
  }
  void rule(const std::string& keys) {
    const std::string text = "assertions:\n  - {id: rule, source: test, " + keys + "}\n";
    auto parsed = parse_assertions(std::make_shared<const Source>("rules.yaml", text));
    ASSERT_TRUE(parsed.ok()) << parsed.diagnostics().render();
    rules = std::move(parsed).value();
  }

  std::uint32_t agents = 2;
  WorldResult outcome;
  std::vector<Assertion> rules;
  std::set<std::string> covered;
};

/// Somebody stands 3.25 m from the middle of the AV's way: 2 m from its side.
Recording passing() { return drive(1, {steps({0, 0}, {0, 10}, 3), steps({3.25, 10}, {0, 0}, 3)}); }

TEST_F(EndRewards, OfThePreconditionAreForWhoMetIt) {
  outcome.met_by = {1};
  EXPECT_THAT(of(worth({.precondition = 7})), ElementsAre(0, 7));
  EXPECT_THAT(of(worth({.precondition = 7}, true)), ElementsAre(3.5, 3.5));
}

TEST_F(EndRewards, OfThePreconditionAreForAgentsUnderComparisonAlone) {
  outcome.met_by = {0, 2};
  EXPECT_THAT(of(worth({.precondition = 7})), ElementsAre(7, 0)) << "2 is another road user";
}

TEST_F(EndRewards, OfAViolationAreForEverybody) {
  rule("precondition: true, requirement: always distance > 3");
  EXPECT_THAT(of(worth({.violation = {{"rule", 4}}}), passing()), ElementsAre(4, 4));
}

TEST_F(EndRewards, OfAViolationAreNothingWhereTheRequirementIsKept) {
  rule("precondition: true, requirement: always distance > 1");
  EXPECT_THAT(of(worth({.violation = {{"rule", 4}}}), passing()), ElementsAre(0, 0));
}

TEST_F(EndRewards, OfAViolationAreNothingWhereNoDriverCouldHaveKeptTheRequirement) {
  rule("precondition: true, requirement: always distance > 3, unavoidable: true");
  EXPECT_THAT(of(worth({.violation = {{"rule", 4}}}), passing()), ElementsAre(0, 0));
}

TEST_F(EndRewards, OfRobustnessTurnItsSign) {
  rule("precondition: true, requirement: always distance > 3");
  EXPECT_THAT(of(worth({.robustness = {{"rule", 2}}}), passing()),
              ElementsAre(DoubleEq(2), DoubleEq(2)))
      << "violated by 1 m";
  rule("precondition: true, requirement: always distance > 0.5");
  EXPECT_THAT(of(worth({.robustness = {{"rule", 2}}}), passing()),
              ElementsAre(DoubleEq(-3), DoubleEq(-3)))
      << "kept by 1.5 m";
}

TEST_F(EndRewards, OfRobustnessCountTenAtMost) {
  rule("precondition: true, requirement: always distance > 300");
  EXPECT_THAT(of(worth({.robustness = {{"rule", 2}}}), passing()), ElementsAre(20, 20));
  rule("precondition: true, requirement: always distance > -300");
  EXPECT_THAT(of(worth({.robustness = {{"rule", 2}}}), passing()), ElementsAre(-20, -20));
}

TEST_F(EndRewards, OfRobustnessAreLeastWhereThePreconditionIsNotMet) {
  rule("precondition: false, requirement: always distance > 3");
  EXPECT_THAT(of(worth({.robustness = {{"rule", 2}}}), passing()), ElementsAre(-20, -20));
}

/// Somebody meets the precondition on the way through the AV's lane.
Recording crossing(Place from) {
  Recording recording = drive(1, {steps({0, 0}, {0, 9}, 4), steps(from, {1.5, 0}, 4)});
  recording.add(RecordedEvent{.tick = 2, .actor = 1, .kind = "precondition", .text = {}});
  return recording;
}

TEST_F(EndRewards, OfNewBinsAreForThoseThatNoTestCoveredBefore) {
  const LearningSpec spec = worth({.new_bins = 0.5});
  const double items = static_cast<double>(situation_items().size());
  EXPECT_THAT(of(spec, crossing({-3.5, 13})), ElementsAre(items / 2, items / 2));
  EXPECT_THAT(covered, Contains("start_side left"));
  EXPECT_THAT(of(spec, crossing({-3.5, 13})), ElementsAre(0, 0)) << "the same test again";
  covered.erase("start_side left");
  EXPECT_THAT(of(spec, crossing({-3.5, 13})), ElementsAre(0.5, 0.5));
}

TEST_F(EndRewards, OfNewBinsAreNothingWhereNobodyMeetsThePrecondition) {
  EXPECT_THAT(of(worth({.new_bins = 0.5}), passing()), ElementsAre(0, 0));
  EXPECT_THAT(covered, IsEmpty());
}

TEST_F(EndRewards, LeaveTheBinsAloneWhereNothingIsPaidForThem) {
  rule("precondition: true, requirement: always distance > 3");
  (void)of(worth({.violation = {{"rule", 4}}}), crossing({-3.5, 13}));
  EXPECT_THAT(covered, IsEmpty());
}

TEST_F(EndRewards, OfNaturalStepsAreTheirShare) {
  const LearningSpec spec = worth({.natural_steps = 3});
  const std::vector<Place> av = steps({0, 0}, {0, 10}, 4);
  EXPECT_THAT(of(spec, drive(1, {av, steps({-5, 10}, {1, 0}, 4)})), ElementsAre(3, 3));
  EXPECT_THAT(of(spec, drive(1, {av, {{-5, 10}, {-4, 10}, {-5, 10}, {-6, 10}}})),
              ElementsAre(DoubleEq(2), DoubleEq(2)))
      << "one step of three turns straight back";
  EXPECT_THAT(of(spec, drive(1, {av, steps({0, 10}, {0, 0}, 4)})), ElementsAre(0, 0))
      << "stands in the road";
}

TEST_F(EndRewards, OfNaturalStepsAreAllOfThemWhereThereIsNoStep) {
  EXPECT_THAT(of(worth({.natural_steps = 3}), drive(1, {{{0, 0}}, {{0, 10}}})), ElementsAre(3, 3));
}

TEST_F(EndRewards, AddUp) {
  rule("precondition: true, requirement: always distance > 3");
  outcome.met_by = {0};
  const std::vector<double> both =
      of(worth({.precondition = 7, .violation = {{"rule", 4}}, .robustness = {{"rule", 2}}}),
         passing());
  EXPECT_THAT(both, ElementsAre(DoubleEq(7 + 4 + 2), DoubleEq(4 + 2)));
}

TEST_F(EndRewards, OfAnAssertionThatIsNotThereAreThoseOfOneThatWasNeverExercised) {
  EXPECT_THAT(of(worth({.violation = {{"none", 4}}, .robustness = {{"none", 1}}}), passing()),
              ElementsAre(-10, -10));
}

}  // namespace
}  // namespace jaywalk
