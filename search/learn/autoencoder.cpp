// SPDX-License-Identifier: Apache-2.0
#include "search/learn/autoencoder.h"

namespace jaywalk::search::learn {
namespace {

constexpr Eigen::Index kOuterUnits = 128;
constexpr Eigen::Index kInnerUnits = 64;

Matrix rectified(const Matrix& z) { return z.cwiseMax(0); }

/// The gradient by a rectified layer's sum, from that by its output.
Matrix through(const Matrix& d, const Matrix& output) { return (output.array() > 0).select(d, 0); }

}  // namespace

Autoencoder::Autoencoder(Eigen::Index inputs, const AdamSettings& adam, Random& random)
    : encoder1_(inputs, kOuterUnits, random),
      encoder2_(kOuterUnits, kInnerUnits, random),
      mean_(kInnerUnits, inputs, random),
      log_variance_(kInnerUnits, inputs, random),
      decoder1_(inputs, kInnerUnits, random),
      decoder2_(kInnerUnits, kOuterUnits, random),
      decoder3_(kOuterUnits, inputs, random),
      optimiser_(adam) {
  for (Layer* layer : layers()) optimiser_.add(*layer);
}

std::array<Layer*, 7> Autoencoder::layers() {
  return {&encoder1_, &encoder2_, &mean_, &log_variance_, &decoder1_, &decoder2_, &decoder3_};
}

Matrix Autoencoder::encode(const Matrix& samples) const {
  return mean_.forward(rectified(encoder2_.forward(rectified(encoder1_.forward(samples)))));
}

Matrix Autoencoder::decode(const Matrix& latent) const {
  return decoder3_.forward(rectified(decoder2_.forward(rectified(decoder1_.forward(latent)))))
      .array()
      .tanh();
}

float Autoencoder::add_loss_gradient(const Matrix& samples, const Matrix& noise) {
  const auto count = static_cast<float>(samples.cols());
  const Matrix h1 = rectified(encoder1_.forward(samples));
  const Matrix h2 = rectified(encoder2_.forward(h1));
  const Matrix mean = mean_.forward(h2);
  const Matrix log_variance = log_variance_.forward(h2);
  const Matrix deviation = (0.5F * log_variance.array()).exp();
  const Matrix latent = mean + deviation.cwiseProduct(noise);
  const Matrix h3 = rectified(decoder1_.forward(latent));
  const Matrix h4 = rectified(decoder2_.forward(h3));
  const Matrix output = decoder3_.forward(h4).array().tanh();

  const Matrix error = output - samples;
  const Matrix d_output = 2 * error.array() * (1 - output.array().square());
  decoder3_.accumulate(d_output, h4);
  const Matrix d4 = through(decoder3_.input_gradient(d_output), h4);
  decoder2_.accumulate(d4, h3);
  const Matrix d3 = through(decoder2_.input_gradient(d4), h3);
  decoder1_.accumulate(d3, latent);
  const Matrix d_latent = decoder1_.input_gradient(d3);
  // Gradients of the divergence -1/2 sum(1 + v - m² - exp v) / count.
  const Matrix d_mean = d_latent + mean / count;
  const Matrix d_log_variance = 0.5F * d_latent.array() * noise.array() * deviation.array() +
                                0.5F / count * (log_variance.array().exp() - 1);
  mean_.accumulate(d_mean, h2);
  log_variance_.accumulate(d_log_variance, h2);
  const Matrix d2 =
      through(mean_.input_gradient(d_mean) + log_variance_.input_gradient(d_log_variance), h2);
  encoder2_.accumulate(d2, h1);
  encoder1_.accumulate(through(encoder2_.input_gradient(d2), h1), samples);
  const float divergence =
      -0.5F *
      (1 + log_variance.array() - mean.array().square() - log_variance.array().exp()).sum() / count;
  return error.squaredNorm() + divergence;
}

float Autoencoder::train(const Matrix& samples, Random& random) {
  Matrix noise(samples.rows(), samples.cols());
  for (float& each : noise.reshaped()) each = static_cast<float>(standard_normal(random));
  for (Layer* layer : layers()) layer->clear_gradients();
  const float loss = add_loss_gradient(samples, noise);
  optimiser_.step();
  return loss;
}

}  // namespace jaywalk::search::learn
