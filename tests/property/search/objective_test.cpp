// SPDX-License-Identifier: Apache-2.0
// The gradient that an actor follows is that of the clipped objective, within and beyond the clip.

#include <array>

#include <gtest/gtest.h>

#include "experiment/policy/clipped_objective.h"
#include "tests/property/search/comparison.h"

namespace jaywalk {
namespace {

using networks::Comparison;
using networks::Matrix;
using networks::Network;
using networks::Random;

constexpr Eigen::Index kFeatures = 3;
constexpr std::size_t kOptions = 4;
constexpr Eigen::Index kDecisions = 24;
constexpr ObjectiveSettings kSettings{.clip = 0.2, .entropy = 0.05};

struct Judged {
  Transition decision;
  double advantage = 0;
};

std::span<const float> scores_of(const Matrix& scores, Eigen::Index column) {
  return {scores.col(column).data(), kOptions};
}

std::vector<double> probabilities_of(const Matrix& scores, Eigen::Index column,
                                     const Transition& decision) {
  std::vector<double> probabilities(decision.options.size());
  softmax(scores_of(scores, column), decision.options, probabilities);
  return probabilities;
}

/// Choices among two to four options whose probabilities have changed since by up to a half, to
/// either side.
std::vector<Judged> judged_decisions(const Matrix& scores, Random& random) {
  std::vector<Judged> decisions;
  for (Eigen::Index i = 0; i < kDecisions; ++i) {
    std::vector<std::uint32_t> options{0, 1, 2, 3};
    random.shuffle(options);
    options.resize(2 + random.below(3));
    Transition decision{.features = {}, .options = options};
    decision.chosen = static_cast<std::uint32_t>(random.below(options.size()));
    const double now = probabilities_of(scores, i, decision)[decision.chosen];
    decision.probability = now / random.uniform(0.5, 1.5);
    decisions.push_back({decision, random.uniform(-2, 2)});
  }
  return decisions;
}

double mean_loss(const Matrix& scores, const std::vector<Judged>& decisions) {
  double sum = 0;
  for (Eigen::Index i = 0; i < kDecisions; ++i) {
    const Judged& each = decisions[static_cast<std::size_t>(i)];
    sum += clipped_loss(each.decision, each.advantage, probabilities_of(scores, i, each.decision),
                        kSettings);
  }
  return sum / kDecisions;
}

class Objective : public testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam())};
};

TEST_P(Objective, HasTheGradientOfFiniteDifferencesByTheNetworksWeights) {
  Network actor({kFeatures, 12, kOptions, 0.01F}, random_);
  const Matrix x = networks::noise(kFeatures, kDecisions, random_);
  const Matrix scores = actor.forward(x);
  const std::vector<Judged> decisions = judged_decisions(scores, random_);
  Matrix gradient = Matrix::Zero(kOptions, kDecisions);
  for (Eigen::Index i = 0; i < kDecisions; ++i) {
    const Judged& each = decisions[static_cast<std::size_t>(i)];
    add_clipped_gradient(each.decision, each.advantage, probabilities_of(scores, i, each.decision),
                         kSettings, {gradient.col(i).data(), kOptions});
  }
  actor.clear_gradients();
  actor.backward(gradient / static_cast<float>(kDecisions));
  // Scores close to the clip bend the loss within longer steps.
  Comparison result(3e-4F);
  networks::compare_parameters(
      actor, [&] { return mean_loss(actor.output(x), decisions); }, result);
  EXPECT_LT(result.relative_error(), 0.01);
  EXPECT_LT(result.share_left_out(), 0.4);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Objective, testing::Range(1, 21));

/// The gradient by the score of the chosen one of two equally probable options.
float gradient_of(double probability_then, double advantage) {
  const Transition decision{.options = {0, 1}, .chosen = 0, .probability = probability_then};
  std::array<float, 2> gradient{};
  add_clipped_gradient(decision, advantage, std::array{0.5, 0.5}, {.clip = 0.2, .entropy = 0},
                       gradient);
  return gradient[0];
}

// A choice that was good is made more probable, but no further than to 1.2 times what it was; one
// that was bad less probable, but no further than to 0.8 times.
TEST(Objective, IsFlatBeyondTheClip) {
  EXPECT_LT(gradient_of(0.5, 1), 0);
  EXPECT_EQ(gradient_of(0.4, 1), 0);
  EXPECT_LT(gradient_of(0.7, 1), 0);
  EXPECT_GT(gradient_of(0.5, -1), 0);
  EXPECT_EQ(gradient_of(0.7, -1), 0);
  EXPECT_GT(gradient_of(0.4, -1), 0);
}

}  // namespace
}  // namespace jaywalk
