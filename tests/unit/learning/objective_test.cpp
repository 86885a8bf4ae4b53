// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "experiment/policy/clipped_objective.h"

namespace jaywalk {
namespace {

constexpr ObjectiveSettings kWithoutChance{.clip = 0.2, .entropy = 0};

/// Option 0 of two was chosen when its probability was this.
Transition chosen_with(double probability) {
  return {.options = {0, 1}, .chosen = 0, .probability = probability};
}

TEST(Softmax, SharesByTheExponentialsOfTheScores) {
  const std::array<float, 3> scores{0, std::log(2.0F), std::log(5.0F)};
  const std::array<std::uint32_t, 3> options{0, 1, 2};
  std::array<double, 3> shares{};
  softmax(scores, options, shares);
  EXPECT_NEAR(shares[0], 1.0 / 8, 1e-6);
  EXPECT_NEAR(shares[1], 2.0 / 8, 1e-6);
  EXPECT_NEAR(shares[2], 5.0 / 8, 1e-6);
}

TEST(Softmax, IsOfTheOptionsThatThereAre) {
  const std::array<float, 3> scores{0, 100, 0};
  const std::array<std::uint32_t, 2> options{2, 0};
  std::array<double, 2> shares{};
  softmax(scores, options, shares);
  EXPECT_DOUBLE_EQ(shares[0], 0.5);
  EXPECT_DOUBLE_EQ(shares[1], 0.5);
}

TEST(Softmax, TakesScoresOfAnySize) {
  const std::array<std::uint32_t, 2> options{0, 1};
  std::array<double, 2> shares{};
  softmax(std::array<float, 2>{1000, 999}, options, shares);
  EXPECT_NEAR(shares[0], 1 / (1 + std::exp(-1.0)), 1e-9);
  softmax(std::array<float, 2>{-1e30F, 0}, options, shares);
  EXPECT_EQ(shares[0], 0);
  EXPECT_EQ(shares[1], 1);
}

TEST(ClippedLoss, IsTheAdvantageByHowMuchMoreProbableTheOptionIs) {
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), 3, std::array{0.55, 0.45}, kWithoutChance), -3.3,
              1e-12);
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), -3, std::array{0.55, 0.45}, kWithoutChance), 3.3,
              1e-12);
}

TEST(ClippedLoss, GainsNothingBeyondTheClip) {
  const double at_clip = clipped_loss(chosen_with(0.5), 3, std::array{0.6, 0.4}, kWithoutChance);
  EXPECT_NEAR(at_clip, -3.6, 1e-12);
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), 3, std::array{0.9, 0.1}, kWithoutChance), at_clip,
              1e-12);
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), -3, std::array{0.1, 0.9}, kWithoutChance), 2.4, 1e-12);
}

TEST(ClippedLoss, IsNotClippedWhereThingsGotWorse) {
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), 3, std::array{0.1, 0.9}, kWithoutChance), -0.6, 1e-12);
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), -3, std::array{0.9, 0.1}, kWithoutChance), 5.4, 1e-12);
}

TEST(ClippedLoss, HasABonusForChance) {
  const ObjectiveSettings settings{.clip = 0.2, .entropy = 0.5};
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), 0, std::array{0.5, 0.5}, settings),
              -0.5 * std::log(2.0), 1e-12);
  EXPECT_NEAR(clipped_loss(chosen_with(0.5), 0, std::array{1.0, 0.0}, settings), 0, 1e-12);
}

/// The loss of scores, as the gradient sees them.
double loss_of_scores(const Transition& decision, double advantage,
                      const std::array<float, 3>& scores, const ObjectiveSettings& settings) {
  std::array<double, 3> shares{};
  softmax(scores, decision.options, shares);
  return clipped_loss(decision, advantage, shares, settings);
}

TEST(ClippedGradient, IsThatOfTheLoss) {
  const Transition decision{.options = {0, 1, 2}, .chosen = 1, .probability = 0.34};
  const ObjectiveSettings settings{.clip = 0.2, .entropy = 0.1};
  const std::array<float, 3> scores{0.2F, 0.1F, -0.3F};
  for (const double advantage : {2.0, -1.5}) {
    std::array<double, 3> shares{};
    softmax(scores, decision.options, shares);
    std::array<float, 3> gradient{};
    add_clipped_gradient(decision, advantage, shares, settings, gradient);
    constexpr float kStep = 1e-2F;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<float, 3> above = scores;
      std::array<float, 3> below = scores;
      above[i] += kStep;
      below[i] -= kStep;
      const double difference = loss_of_scores(decision, advantage, above, settings) -
                                loss_of_scores(decision, advantage, below, settings);
      EXPECT_NEAR(gradient[i], difference / (2 * kStep), 2e-3) << advantage << " " << i;
    }
  }
}

TEST(ClippedGradient, OfAClippedDecisionIsZero) {
  std::array<float, 2> gradient{};
  add_clipped_gradient(chosen_with(0.5), 3, std::array{0.9, 0.1}, kWithoutChance, gradient);
  EXPECT_EQ(gradient[0], 0);
  EXPECT_EQ(gradient[1], 0);
}

TEST(ClippedGradient, IsAddedToTheOptionsThatThereWere) {
  const Transition decision{.options = {2, 0}, .chosen = 0, .probability = 0.5};
  std::array<float, 3> gradient{1, 1, 1};
  add_clipped_gradient(decision, 2, std::array{0.5, 0.5}, kWithoutChance, gradient);
  EXPECT_FLOAT_EQ(gradient[2], 1 - 2 * 0.5F) << "more of the chosen one lessens the loss";
  EXPECT_FLOAT_EQ(gradient[0], 1 + 2 * 0.5F);
  EXPECT_FLOAT_EQ(gradient[1], 1);
}

}  // namespace
}  // namespace jaywalk
