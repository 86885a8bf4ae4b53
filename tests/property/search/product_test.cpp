// Products are what the definition says, bit for bit: so they are the same on every processor.

#include "experiment/networks/product.h"

#include <gtest/gtest.h>

#include "experiment/networks/layer.h"

namespace jaywalk::networks {
namespace {

/// Number by number, rounded to float after each product and each sum.
Matrix by_definition(const Matrix& a, const Matrix& b, const Matrix& to) {
  Matrix sum = to;
  for (Eigen::Index row = 0; row < a.rows(); ++row) {
    for (Eigen::Index column = 0; column < b.cols(); ++column) {
      volatile float total = 0;
      for (Eigen::Index k = 0; k < a.cols(); ++k) {
        const volatile float product = a(row, k) * b(k, column);
        total = total + product;
      }
      sum(row, column) += total;
    }
  }
  return sum;
}

struct Sizes {
  Eigen::Index rows, depth, columns;
};

class Products : public testing::TestWithParam<Sizes> {};

TEST_P(Products, OfTilesAreRoundedAtEachStep) {
  const auto [rows, depth, columns] = GetParam();
  Random random(1);
  const Matrix a = noise(rows, depth, random);
  const Matrix b = noise(depth, columns, random);
  const Matrix across_a = a.transpose();
  const Matrix across_b = b.transpose();
  const Matrix before = noise(rows, columns, random);
  const Matrix wanted = by_definition(a, b, before);
  const auto sum_of = [&](const auto& left, const auto& right) {
    Matrix sum = before;
    add_product(left, right, sum);
    return sum;
  };
  EXPECT_EQ(sum_of(a, b), wanted);
  EXPECT_EQ(sum_of(across_a.transpose(), b), wanted);
  EXPECT_EQ(sum_of(a, across_b.transpose()), wanted);
  EXPECT_EQ(sum_of(across_a.transpose(), across_b.transpose()), wanted);
}

INSTANTIATE_TEST_SUITE_P(OfManySizes, Products,
                         testing::Values(Sizes{16, 1, 2}, Sizes{16, 7, 3}, Sizes{32, 5, 4},
                                         Sizes{48, 100, 9}, Sizes{128, 128, 341},
                                         Sizes{128, 900, 17}, Sizes{64, 0, 3}));

// Others may be added up in another order.
TEST(Products, OfOtherSizesAreNearThem) {
  Random random(2);
  for (const auto& [rows, depth, columns] :
       {Sizes{5, 128, 60}, Sizes{128, 128, 1}, Sizes{1, 1, 1}}) {
    const Matrix a = noise(rows, depth, random);
    const Matrix b = noise(depth, columns, random);
    Matrix sum;
    set_product(a, b, sum);
    const Matrix wanted = by_definition(a, b, Matrix::Zero(rows, columns));
    EXPECT_LT((sum - wanted).cwiseAbs().maxCoeff(), 1e-4F);
  }
}

}  // namespace
}  // namespace jaywalk::networks
