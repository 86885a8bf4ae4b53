// SPDX-License-Identifier: Apache-2.0
#pragma once

// Derivatives compared with finite differences.

#include <cmath>
#include <functional>

#include "experiment/networks/network.h"

namespace jaywalk::networks {

/// Compares many derivatives with differences to both sides. Where a unit changes its sign within a
/// step, losses bend and penalties jump, so that the two sides disagree; those are left out, and
/// counted.
class Comparison {
 public:
  explicit Comparison(float step = 1e-3F) : step_(step) {}

  void add(double derived, float& number, const std::function<double()>& loss) {
    const float kept = number;
    const double here = loss();
    number = kept + step_;
    const double above = (loss() - here) / static_cast<double>(step_);
    number = kept - step_;
    const double below = (here - loss()) / static_cast<double>(step_);
    number = kept;
    const double differenced = (above + below) / 2;
    ++count_;
    if (std::fabs(above - below) > 0.02 * (0.1 + std::fabs(differenced))) {
      ++left_out_;
      return;
    }
    error_ += (derived - differenced) * (derived - differenced);
    size_ += differenced * differenced;
  }
  /// The error of all together, relative to their size.
  [[nodiscard]] double relative_error() const { return std::sqrt(error_ / size_); }
  [[nodiscard]] double share_left_out() const { return left_out_ / count_; }

 private:
  float step_;
  double error_ = 0;
  double size_ = 0;
  double count_ = 0;
  double left_out_ = 0;
};

inline void compare_parameters(Network& network, const std::function<double()>& loss,
                               Comparison& result) {
  for (Layer* layer : network.layers()) {
    const Matrix weights = layer->weight_gradient;
    const Vector bias = layer->bias_gradient;
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      result.add(static_cast<double>(weights.data()[i]), layer->weights.data()[i], loss);
    }
    for (Eigen::Index i = 0; i < bias.size(); ++i) {
      result.add(static_cast<double>(bias[i]), layer->bias[i], loss);
    }
  }
}

}  // namespace jaywalk::networks
