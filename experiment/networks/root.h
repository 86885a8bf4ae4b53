#pragma once

// Square roots of floats that are the same on every processor. Eigen's `sqrt()` and `rsqrt()` begin
// with the processor's own estimate (the instruction rsqrtps), which differs from maker to maker.

#include <Eigen/Dense>
#include <cmath>

namespace jaywalk::networks {

/// Each number's square root, rounded as IEEE 754 says.
[[nodiscard]] inline Eigen::ArrayXf roots(Eigen::ArrayXf numbers) {
  for (float& number : numbers) number = std::sqrt(number);
  return numbers;
}

}  // namespace jaywalk::networks
