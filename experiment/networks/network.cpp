// SPDX-License-Identifier: Apache-2.0
#include "experiment/networks/network.h"

#include <cmath>
#include <utility>

#include "experiment/networks/product.h"

namespace jaywalk::networks {
namespace {

template <class T>
void fill_uniform(T& values, double bound, Random& random) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    values.data()[i] = static_cast<float>(random.uniform(-bound, bound));
  }
}

constexpr float kNormEpsilon = 1e-6F;

}  // namespace

Matrix noise(Eigen::Index rows, Eigen::Index columns, Random& random) {
  Matrix values(rows, columns);
  fill_uniform(values, 1, random);
  return values;
}

Layer::Layer(Eigen::Index inputs, Eigen::Index outputs, Random& random)
    : weights(outputs, inputs), bias(outputs) {
  fix_order_of_sums();
  const double bound = 1 / std::sqrt(static_cast<double>(inputs));
  fill_uniform(weights, bound, random);
  fill_uniform(bias, bound, random);
  weight_gradient = Matrix::Zero(outputs, inputs);
  bias_gradient = Vector::Zero(outputs);
}

void Layer::clear_gradients() {
  weight_gradient.setZero();
  bias_gradient.setZero();
}

void Adam::add(std::span<float> values, std::span<const float> gradients) {
  const auto size = static_cast<Eigen::Index>(values.size());
  slots_.push_back({values, gradients, Eigen::ArrayXf::Zero(size), Eigen::ArrayXf::Zero(size)});
}

void Adam::add(Layer& layer) {
  const auto all = [](auto& matrix) {
    return std::span(matrix.data(), static_cast<std::size_t>(matrix.size()));
  };
  add(all(layer.weights), all(layer.weight_gradient));
  add(all(layer.bias), all(layer.bias_gradient));
}

void Adam::step() {
  ++steps_;
  const float b1 = settings_.beta1;
  const float b2 = settings_.beta2;
  const float correction1 = 1 - std::pow(b1, static_cast<float>(steps_));
  const float correction2 = 1 - std::pow(b2, static_cast<float>(steps_));
  for (Slot& slot : slots_) {
    const auto size = static_cast<Eigen::Index>(slot.values.size());
    Eigen::Map<Eigen::ArrayXf> values(slot.values.data(), size);
    const Eigen::Map<const Eigen::ArrayXf> gradients(slot.gradients.data(), size);
    slot.mean = b1 * slot.mean + (1 - b1) * gradients;
    slot.square = b2 * slot.square + (1 - b2) * gradients.square();
    values -= settings_.rate / correction1 * slot.mean /
              (roots(slot.square / correction2) + settings_.epsilon);
  }
}

Adam::Memory Adam::memory() const {
  Memory memory{.steps = steps_, .moments = {}};
  for (const Slot& slot : slots_) {
    for (const Eigen::ArrayXf* const part : {&slot.mean, &slot.square}) {
      memory.moments.insert(memory.moments.end(), part->begin(), part->end());
    }
  }
  return memory;
}

bool Adam::restore(const Memory& memory) {
  Eigen::Index count = 0;
  for (const Slot& slot : slots_) count += 2 * slot.mean.size();
  if (std::cmp_not_equal(memory.moments.size(), count)) return false;
  steps_ = memory.steps;
  const float* next = memory.moments.data();
  for (Slot& slot : slots_) {
    for (Eigen::ArrayXf* const part : {&slot.mean, &slot.square}) {
      *part = Eigen::Map<const Eigen::ArrayXf>(next, part->size());
      next += part->size();
    }
  }
  return true;
}

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
