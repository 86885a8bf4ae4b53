// SPDX-License-Identifier: Apache-2.0
// Plans that are options of a policy.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/surroundings/learned_choice.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::string_view kSteps =
    "at(3). !go(200). observation(step, [X, 2 * X]) :- at(X). "
    "+!go(0). +!go(N) <- !step; !go(N - 1). "
    "@left[learned(step)] +!step <- .print(left). "
    "@right[learned(step)] +!step : at(X) & X > 2 <- .print(right). "
    "@never[learned(step)] +!step : at(9) <- .print(never). "
    "+!step <- .print(other).";

/// Takes an option by its label, and keeps what it was asked.
class Fixed final : public OptionPolicies {
 public:
  explicit Fixed(std::string label) : label_(std::move(label)) {}

  std::string weigh(const LearnedChoice& choice, std::span<double> probabilities) override {
    asked.push_back(std::string(choice.policy));
    features.assign(choice.features.begin(), choice.features.end());
    options.assign(choice.options.begin(), choice.options.end());
    for (std::size_t i = 0; i < options.size(); ++i) {
      probabilities[i] = options[i] == label_ ? 1 : 0;
    }
    return refusal;
  }
  void drawn(const LearnedChoice&, const DrawnOption& drawn) override {
    chosen.push_back(drawn.chosen);
  }

  std::vector<std::string> asked;
  std::vector<double> features;
  std::vector<std::string> options;
  std::vector<std::size_t> chosen;
  std::string refusal;

 private:
  std::string label_;
};

std::vector<std::string> printed_by(std::string_view program, OptionPolicies* policies = nullptr,
                                    std::uint64_t seed = 0) {
  System system({.seed = seed, .policies = policies});
  system.add("ann", program);
  system.run();
  return system.printed;
}

TEST(LearnedPlans, AreDrawnUniformlyWithoutAPolicy) {
  const std::vector<std::string> printed = printed_by(kSteps);
  ASSERT_THAT(printed, SizeIs(200));
  const auto left = std::ranges::count(printed, "[ann] left");
  EXPECT_EQ(left + std::ranges::count(printed, "[ann] right"), 200);
  EXPECT_GT(left, 70);
  EXPECT_LT(left, 130);
}

TEST(LearnedPlans, AreDrawnFromTheAgentsOwnStream) {
  EXPECT_EQ(printed_by(kSteps), printed_by(kSteps));
  EXPECT_NE(printed_by(kSteps), printed_by(kSteps, nullptr, 1));
}

TEST(LearnedPlans, ArePolicysToWeighByWhatIsObserved) {
  Fixed right("right");
  EXPECT_THAT(printed_by(kSteps, &right), Each("[ann] right"));
  EXPECT_THAT(right.asked, SizeIs(200));
  EXPECT_THAT(right.asked, Each("step"));
  EXPECT_THAT(right.features, ElementsAre(3, 6));
  EXPECT_THAT(right.options, ElementsAre("left", "right"));
  EXPECT_THAT(right.chosen, Each(1));
}

TEST(LearnedPlans, GiveWayToAPlanBeforeThemAndComeBeforeOthers) {
  EXPECT_THAT(printed_by("!g. observation(p, [1]). +!g <- .print(first). "
                         "@a[learned(p)] +!g <- .print(a)."),
              ElementsAre("[ann] first"));
  EXPECT_THAT(printed_by("!g. observation(p, [1]). @a[learned(p)] +!g : no <- .print(a). "
                         "+!g <- .print(last)."),
              ElementsAre("[ann] last"));
}

TEST(LearnedPlans, OfTwoPoliciesTheFirstOneIsAsked) {
  Fixed second("b");
  EXPECT_THAT(printed_by("!g. observation(_, [1]). @a[learned(p)] +!g <- .print(a). "
                         "@b[learned(p)] +!g <- .print(b). @c[learned(q)] +!g <- .print(c).",
                         &second),
              ElementsAre("[ann] b"));
  EXPECT_THAT(second.options, ElementsAre("a", "b"));
}

TEST(LearnedPlans, BindWhatTheirContextsBind) {
  Fixed b("b");
  EXPECT_THAT(printed_by("!s. q(1). q(2). observation(p, [1]). +!s <- !g(X); .print(X). "
                         "@a[learned(p)] +!g(one). @b[learned(p)] +!g(Y) : q(Y) & Y > 1.",
                         &b),
              ElementsAre("[ann] 2"));
}

TEST(LearnedPlans, OfAllUnifsAreAnOptionForEachSolution) {
  Fixed any("a");
  (void)printed_by("!g. q(1). q(2). observation(p, []). @a[learned(p), all_unifs] +!g : q(X).",
                   &any);
  EXPECT_THAT(any.options, ElementsAre("a", "a"));
}

TEST(LearnedPlans, FailTheGoalWhereNothingIsObserved) {
  for (const auto& [rule, message] : std::vector<std::pair<std::string, std::string>>{
           {"", "needs a rule or belief observation(p, Features)"},
           {"observation(p, [a]).", "is to be a list of numbers"},
           {"observation(p, 7).", "is to be a list of numbers"},
           {"observation(p, [1|_]).", "is to be a list of numbers"},
           {"observation(p, [1/0]).", "is to be a list of numbers"}}) {
    System system;
    system.add("ann",
               "!g. " + rule + " @a[learned(p)] +!g. -!g[error(E), error_msg(M)] <- .print(E, M).");
    system.run();
    ASSERT_THAT(system.printed, SizeIs(1)) << rule;
    EXPECT_THAT(system.printed.front(), HasSubstr(message)) << rule;
  }
}

TEST(LearnedPlans, FailTheGoalWhereThePolicyRefuses) {
  Fixed refusing("a");
  refusing.refusal = "it knows another program";
  EXPECT_THAT(printed_by("!g. observation(p, [1]). @a[learned(p)] +!g. "
                         "-!g[error(E), error_msg(M)] <- .print(E, M).",
                         &refusing),
              ElementsAre(HasSubstr("it knows another program")));
}

TEST(LearnedPlans, MayBeAddedAsTheAgentRuns) {
  Fixed late("late");
  EXPECT_THAT(printed_by("!g. observation(p, [1]). "
                         "+!g <- .add_plan({@late[learned(p)] +!h <- .print(late)}); !h.",
                         &late),
              ElementsAre("[ann] late"));
  EXPECT_THAT(late.asked, ElementsAre("p"));
}

TEST(LearnedPlans, AreDrawnAlikeOnAnyNumberOfThreads) {
  const auto printed = [](std::size_t threads) {
    System system({.threads = threads, .fewest_parallel = 2});
    for (int i = 0; i < 8; ++i) system.add("a" + std::to_string(i), kSteps);
    system.run();
    return system.printed;
  };
  EXPECT_EQ(printed(1), printed(4));
}

}  // namespace
}  // namespace jaywalk
