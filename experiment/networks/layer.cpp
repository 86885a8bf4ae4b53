#include "experiment/networks/layer.h"

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

}  // namespace jaywalk::networks
