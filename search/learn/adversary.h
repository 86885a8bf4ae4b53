// SPDX-License-Identifier: Apache-2.0
#pragma once

// The networks of the online adversarial generators: the one that makes tests from noise, the
// Wasserstein pair of it and a critic, and the analyzer that predicts a test's fitness. Not
// movable: the optimisers point into them. Read network.h first.

#include "experiment/networks/network.h"
#include "experiment/networks/random.h"

namespace jaywalk::search::learn {

using networks::Adam;
using networks::AdamSettings;
using networks::Layer;
using networks::Matrix;
using networks::Network;
using networks::NetworkShape;
using networks::noise;
using networks::Random;
using networks::Vector;

enum class Pass { training, generating };

/// Noise -> network -> batch normalisation (Ioffe and Szegedy 2015) if wanted -> tanh.
class TestMaker {
 public:
  enum class Normalisation { batch, none };

  TestMaker(const NetworkShape& shape, Normalisation normalisation, Random& random);
  TestMaker(const TestMaker&) = delete;
  TestMaker& operator=(const TestMaker&) = delete;

  /// While training, with the statistics of the batch (which go into the running ones, momentum
  /// 0.1); while generating, with the running ones.
  Matrix forward(const Matrix& noise, Pass pass);
  /// Sets the gradients of a loss whose gradient by the last output is `d`.
  void backward(const Matrix& d);
  void add_to(Adam& optimiser);

  [[nodiscard]] Network& network() { return network_; }
  [[nodiscard]] std::span<float> scale() { return {scale_.data(), count()}; }
  [[nodiscard]] std::span<const float> scale_gradient() const {
    return {scale_gradient_.data(), count()};
  }

 private:
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(scale_.size()); }
  Matrix normalise(const Matrix& output, Pass pass);

  Network network_;
  Normalisation normalisation_;
  Vector scale_;
  Vector shift_;
  Vector scale_gradient_;
  Vector shift_gradient_;
  Vector running_mean_;
  Vector running_variance_;
  // Values of the last forward pass.
  Matrix normalised_;
  Vector inverse_deviation_;
  Matrix output_;
};

struct WassersteinSettings {
  Eigen::Index dimension = 1;
  Eigen::Index noise = 10;
  Eigen::Index hidden = 128;
  float critic_slope = 0.1F;
  float rate = 5e-5F;
  float penalty = 10;
  TestMaker::Normalisation normalisation = TestMaker::Normalisation::batch;
};

/// A generator and a critic that distinguishes real tests from its own.
class WassersteinPair {
 public:
  WassersteinPair(const WassersteinSettings& settings, Random& random);

  /// One step of the critic on as many made tests as there are real ones; returns its loss.
  float train_critic(const Matrix& real, Random& random);
  /// One step of the generator against the critic; returns its loss.
  float train_maker(Eigen::Index batch, Random& random);
  [[nodiscard]] Matrix make(Eigen::Index count, Random& random);

 private:
  WassersteinSettings settings_;
  TestMaker maker_;
  Network critic_;
  Adam maker_optimiser_;
  Adam critic_optimiser_;
};

struct AnalyzerSettings {
  NetworkShape shape;
  AdamSettings adam;
  /// Times the sum of all squared parameters.
  float regularisation = 0;
};

/// Predicts the fitness (0 to 1) of tests: a sigmoid on a network, trained on the squared
/// difference of logits, each of 0.98 p + 0.01.
class Analyzer {
 public:
  Analyzer(const AnalyzerSettings& settings, Random& random);
  Analyzer(const Analyzer&) = delete;
  Analyzer& operator=(const Analyzer&) = delete;

  [[nodiscard]] Matrix predict(const Matrix& tests);
  /// One step on all of them; returns the loss before it.
  float train(const Matrix& tests, const Matrix& fitness);
  /// The gradient by the tests of the loss against these fitnesses; the weights stay as they are.
  [[nodiscard]] Matrix input_gradient(const Matrix& tests, const Matrix& fitness);

  /// The loss, adding its gradients to those of the network.
  float add_loss_gradient(const Matrix& tests, const Matrix& fitness);
  [[nodiscard]] Network& network() { return network_; }

 private:
  AnalyzerSettings settings_;
  Network network_;
  Adam optimiser_;
};

}  // namespace jaywalk::search::learn
