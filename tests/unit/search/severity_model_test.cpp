// SPDX-License-Identifier: Apache-2.0
#include "search/learn/severity_model.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "search/test_input.h"

namespace jaywalk::search::learn {
namespace {

double probability(const SeverityModel& model, std::array<double, 2> place) {
  SeverityModel::Places places(2, 1);
  places << place[0], place[1];
  return model.failure_probability(places)(0);
}

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2)); }

// One observation y at distance d, with the prior mean 0.6, noise 0.1 and length 0.8: k =
// exp(-d² / (2 * 0.64)), mean 0.6 + k / 1.1 (y - 0.6), variance s (0.1 + 1 - k² / 1.1) with s =
// (y - 0.6)² / 1.1.
TEST(SeverityModel, AgreesWithTheFormulaForOneObservation) {
  SeverityModel model({{1, 0}, {1, 0}});
  model.add(std::array{0.3, -0.4}, 1.05);
  const double k = std::exp(-0.5 * 0.5 / (2 * 0.64));
  const double s = 0.45 * 0.45 / 1.1;
  const double mean = 0.6 + k / 1.1 * 0.45;
  EXPECT_NEAR(probability(model, {0, 0}),
              normal_cdf((mean - 1) / std::sqrt(s * (1.1 - k * k / 1.1))), 1e-9);
}

// Two observations: the factor was made row by row; here with the inverse of a 2 x 2 matrix.
TEST(SeverityModel, AgreesWithTheFormulaForTwoObservations) {
  SeverityModel model({{1, 0}, {2, 1}});
  model.add(std::array{0.0, 0.0}, 1.05);
  model.add(std::array{0.8, 0.0}, 0.2);
  const double k12 = std::exp(-0.5);
  const double det = 1.1 * 1.1 - k12 * k12;
  // At the first one: k = (1, k12).
  const double y1 = 0.45;
  const double y2 = -0.4;
  const double a1 = (1.1 * y1 - k12 * y2) / det;
  const double a2 = (1.1 * y2 - k12 * y1) / det;
  const double mean = 0.6 + a1 + k12 * a2;
  const double s = (y1 * a1 + y2 * a2) / 2;
  const double explained = (1.1 - 2 * k12 * k12 + 1.1 * k12 * k12) / det;
  EXPECT_NEAR(probability(model, {0, 0}), normal_cdf((mean - 1) / std::sqrt(s * (1.1 - explained))),
              1e-9);
}

TEST(SeverityModel, KnowsNothingWithoutObservations) {
  const SeverityModel model({{1, 0}, {1, 0}});
  EXPECT_LT(probability(model, {0, 0}), 0.5);
}

/// Fails within 0.5 of the origin; the second number is all that matters less.
void observe_disc(SeverityModel& model, int count) {
  Random random(4);
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    model.add(std::array{x, y}, std::min(1.05, 1.5 - std::hypot(x, y)));
  }
}

TEST(SeverityModel, LearnsWhereTestsFail) {
  SeverityModel model({{1, 0}, {1, 0}});
  observe_disc(model, 95);
  EXPECT_GT(probability(model, {0, 0.1}), 0.8);
  EXPECT_GT(probability(model, {0.25, 0}), 0.6);
  EXPECT_LT(probability(model, {0.8, 0}), 0.2);
  EXPECT_LT(probability(model, {-0.6, 0.6}), 0.2);
}

TEST(SeverityModel, ForgetsTheOldestOfVeryManyObservations) {
  SeverityModel model({{1, 0}, {1, 0}});
  for (int i = 0; i < 30; ++i) model.add(std::array{0.0, 0.0}, 0.1);
  observe_disc(model, 560);
  EXPECT_GT(probability(model, {0, 0}), 0.8);
}

}  // namespace
}  // namespace jaywalk::search::learn
