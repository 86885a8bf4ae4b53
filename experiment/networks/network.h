// SPDX-License-Identifier: Apache-2.0
#pragma once

// A fully connected layer and the optimiser of its weights; initial weights and Adam are those of
// PyTorch. Networks of two hidden layers with (leaky) rectified linear units and a linear output:
// forward, backward, and the gradient penalty of a Wasserstein critic in closed form. A matrix has
// one sample per column. Read product.h first.

#include <Eigen/Dense>
#include <array>
#include <span>
#include <vector>

#include "experiment/networks/product.h"
#include "experiment/networks/random.h"

namespace jaywalk::networks {

using Matrix = Eigen::MatrixXf;
using Vector = Eigen::VectorXf;

/// Uniform in [-1, 1).
[[nodiscard]] Matrix noise(Eigen::Index rows, Eigen::Index columns, Random& random);

struct Layer {
  Matrix weights;
  Vector bias;
  /// The loss's gradient, added up by backward passes.
  Matrix weight_gradient;
  Vector bias_gradient;

  /// Uniform within 1 / sqrt(inputs), as torch.nn.Linear.
  Layer(Eigen::Index inputs, Eigen::Index outputs, Random& random);

  [[nodiscard]] Matrix forward(const Matrix& x) const {
    Matrix output;
    forward(x, output);
    return output;
  }
  void forward(const Matrix& x, Matrix& output) const {
    set_product(weights, x, output);
    output.colwise() += bias;
  }
  /// Adds the gradients of a loss whose gradient by the output is `d`.
  void accumulate(const Matrix& d, const Matrix& x) {
    add_product(d, x.transpose(), weight_gradient);
    bias_gradient += d.rowwise().sum();
  }
  /// The loss's gradient by the input.
  [[nodiscard]] Matrix input_gradient(const Matrix& d) const {
    Matrix gradient;
    input_gradient(d, gradient);
    return gradient;
  }
  void input_gradient(const Matrix& d, Matrix& gradient) const {
    set_product(weights.transpose(), d, gradient);
  }
  void clear_gradients();
};

struct AdamSettings {
  float rate = 1e-3F;
  float beta1 = 0;
  float beta2 = 0.9F;
  float epsilon = 1e-8F;
};

/// Kingma and Ba 2015, "Adam: a method for stochastic optimization", algorithm 1.
class Adam {
 public:
  explicit Adam(const AdamSettings& settings) : settings_(settings) {}

  /// The numbers and their gradients must outlive it and stay where they are.
  void add(std::span<float> values, std::span<const float> gradients);
  void add(Layer& layer);
  void step();

  /// The optimiser's state, so that another one with the same numbers continues identically.
  struct Memory {
    int steps = 0;
    std::vector<float> moments;
  };
  [[nodiscard]] Memory memory() const;
  /// False, and nothing is changed, if that is of other numbers.
  [[nodiscard]] bool restore(const Memory& memory);

 private:
  struct Slot {
    std::span<float> values;
    std::span<const float> gradients;
    Eigen::ArrayXf mean;
    Eigen::ArrayXf square;
  };

  AdamSettings settings_;
  std::vector<Slot> slots_;
  int steps_ = 0;
};

struct NetworkShape {
  Eigen::Index inputs = 1;
  Eigen::Index hidden = 1;
  Eigen::Index outputs = 1;
  /// Slope of the hidden units below zero, 0 (plain ReLU) to 1.
  float slope = 0;
};

class Network {
 public:
  Network(const NetworkShape& shape, Random& random);

  /// Keeps what backward() needs.
  Matrix forward(const Matrix& x);
  /// Like forward(), but keeps nothing for a backward pass.
  [[nodiscard]] Matrix output(const Matrix& x) const;

  enum class Gradients { add, none };
  /// `d`: the loss's gradient by the output of the last forward pass. Returns that by its input.
  const Matrix& backward(const Matrix& d, Gradients gradients = Gradients::add);

  /// Adds the gradient of weight * mean_i (|dC(x_i)/dx| - 1)^2 and returns that mean; C is this
  /// network, which has one output. (Gulrajani et al. 2017, "Improved training of Wasserstein
  /// GANs", section 4; the norm is sqrt(|g|^2 + 1e-6).)
  ///
  /// C is linear wherever no unit changes its sign, so g = W1' D1 W2' D2 w3 with the units' slopes
  /// D1, D2, and the penalty's gradient is one more pass of v = dP/dg through the same chain: dW1 =
  /// a1 v', dW2 = a2 u1', dw3 = D2 W2 u1 with a2 = D2 w3, a1 = D1 W2' a2, u1 = D1 W1 v; none for
  /// biases.
  float add_gradient_penalty(const Matrix& x, float weight);

  [[nodiscard]] std::array<Layer*, 3> layers() { return {&first_, &second_, &third_}; }
  [[nodiscard]] std::array<const Layer*, 3> layers() const { return {&first_, &second_, &third_}; }
  void clear_gradients();
  void add_to(Adam& optimiser);

 private:
  /// The slopes of units, from their sums or their outputs, which have the same signs.
  void find_slopes(const Matrix& units, Matrix& slopes) const;
  void activate(Matrix& units) const;

  float slope_;
  Layer first_;
  Layer second_;
  Layer third_;
  // The last forward pass: the input and the hidden layers' outputs.
  Matrix x_;
  Matrix h1_;
  Matrix h2_;
  // The last backward pass: the loss's gradients by the hidden layers' sums and by the input.
  Matrix d1_;
  Matrix d2_;
  Matrix dx_;
  Matrix slopes_;
};

}  // namespace jaywalk::networks
