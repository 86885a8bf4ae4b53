// SPDX-License-Identifier: Apache-2.0
#include "search/evolve/evolution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "search/suts/road_space.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

TEST(Genome, IsARoadOfAsManyPointsOrAVector) {
  const RoadSpace roads({});
  const Genome road(roads, 17);
  EXPECT_EQ(road.size(), 17U);
  Random random(1);
  const TestInput input = road.express(road.draw(random));
  EXPECT_EQ(input.form, Form::sequence);
  EXPECT_EQ(roads.road_points(input).size(), 17U);

  const Square square;
  const Genome vector(square, 17);
  EXPECT_EQ(vector.size(), 2U);
  EXPECT_EQ(vector.express({3, -0.5}), (TestInput{Form::vector, {1, -0.5}}));
}

TEST(Operators, CrossAtOnePointExchangesBeginnings) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    Genes a{1, 1, 1, 1};
    Genes b{2, 2, 2, 2};
    cross_at_one_point(a, b, random);
    EXPECT_EQ(a.front(), 2);
    EXPECT_EQ(a.back(), 1);
    EXPECT_TRUE(std::ranges::is_sorted(a, std::greater<>{}));
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(a[k] + b[k], 3);
  }
}

// Deb and Agrawal: the mean of the two stays, and children are as far apart as their parents at the
// median.
TEST(Operators, SbxKeepsTheMeanAndTheMedianDistance) {
  Random random(3);
  std::vector<double> distances;
  for (int i = 0; i < 4000; ++i) {
    Genes a{0.4};
    Genes b{-0.2};
    cross_by_sbx(a, b, 3, 100, random);
    EXPECT_NEAR(a[0] + b[0], 0.2, 1e-9);
    const double distance = std::fabs(a[0] - b[0]);
    if (std::fabs(distance - 0.6) > 1e-12) distances.push_back(distance);
  }
  EXPECT_NEAR(static_cast<double>(distances.size()), 2000, 150);
  std::ranges::sort(distances);
  EXPECT_NEAR(distances[distances.size() / 2], 0.6, 0.02);
}

TEST(Operators, PolynomialMutationStaysWithinTheBoundsAndIsCentred) {
  Random random(4);
  double sum = 0;
  int changed = 0;
  for (int i = 0; i < 4000; ++i) {
    Genes genes{0};
    mutate_polynomially(genes, 0.5, 3, 3, random);
    EXPECT_LE(std::fabs(genes[0]), 3);
    sum += genes[0];
    changed += genes[0] != 0 ? 1 : 0;
  }
  EXPECT_NEAR(changed, 2000, 150);
  EXPECT_NEAR(sum / 4000, 0, 0.05);
}

TEST(Operators, MutatorsOfVectorsLeaveTheirPlaces) {
  const Square square;
  const Genome vector(square, 2);
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const Genes mutated = mutated_curvatures({0.1, -0.9}, vector, random);
    ASSERT_EQ(mutated.size(), 2U);
    EXPECT_FALSE(mutated[0] == -0.9 && mutated[1] == 0.1) << "reversed";
  }
}

// The sum of ten numbers from -1 to 1 is largest at 10.
TEST(Evolution, FindsTheOptimumOfASum) {
  Random random(6);
  Evolution evolution(
      {20, 20},
      {.draw =
           [&] {
             Genes genes(10);
             for (double& each : genes) each = random.uniform(-1, 1);
             return genes;
           },
       .cross = [&](Genes& a, Genes& b) { cross_by_sbx(a, b, 3, 1, random); },
       .mutate = [&](Genes& genes) { mutate_polynomially(genes, 0.1, 3, 1, random); },
       .same = [](const Genes& a, const Genes& b) { return a == b; }},
      random);
  double first = -10;
  double last = -10;
  for (int i = 0; i < 2000; ++i) {
    const Genes& genes = evolution.next();
    const double sum = std::accumulate(genes.begin(), genes.end(), 0.0);
    if (i < 20) first = std::max(first, sum);
    last = std::max(last, sum);
    evolution.judge(sum);
  }
  EXPECT_LT(first, 6);
  EXPECT_GT(last, 9.8);
  const std::vector<Genes> fittest = evolution.fittest();
  EXPECT_EQ(fittest.size(), 20U);
  EXPECT_GT(std::accumulate(fittest[0].begin(), fittest[0].end(), 0.0), 9.8);
}

}  // namespace
}  // namespace jaywalk::search
