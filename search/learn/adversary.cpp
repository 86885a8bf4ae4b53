// SPDX-License-Identifier: Apache-2.0
#include "search/learn/adversary.h"

#include "experiment/networks/product.h"

namespace jaywalk::search::learn {
namespace {

constexpr float kMomentum = 0.1F;
constexpr float kVarianceEpsilon = 1e-5F;

AdamSettings wasserstein_adam(float rate) { return {.rate = rate, .beta1 = 0, .beta2 = 0.9F}; }

}  // namespace

TestMaker::TestMaker(const NetworkShape& shape, Normalisation normalisation, Random& random)
    : network_(shape, random),
      normalisation_(normalisation),
      scale_(Vector::Ones(shape.outputs)),
      shift_(Vector::Zero(shape.outputs)),
      scale_gradient_(Vector::Zero(shape.outputs)),
      shift_gradient_(Vector::Zero(shape.outputs)),
      running_mean_(Vector::Zero(shape.outputs)),
      running_variance_(Vector::Ones(shape.outputs)) {}

Matrix TestMaker::normalise(const Matrix& output, Pass pass) {
  Vector mean = running_mean_;
  Vector variance = running_variance_;
  if (pass == Pass::training) {
    const auto count = static_cast<float>(output.cols());
    mean = output.rowwise().mean();
    variance = (output.colwise() - mean).array().square().rowwise().mean();
    running_mean_ = (1 - kMomentum) * running_mean_ + kMomentum * mean;
    running_variance_ =
        // The running variance is the unbiased one, as in PyTorch; the batch is scaled by the
        // biased one.
        (1 - kMomentum) * running_variance_ + kMomentum * variance * (count / (count - 1));
  }
  inverse_deviation_ = 1 / networks::roots(variance.array() + kVarianceEpsilon);
  normalised_ = (output.colwise() - mean).array().colwise() * inverse_deviation_.array();
  return (normalised_.array().colwise() * scale_.array()).colwise() + shift_.array();
}

Matrix TestMaker::forward(const Matrix& noise, Pass pass) {
  Matrix output = network_.forward(noise);
  if (normalisation_ == Normalisation::batch) output = normalise(output, pass);
  output_ = output.array().tanh();
  return output_;
}

void TestMaker::backward(const Matrix& d) {
  network_.clear_gradients();
  // Backwards through tanh, whose derivative is 1 - tanh².
  Matrix gradient = d.array() * (1 - output_.array().square());
  if (normalisation_ == Normalisation::batch) {
    shift_gradient_ = gradient.rowwise().sum();
    scale_gradient_ = gradient.cwiseProduct(normalised_).rowwise().sum();
    // Mean and deviation depend on every column: their parts are taken off the gradient.
    const Matrix scaled = gradient.array().colwise() * scale_.array();
    const Vector mean = scaled.rowwise().mean();
    const Vector slope = scaled.cwiseProduct(normalised_).rowwise().mean();
    const Matrix along = normalised_.array().colwise() * slope.array();
    gradient = ((scaled.colwise() - mean) - along).array().colwise() * inverse_deviation_.array();
  }
  network_.backward(gradient);
}

void TestMaker::add_to(Adam& optimiser) {
  network_.add_to(optimiser);
  if (normalisation_ == Normalisation::none) return;
  optimiser.add({scale_.data(), count()}, {scale_gradient_.data(), count()});
  optimiser.add({shift_.data(), count()}, {shift_gradient_.data(), count()});
}

WassersteinPair::WassersteinPair(const WassersteinSettings& s, Random& random)
    : settings_(s),
      maker_({.inputs = s.noise, .hidden = s.hidden, .outputs = s.dimension}, s.normalisation,
             random),
      critic_({.inputs = s.dimension, .hidden = s.hidden, .outputs = 1, .slope = s.critic_slope},
              random),
      maker_optimiser_(wasserstein_adam(s.rate)),
      critic_optimiser_(wasserstein_adam(s.rate)) {
  maker_.add_to(maker_optimiser_);
  critic_.add_to(critic_optimiser_);
}

float WassersteinPair::train_critic(const Matrix& real, Random& random) {
  const Eigen::Index count = real.cols();
  const Matrix made = maker_.forward(noise(settings_.noise, count, random), Pass::training);
  Matrix between(real.rows(), count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto share = static_cast<float>(random.uniform(0, 1));
    // Places between real and made tests, at which the critic's slope is held to 1 (Gulrajani et
    // al., WGAN-GP).
    between.col(i) = share * real.col(i) + (1 - share) * made.col(i);
  }
  Matrix both(real.rows(), 2 * count);
  both << made, real;
  const float weight = 1 / static_cast<float>(count);
  Matrix d(1, 2 * count);
  // The critic's loss is its mean score of made tests less that of real ones.
  d << Matrix::Constant(1, count, weight), Matrix::Constant(1, count, -weight);
  critic_.clear_gradients();
  const Matrix scores = critic_.forward(both);
  critic_.backward(d);
  const float penalty = critic_.add_gradient_penalty(between, settings_.penalty);
  critic_optimiser_.step();
  return scores.leftCols(count).mean() - scores.rightCols(count).mean() +
         settings_.penalty * penalty;
}

float WassersteinPair::train_maker(Eigen::Index batch, Random& random) {
  const Matrix made = maker_.forward(noise(settings_.noise, batch, random), Pass::training);
  const Matrix scores = critic_.forward(made);
  const Matrix d = Matrix::Constant(1, batch, -1 / static_cast<float>(batch));
  // Through the critic to the test maker, without changing the critic.
  maker_.backward(critic_.backward(d, Network::Gradients::none));
  maker_optimiser_.step();
  return -scores.mean();
}

Matrix WassersteinPair::make(Eigen::Index count, Random& random) {
  return maker_.forward(noise(settings_.noise, count, random), Pass::generating);
}

namespace {

// Away from 0 and 1, where the logit is infinite.
Eigen::ArrayXXf squeezed(const Matrix& p) { return 0.98F * p.array() + 0.01F; }
Eigen::ArrayXXf logit(const Eigen::ArrayXXf& p) { return (p / (1 - p)).log(); }

/// The loss of predictions and its gradient by the network's output, before the sigmoid.
struct LogitLoss {
  float loss = 0;
  Matrix gradient;
};
LogitLoss logit_loss(const Matrix& predicted, const Matrix& wanted) {
  const Eigen::ArrayXXf p = predicted.array();
  const Eigen::ArrayXXf q = squeezed(predicted);
  const Eigen::ArrayXXf error = logit(q) - logit(squeezed(wanted));
  const auto count = static_cast<float>(predicted.cols());
  return {error.square().mean(),
          // The chain rule: the square, the logit, the squeezing, the sigmoid.
          (2 / count * error * 0.98F / (q * (1 - q)) * p * (1 - p)).matrix()};
}

}  // namespace

Analyzer::Analyzer(const AnalyzerSettings& settings, Random& random)
    : settings_(settings), network_(settings.shape, random), optimiser_(settings.adam) {
  network_.add_to(optimiser_);
}

Matrix Analyzer::predict(const Matrix& tests) {
  return (1 / (1 + (-network_.forward(tests).array()).exp())).matrix();
}

float Analyzer::add_loss_gradient(const Matrix& tests, const Matrix& fitness) {
  const LogitLoss result = logit_loss(predict(tests), fitness);
  network_.backward(result.gradient);
  float squares = 0;
  for (Layer* layer : network_.layers()) {
    squares += layer->weights.squaredNorm() + layer->bias.squaredNorm();
    layer->weight_gradient += 2 * settings_.regularisation * layer->weights;
    layer->bias_gradient += 2 * settings_.regularisation * layer->bias;
  }
  return result.loss + settings_.regularisation * squares;
}

float Analyzer::train(const Matrix& tests, const Matrix& fitness) {
  network_.clear_gradients();
  const float loss = add_loss_gradient(tests, fitness);
  optimiser_.step();
  return loss;
}

Matrix Analyzer::input_gradient(const Matrix& tests, const Matrix& fitness) {
  const LogitLoss result = logit_loss(predict(tests), fitness);
  return network_.backward(result.gradient, Network::Gradients::none);
}

}  // namespace jaywalk::search::learn
