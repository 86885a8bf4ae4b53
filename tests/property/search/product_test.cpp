// SPDX-License-Identifier: Apache-2.0
// Products, roots and what Adam makes of them are what the definition says, bit for bit: so they
// are the same on every processor.

#include "experiment/networks/product.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "experiment/networks/network.h"

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

TEST(Products, OfEigenAreCutInOneWay) {
  Random random(1);
  const Layer layer(3, 5, random);
  EXPECT_EQ(Eigen::l1CacheSize(), 32 * 1024);
  EXPECT_EQ(Eigen::l2CacheSize(), 512 * 1024);
  EXPECT_EQ(Eigen::l3CacheSize(), 4096 * 1024);
}

TEST(Roots, AreThoseOfRealNumbersRounded) {
  Random random(3);
  const Eigen::ArrayXf numbers = 1 + noise(1000, 1, random).array();
  const Eigen::ArrayXf wanted = numbers.cast<double>().sqrt().cast<float>();
  EXPECT_TRUE((roots(numbers) == wanted).all());
}

// Kingma and Ba 2015, algorithm 1, number by number.
TEST(Adam, StepsAsItsDefinitionSays) {
  const AdamSettings settings{.rate = 0.01F, .beta1 = 0.9F, .beta2 = 0.999F, .epsilon = 1e-8F};
  Random random(4);
  std::vector<float> values(1001, 0);
  std::vector<float> gradients(values.size());
  for (float& gradient : gradients) gradient = static_cast<float>(random.uniform(-1, 1));
  Adam adam(settings);
  adam.add(values, gradients);
  adam.step();
  const float correction1 = 1 - settings.beta1;
  const float correction2 = 1 - settings.beta2;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const volatile float mean = (1 - settings.beta1) * gradients[i];
    const volatile float squared = gradients[i] * gradients[i];
    const volatile float square = (1 - settings.beta2) * squared;
    const volatile float corrected = square / correction2;
    const volatile float root = std::sqrt(corrected);
    const volatile float below = root + settings.epsilon;
    const volatile float rate = settings.rate / correction1;
    const volatile float above = rate * mean;
    const volatile float step = above / below;
    ASSERT_EQ(values[i], -step) << i;
  }
}

}  // namespace
}  // namespace jaywalk::networks
