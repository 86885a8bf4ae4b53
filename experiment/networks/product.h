// SPDX-License-Identifier: Apache-2.0
#pragma once

// Products of matrices, which is where training spends its time, and square roots, alike on every
// processor. Read network.h next.

#include <Eigen/Dense>
#include <cmath>

namespace jaywalk::networks {

/// A matrix of floats as it lies in memory, transposed or not.
struct Factor {
  const float* data = nullptr;
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
  /// From a number to the one below, and to the one on the right.
  Eigen::Index down = 1;
  Eigen::Index right = 1;
};

template <class Expression>
[[nodiscard]] Factor factor_of(const Expression& matrix) {
  const bool by_rows = Expression::IsRowMajor;
  return {.data = matrix.data(),
          .rows = matrix.rows(),
          .columns = matrix.cols(),
          .down = by_rows ? matrix.outerStride() : matrix.innerStride(),
          .right = by_rows ? matrix.innerStride() : matrix.outerStride()};
}

/// A tiled product needs a first factor whose number of rows is a multiple of this.
inline constexpr Eigen::Index kRowsOfTiles = 16;

/// Eigen cuts products to what the processor's caches hold and adds them up piece by piece. From
/// the first call on it takes the caches of one processor for those of all (32, 512 and 4,096 KB),
/// so that sums are rounded alike everywhere. Call this before multiplying large matrices.
void fix_order_of_sums();

/// sum += a b, each number of the product added up in order of the inner index and rounded to float
/// at each step: the same bits with whatever vector registers the processor has.
/// REQUIRES: a.rows % kRowsOfTiles == 0, a.columns == b.rows; `sum` has a's rows and b's columns
/// and is neither of the two.
void add_tiled_product(const Factor& a, const Factor& b, Eigen::MatrixXf& sum);

/// sum += a b for matrices and transposed matrices. The large products are those of hidden layers,
/// which have a multiple of 16 units; others are Eigen's.
template <class A, class B>
void add_product(const A& a, const B& b, Eigen::MatrixXf& sum) {
  if (a.rows() % kRowsOfTiles == 0 && b.cols() > 1) {
    add_tiled_product(factor_of(a), factor_of(b), sum);
  } else {
    sum.noalias() += a * b;
  }
}

template <class A, class B>
void set_product(const A& a, const B& b, Eigen::MatrixXf& product) {
  product.setZero(a.rows(), b.cols());
  add_product(a, b, product);
}

/// Each number's square root, rounded as IEEE 754 says. Eigen's `sqrt()` and `rsqrt()` begin with
/// the processor's own estimate (the instruction rsqrtps), which differs from maker to maker.
[[nodiscard]] inline Eigen::ArrayXf roots(Eigen::ArrayXf numbers) {
  for (float& number : numbers) number = std::sqrt(number);
  return numbers;
}

}  // namespace jaywalk::networks
