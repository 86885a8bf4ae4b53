#include "experiment/networks/network.h"

#include "experiment/networks/product.h"

namespace jaywalk::networks {
namespace {

constexpr float kNormEpsilon = 1e-6F;

}  // namespace

Network::Network(const NetworkShape& shape, Random& random)
    : slope_(shape.slope),
      first_(shape.inputs, shape.hidden, random),
      second_(shape.hidden, shape.hidden, random),
      third_(shape.hidden, shape.outputs, random) {}

void Network::find_slopes(const Matrix& units, Matrix& slopes) const {
  const float slope = slope_;
  slopes.resize(units.rows(), units.cols());
  const float* const unit = units.data();
  float* const each = slopes.data();
  for (Eigen::Index i = 0; i < units.size(); ++i) each[i] = unit[i] > 0 ? 1.0F : slope;
}

void Network::activate(Matrix& units) const { units = units.cwiseMax(slope_ * units); }

Matrix Network::forward(const Matrix& x) {
  x_ = x;
  first_.forward(x_, h1_);
  activate(h1_);
  second_.forward(h1_, h2_);
  activate(h2_);
  return third_.forward(h2_);
}

Matrix Network::output(const Matrix& x) const {
  Matrix h1 = first_.forward(x);
  activate(h1);
  Matrix h2 = second_.forward(h1);
  activate(h2);
  return third_.forward(h2);
}

const Matrix& Network::backward(const Matrix& d, Gradients gradients) {
  third_.input_gradient(d, d2_);
  find_slopes(h2_, slopes_);
  d2_.array() *= slopes_.array();
  second_.input_gradient(d2_, d1_);
  find_slopes(h1_, slopes_);
  d1_.array() *= slopes_.array();
  if (gradients == Gradients::add) {
    third_.accumulate(d, h2_);
    second_.accumulate(d2_, h1_);
    first_.accumulate(d1_, x_);
  }
  first_.input_gradient(d1_, dx_);
  return dx_;
}

float Network::add_gradient_penalty(const Matrix& x, float weight) {
  Matrix h1 = first_.forward(x);
  activate(h1);
  Matrix slopes1;
  find_slopes(h1, slopes1);
  Matrix slopes2;
  find_slopes(second_.forward(h1), slopes2);
  const Matrix a2 = slopes2.array().colwise() * third_.weights.row(0).transpose().array();
  const Matrix a1 = second_.input_gradient(a2).cwiseProduct(slopes1);
  const Matrix g = first_.input_gradient(a1);

  const Eigen::ArrayXf norm =
      roots((g.array().square().colwise().sum() + kNormEpsilon).transpose());
  const float scale = 2 * weight / static_cast<float>(x.cols());
  const Matrix v = g.array().rowwise() * (scale * (norm - 1) / norm).transpose();

  add_product(a1, v.transpose(), first_.weight_gradient);
  Matrix u1;
  set_product(first_.weights, v, u1);
  u1.array() *= slopes1.array();
  add_product(a2, u1.transpose(), second_.weight_gradient);
  Matrix u2;
  set_product(second_.weights, u1, u2);
  u2.array() *= slopes2.array();
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
