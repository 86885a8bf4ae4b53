// SPDX-License-Identifier: Apache-2.0
#include "search/learn/autoencoder.h"

#include <gtest/gtest.h>

namespace jaywalk::search::learn {
namespace {

constexpr AdamSettings kAdam{.rate = 1e-2F, .beta1 = 0.9F, .beta2 = 0.999F};

/// Samples that lie on one line through the space.
Matrix samples_on_a_line(Eigen::Index count) {
  Matrix samples(4, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const float share = 2 * static_cast<float>(i) / static_cast<float>(count - 1) - 1;
    samples.col(i) << share, -share, 0.5F * share, -0.5F * share;
  }
  return samples;
}

TEST(Autoencoder, MakesSamplesWithinTheirRange) {
  Random random(1);
  const Autoencoder autoencoder(4, kAdam, random);
  const Matrix made = autoencoder.decode(10 * networks::noise(4, 20, random));
  EXPECT_EQ(made.rows(), 4);
  EXPECT_EQ(made.cols(), 20);
  EXPECT_LE(made.cwiseAbs().maxCoeff(), 1);
}

TEST(Autoencoder, LosesLessTheMoreItIsTrained) {
  Random random(2);
  Autoencoder autoencoder(4, kAdam, random);
  const Matrix samples = samples_on_a_line(16);
  const float first = autoencoder.train(samples, random);
  float last = first;
  for (int i = 0; i < 150; ++i) last = autoencoder.train(samples, random);
  EXPECT_LT(last, 0.7F * first);
}

TEST(Autoencoder, IsTheSameForTheSameSeed) {
  const auto trained = [] {
    Random random(3);
    Autoencoder autoencoder(4, kAdam, random);
    for (int i = 0; i < 5; ++i) (void)autoencoder.train(samples_on_a_line(8), random);
    return autoencoder.decode(Matrix::Zero(4, 1)).eval();
  };
  EXPECT_EQ(trained(), trained());
}

TEST(Autoencoder, HasTheGradientsOfItsLoss) {
  Random random(4);
  Autoencoder autoencoder(4, kAdam, random);
  const Matrix samples = samples_on_a_line(6);
  const Matrix chance = networks::noise(4, 6, random);
  const auto loss = [&] {
    for (Layer* const each : autoencoder.layers()) each->clear_gradients();
    return autoencoder.add_loss_gradient(samples, chance);
  };
  (void)loss();
  std::vector<float> gradients;
  for (Layer* const each : autoencoder.layers()) {
    gradients.push_back(each->weight_gradient(0, 0));
    gradients.push_back(each->bias_gradient(0));
  }
  // Short, as units that change their sign within a step would bend the loss.
  constexpr float kStep = 5e-4F;
  std::size_t at = 0;
  for (Layer* const each : autoencoder.layers()) {
    for (float* const value : {&each->weights(0, 0), &each->bias(0)}) {
      const float kept = *value;
      *value = kept + kStep;
      const float above = loss();
      *value = kept - kStep;
      const float below = loss();
      *value = kept;
      EXPECT_NEAR(gradients[at], (above - below) / (2 * kStep), 2e-2) << at;
      ++at;
    }
  }
}

}  // namespace
}  // namespace jaywalk::search::learn
