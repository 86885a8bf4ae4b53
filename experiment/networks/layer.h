#pragma once

// A fully connected layer and the optimiser of its weights. A matrix has one sample per column.
// Initial weights and Adam are those of PyTorch. Read network.h next.

#include <Eigen/Dense>
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

}  // namespace jaywalk::networks
