// SPDX-License-Identifier: Apache-2.0
#include "search/generators/sites.h"

#include <cmath>

#include <gtest/gtest.h>

#include "search/suts/road_space.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

Site sequence(std::vector<double> values, double place) {
  return {{Form::sequence, std::move(values)}, place};
}

lane::Polyline shape(const Site& site, double shift_m = 0) {
  const RoadSpace space({});
  return SiteView(space).shape(site, space.as_points(site.input), shift_m);
}

TEST(SiteView, SeesAStraightRoadAsAStraightLine) {
  const lane::Polyline line = shape(sequence(std::vector<double>(12, 0), 6.5));
  ASSERT_EQ(line.size(), 11U);
  EXPECT_NEAR(line.front().x_m, -40, 1e-9);
  EXPECT_NEAR(line.back().x_m, 10, 1e-9);
  for (const Point& point : line) EXPECT_NEAR(point.y_m, 0, 1e-9);
}

// Wherever on its road, and whatever comes before, a place looks the same.
TEST(SiteView, SeesTheSameShapeAnywhere) {
  const std::vector<double> bend{0, 0, 0, 0, 0.3, 0.6, 0.9, 0.5, 0, 0};
  std::vector<double> later{0.8, 0.4, -0.2};
  later.insert(later.end(), bend.begin(), bend.end());
  const lane::Polyline one = shape(sequence(bend, 6.2));
  const lane::Polyline other = shape(sequence(later, 9.2));
  for (std::size_t i = 0; i < one.size(); ++i) {
    // The first point of `bend` is where its road begins; what came before is new.
    if (i < 2) continue;
    EXPECT_NEAR(lane::distance(one[i], other[i]), 0, 1e-6) << i;
  }
  EXPECT_GT(lane::distance(shape(sequence(bend, 6.2), 5)[0], one[0]), 1);
}

TEST(SiteView, GivesAsManyFeaturesAsLengths) {
  const RoadSpace roads({});
  const Site site = sequence({0.1, 0.2, 0.3, 0.4}, 2.9);
  const SiteView view(roads);
  const std::vector<double> features = view.features(site);
  ASSERT_EQ(features.size(), view.lengths().size());
  // The value at the place, those around it, none before the beginning, and both ends.
  EXPECT_EQ(features[8], 0.3);
  EXPECT_EQ(features[9], 0.4);
  EXPECT_EQ(features[7], 0.2);
  EXPECT_EQ(features[5], 0);
  EXPECT_EQ(features[10], 1);
  EXPECT_EQ(features[11], 0.5);
  EXPECT_DOUBLE_EQ(view.surroundings_m(site), 29);
  EXPECT_DOUBLE_EQ(view.surroundings_m(sequence(std::vector<double>(6, 0), 2.9)), 29 + 11);

  const Square square;
  const SiteView flat(square);
  EXPECT_EQ(flat.features({{Form::vector, {0.3, 0.7}}, 0}), (std::vector<double>{0.3, 0.7}));
  EXPECT_EQ(flat.lengths().size(), 2U);
}

TEST(KnownFailures, AreNewOnceAndThenCopies) {
  KnownFailures known(2);
  const lane::Polyline line{{0, 0}, {5, 0}};
  EXPECT_EQ(known.novelty(line), 1);
  known.add(line, 60);
  EXPECT_EQ(known.novelty({{0, 0}, {5, 0.4}}), 0);
  EXPECT_EQ(known.novelty({{0, 0}, {5, 3}}), 1);
  const double between = known.novelty({{0, 0}, {5, 1.3}});
  EXPECT_GT(between, 0);
  EXPECT_LT(between, 1);
  EXPECT_EQ(known.surroundings_novelty_m(60), 0);
  EXPECT_EQ(known.surroundings_novelty_m(54), 6);
  EXPECT_EQ(known.surroundings_novelty_m(30), KnownFailures::kMostDifference_m);
}

}  // namespace
}  // namespace jaywalk::search
