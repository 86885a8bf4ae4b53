// SPDX-License-Identifier: Apache-2.0
#pragma once

// A variational autoencoder (Kingma and Welling 2014, "Auto-encoding variational Bayes", arXiv
// 1312.6114) with the layers of RILaST: inputs - 128 - 64 - mean and logarithm of the variance of
// the latent variables - 64 - 128 - inputs, rectified linear units, tanh at the end. Read
// experiment/networks/network.h first.

#include <array>

#include "search/learn/adversary.h"

namespace jaywalk::search::learn {

class Autoencoder {
 public:
  /// As many latent variables as inputs.
  Autoencoder(Eigen::Index inputs, const AdamSettings& adam, Random& random);
  Autoencoder(const Autoencoder&) = delete;
  Autoencoder& operator=(const Autoencoder&) = delete;

  /// One step on a column for each sample, from -1 to 1; returns the loss before it.
  float train(const Matrix& samples, Random& random);
  /// The decoded samples, a column for each column of latent variables.
  [[nodiscard]] Matrix decode(const Matrix& latent) const;
  /// The means of the latent variables of samples.
  [[nodiscard]] Matrix encode(const Matrix& samples) const;

  /// The sum of squared errors plus the mean divergence from the standard normal distribution, with
  /// that noise (normal, a column for each sample); adds its gradients to those of the layers.
  float add_loss_gradient(const Matrix& samples, const Matrix& noise);
  [[nodiscard]] std::array<Layer*, 7> layers();

 private:
  Layer encoder1_;
  Layer encoder2_;
  Layer mean_;
  Layer log_variance_;
  Layer decoder1_;
  Layer decoder2_;
  Layer decoder3_;
  Adam optimiser_;
};

}  // namespace jaywalk::search::learn
