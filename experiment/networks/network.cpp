#include "experiment/networks/network.h"

namespace jaywalk::networks {
namespace {

constexpr float kNormEpsilon = 1e-6F;

}  // namespace

Network::Network(const NetworkShape& shape, Random& random)
    : slope_(shape.slope),
      first_(shape.inputs, shape.hidden, random),
      second_(shape.hidden, shape.hidden, random),
      third_(shape.hidden, shape.outputs, random) {}

Matrix Network::slopes(const Matrix& z) const {
  const float slope = slope_;
  return z.unaryExpr([slope](float value) { return value > 0 ? 1.0F : slope; });
}

Matrix Network::activated(const Matrix& z) const {
  const float slope = slope_;
  return z.unaryExpr([slope](float value) { return value > 0 ? value : slope * value; });
}

Matrix Network::forward(const Matrix& x) {
  x_ = x;
  z1_ = first_.forward(x_);
  h1_ = activated(z1_);
  z2_ = second_.forward(h1_);
  h2_ = activated(z2_);
  return third_.forward(h2_);
}

Matrix Network::output(const Matrix& x) const {
  return third_.forward(activated(second_.forward(activated(first_.forward(x)))));
}

Matrix Network::backward(const Matrix& d, Gradients gradients) {
  const Matrix d2 = (third_.weights.transpose() * d).cwiseProduct(slopes(z2_));
  const Matrix d1 = (second_.weights.transpose() * d2).cwiseProduct(slopes(z1_));
  if (gradients == Gradients::add) {
    third_.accumulate(d, h2_);
    second_.accumulate(d2, h1_);
    first_.accumulate(d1, x_);
  }
  return first_.weights.transpose() * d1;
}

float Network::add_gradient_penalty(const Matrix& x, float weight) {
  const Matrix z1 = first_.forward(x);
  const Matrix slopes1 = slopes(z1);
  const Matrix slopes2 = slopes(second_.forward(activated(z1)));
  const Matrix a2 = slopes2.array().colwise() * third_.weights.row(0).transpose().array();
  const Matrix a1 = (second_.weights.transpose() * a2).cwiseProduct(slopes1);
  const Matrix g = first_.weights.transpose() * a1;

  const Eigen::ArrayXf norm =
      (g.array().square().colwise().sum() + kNormEpsilon).sqrt().transpose();
  const float scale = 2 * weight / static_cast<float>(x.cols());
  const Matrix v = g.array().rowwise() * (scale * (norm - 1) / norm).transpose();

  first_.weight_gradient.noalias() += a1 * v.transpose();
  const Matrix u1 = (first_.weights * v).cwiseProduct(slopes1);
  second_.weight_gradient.noalias() += a2 * u1.transpose();
  const Matrix u2 = (second_.weights * u1).cwiseProduct(slopes2);
  third_.weight_gradient += u2.rowwise().sum().transpose();
  return (norm - 1).square().mean();
}

void Network::clear_gradients() {
  for (Layer* layer : layers()) layer->clear_gradients();
}

void Network::add_to(Adam& optimiser) {
  for (Layer* layer : layers()) optimiser.add(*layer);
}

}  // namespace jaywalk::networks
