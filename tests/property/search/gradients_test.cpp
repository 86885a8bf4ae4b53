// SPDX-License-Identifier: Apache-2.0
// Every gradient that the networks train by agrees with finite differences, for many random
// networks and inputs.

#include <cmath>

#include <gtest/gtest.h>

#include "search/learn/autoencoder.h"
#include "tests/property/search/comparison.h"

namespace jaywalk::search::learn {
namespace {

using networks::compare_parameters;
using networks::Comparison;

constexpr Eigen::Index kInputs = 5;
constexpr Eigen::Index kHidden = 12;

class Gradients : public testing::TestWithParam<int> {
 protected:
  Random random_{static_cast<std::uint64_t>(GetParam())};
};

TEST_P(Gradients, OfANetworksOutputAgreeWithFiniteDifferences) {
  Network network({kInputs, kHidden, 2, 0.1F}, random_);
  const Matrix x = noise(kInputs, 8, random_);
  const Matrix weight = noise(2, 8, random_);
  const auto loss = [&] {
    Network copy = network;
    return static_cast<double>(copy.forward(x).cwiseProduct(weight).sum());
  };
  network.clear_gradients();
  network.forward(x);
  network.backward(weight);
  Comparison result;
  compare_parameters(network, loss, result);
  EXPECT_LT(result.relative_error(), 0.01);
  EXPECT_LT(result.share_left_out(), 0.4);
}

// The penalty is a function of the gradient by the input, so its gradient by the weights is a
// second derivative.
TEST_P(Gradients, OfTheGradientPenaltyAgreeWithFiniteDifferences) {
  constexpr float kWeight = 10;
  Network critic({kInputs, kHidden, 1, 0.1F}, random_);
  const Matrix x = noise(kInputs, 8, random_);
  const auto loss = [&] {
    Network copy = critic;
    return static_cast<double>(kWeight * copy.add_gradient_penalty(x, kWeight));
  };
  critic.clear_gradients();
  critic.add_gradient_penalty(x, kWeight);
  Comparison result;
  compare_parameters(critic, loss, result);
  EXPECT_LT(result.relative_error(), 0.01);
  EXPECT_LT(result.share_left_out(), 0.4);
}

// And the penalty itself is that of the gradient which backward() computes.
TEST_P(Gradients, OfTheInputGiveThePenalty) {
  Network critic({kInputs, kHidden, 1, 0}, random_);
  const Matrix x = noise(kInputs, 8, random_);
  const float penalty = critic.add_gradient_penalty(x, 1);
  critic.forward(x);
  const Matrix g = critic.backward(Matrix::Ones(1, 8), Network::Gradients::none);
  const Eigen::ArrayXf norm = (g.array().square().colwise().sum() + 1e-6F).sqrt().transpose();
  EXPECT_NEAR(penalty, (norm - 1).square().mean(), 1e-5);
}

TEST_P(Gradients, ThroughBatchNormalisationAndTanhAgreeWithFiniteDifferences) {
  TestMaker maker({10, kHidden, kInputs, 0}, TestMaker::Normalisation::batch, random_);
  Network critic({kInputs, kHidden, 1, 0.1F}, random_);
  const Matrix z = noise(10, 32, random_);
  const auto loss = [&] {
    return static_cast<double>(critic.forward(maker.forward(z, Pass::training)).sum());
  };
  loss();
  maker.backward(critic.backward(Matrix::Ones(1, 32), Network::Gradients::none));
  Comparison result;
  std::vector<float> scale_gradient(maker.scale_gradient().begin(), maker.scale_gradient().end());
  compare_parameters(maker.network(), loss, result);
  for (std::size_t i = 0; i < scale_gradient.size(); ++i) {
    result.add(static_cast<double>(scale_gradient[i]), maker.scale()[i], loss);
  }
  EXPECT_LT(result.relative_error(), 0.01);
  EXPECT_LT(result.share_left_out(), 0.4);
}

TEST_P(Gradients, OfTheAnalyzersLossAgreeWithFiniteDifferences) {
  Analyzer analyzer({.shape = {kInputs, kHidden, 1, 0}, .regularisation = 0.01F}, random_);
  const Matrix x = noise(kInputs, 20, random_);
  const Matrix y = (noise(1, 20, random_).array() * 0.5F + 0.5F).matrix();
  const auto loss = [&] { return static_cast<double>(analyzer.add_loss_gradient(x, y)); };
  analyzer.network().clear_gradients();
  loss();
  Network kept = analyzer.network();
  Comparison result;
  for (std::size_t k = 0; k < 3; ++k) {
    Layer& layer = *analyzer.network().layers()[k];
    const Matrix& derived = kept.layers()[k]->weight_gradient;
    for (Eigen::Index i = 0; i < derived.size(); ++i) {
      result.add(static_cast<double>(derived.data()[i]), layer.weights.data()[i], loss);
    }
  }
  EXPECT_LT(result.relative_error(), 0.01);
  EXPECT_LT(result.share_left_out(), 0.4);
}

TEST_P(Gradients, OfTheAnalyzersLossByItsInputAgreeWithFiniteDifferences) {
  Analyzer analyzer({.shape = {kInputs, kHidden, 1, 0.1F}}, random_);
  Matrix x = noise(kInputs, 10, random_);
  const Matrix y = Matrix::Ones(1, 10);
  const Matrix derived = analyzer.input_gradient(x, y);
  const auto loss = [&] { return static_cast<double>(analyzer.add_loss_gradient(x, y)); };
  // Shares of a mean over ten tests are small beside the loss; a longer step keeps the rounding
  // small.
  Comparison result(1e-2F);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    result.add(static_cast<double>(derived.data()[i]), x.data()[i], loss);
  }
  EXPECT_LT(result.relative_error(), 0.02);
  EXPECT_LT(result.share_left_out(), 0.5);
}

TEST_P(Gradients, OfTheAutoencodersLossAgreeWithFiniteDifferences) {
  Autoencoder coder(4, {}, random_);
  const Matrix x = noise(4, 6, random_);
  const Matrix latent_noise = noise(4, 6, random_);
  const auto loss = [&] { return static_cast<double>(coder.add_loss_gradient(x, latent_noise)); };
  for (Layer* layer : coder.layers()) layer->clear_gradients();
  loss();
  std::vector<Matrix> weights;
  std::vector<Vector> biases;
  for (Layer* layer : coder.layers()) {
    weights.push_back(layer->weight_gradient);
    biases.push_back(layer->bias_gradient);
  }
  Comparison result(1e-2F);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    Layer& layer = *coder.layers()[k];
    // A sample of the weights: there are ten thousands.
    for (Eigen::Index i = 0; i < weights[k].size(); i += 1 + weights[k].size() / 40) {
      result.add(static_cast<double>(weights[k].data()[i]), layer.weights.data()[i], loss);
    }
    for (Eigen::Index i = 0; i < biases[k].size(); i += 1 + biases[k].size() / 20) {
      result.add(static_cast<double>(biases[k][i]), layer.bias[i], loss);
    }
  }
  EXPECT_LT(result.relative_error(), 0.02);
  EXPECT_LT(result.share_left_out(), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Gradients, testing::Range(1, 21));

TEST(Training, IsReproducibleFromTheSeed) {
  const auto train = [] {
    Random random(5);
    WassersteinPair pair({.dimension = kInputs}, random);
    const Matrix real = noise(kInputs, 32, random);
    for (int i = 0; i < 20; ++i) pair.train_critic(real, random);
    pair.train_maker(32, random);
    return pair.make(10, random);
  };
  EXPECT_EQ(train(), train());
}

TEST(Training, MovesTheAnalyzerTowardsTheFitness) {
  Random random(5);
  Analyzer analyzer({.shape = {kInputs, 32, 1, 0}, .adam = {.rate = 1e-2F}}, random);
  const Matrix x = noise(kInputs, 64, random);
  const Matrix y = (0.5F + 0.4F * x.row(0).array()).matrix();
  const float before = analyzer.train(x, y);
  for (int i = 0; i < 300; ++i) analyzer.train(x, y);
  EXPECT_LT(analyzer.train(x, y), 0.1F * before);
}

// Points on a circle, of which one number of the latent two says all.
TEST(Training, MovesTheAutoencoderTowardsTheTests) {
  Random random(5);
  Autoencoder coder(2, {.rate = 1e-3F, .beta1 = 0.9F, .beta2 = 0.999F}, random);
  Matrix circle(2, 64);
  for (Eigen::Index i = 0; i < 64; ++i) {
    const double angle = random.uniform(0, 6.28);
    circle.col(i) << static_cast<float>(0.7 * std::cos(angle)),
        static_cast<float>(0.7 * std::sin(angle));
  }
  for (int i = 0; i < 1500; ++i) coder.train(circle, random);
  EXPECT_LT((coder.decode(coder.encode(circle)) - circle).cwiseAbs().maxCoeff(), 0.15F);
  // Points drawn in the latent space resemble the samples.
  double off = 0;
  for (int i = 0; i < 200; ++i) {
    Matrix latent(2, 1);
    latent << static_cast<float>(standard_normal(random)),
        static_cast<float>(standard_normal(random));
    off += std::fabs(static_cast<double>(coder.decode(latent).norm()) - 0.7) / 200;
  }
  EXPECT_LT(off, 0.2);
}

TEST(Training, MovesTheWassersteinGeneratorTowardsTheTests) {
  Random random(5);
  WassersteinPair pair({.dimension = 2, .rate = 1e-3F}, random);
  Matrix real(2, 32);
  for (Eigen::Index i = 0; i < 32; ++i) {
    real.col(i) << 0.5F + static_cast<float>(random.uniform(-0.1, 0.1)),
        -0.5F + static_cast<float>(random.uniform(-0.1, 0.1));
  }
  for (int round = 0; round < 300; ++round) {
    for (int i = 0; i < 5; ++i) pair.train_critic(real, random);
    pair.train_maker(32, random);
  }
  const Matrix made = pair.make(200, random);
  EXPECT_NEAR(made.row(0).mean(), 0.5, 0.2);
  EXPECT_NEAR(made.row(1).mean(), -0.5, 0.2);
}

}  // namespace
}  // namespace jaywalk::search::learn
