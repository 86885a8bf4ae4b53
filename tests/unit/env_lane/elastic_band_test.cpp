// SPDX-License-Identifier: Apache-2.0
#include "env/lane/elastic_band.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "env/lane/path.h"

namespace jaywalk::lane {
namespace {

Polyline straight_line(int metres) {
  Polyline line;
  for (int i = 0; i <= metres; ++i) line.push_back({0, static_cast<double>(i)});
  return line;
}

/// 40 m straight on, a quarter of a circle to the left, 40 m straight on.
Polyline corner(double radius) {
  Polyline line;
  for (int i = 0; i < 40; ++i) line.push_back({0, static_cast<double>(i)});
  const int arcs = static_cast<int>(radius * 1.5707963);
  for (int i = 0; i < arcs; ++i) {
    const double angle = i / radius;
    line.push_back({radius * (std::cos(angle) - 1), 40 + radius * std::sin(angle)});
  }
  for (int i = 0; i <= 40; ++i) line.push_back({-radius - i, 40 + radius});
  return line;
}

/// How far each point of the band is from the line, positive to its left.
std::vector<double> shifts(const Polyline& centre, const BandParameters& parameters = {}) {
  const Path path(centre);
  std::vector<double> result;
  std::size_t near = 0;
  for (const Point& point : elastic_band(centre, parameters)) {
    near = path.nearest(point, near);
    const double heading = path.heading(near);
    result.push_back((point.y_m - path.point(near).y_m) * std::cos(heading) -
                     (point.x_m - path.point(near).x_m) * std::sin(heading));
  }
  return result;
}

TEST(ElasticBand, OfAStraightLineIsThatLine) {
  const Polyline band = elastic_band(straight_line(60), {});
  for (const Point& point : band) EXPECT_NEAR(point.x_m, 0, 1e-9);
  EXPECT_NEAR(band.front().y_m, 0, 1e-9);
  EXPECT_NEAR(band.back().y_m, 60, 1e-9);
}

TEST(ElasticBand, HasAboutAPointEachMetre) {
  const Polyline band = elastic_band(corner(30), {});
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    EXPECT_NEAR(distance(band[i], band[i + 1]), 1, 0.25) << i;
  }
}

TEST(ElasticBand, CutsTheCorner) {
  const std::vector<double> left = shifts(corner(30));
  EXPECT_GT(*std::ranges::max_element(left), 0.3) << "to the inside of a curve to the left";
  EXPECT_LT(length(elastic_band(corner(30), {})), length(corner(30)));
}

TEST(ElasticBand, SwingsOutBeforeTheCorner) {
  const std::vector<double> left = shifts(corner(30));
  EXPECT_LT(*std::ranges::min_element(left), -0.1);
}

TEST(ElasticBand, StaysWithinItsBounds) {
  BandParameters tight;
  tight.most_left_m = 0.3;
  tight.most_right_m = 0.05;
  for (const double shift : shifts(corner(30), tight)) {
    EXPECT_LT(shift, 0.3 + 0.05);
    EXPECT_GT(shift, -0.05 - 0.05);
  }
}

TEST(ElasticBand, BeginsInTheMiddleAndStraightOn) {
  BandParameters parameters;
  parameters.start_m = 20;
  const std::vector<double> left = shifts(corner(30), parameters);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(left[i], 0, 0.005) << i;
}

TEST(ElasticBand, StaysNearerToTheMiddleTheStifferItIs) {
  double last = 10;
  for (const double stiffness : {30.0, 15.0, 8.0, 3.0}) {
    BandParameters parameters;
    parameters.stiffness_m = stiffness;
    parameters.most_left_m = parameters.most_right_m = 10;
    double most = 0;
    for (const double shift : shifts(corner(30), parameters))
      most = std::max(most, std::fabs(shift));
    EXPECT_LT(most, last) << stiffness;
    last = most;
  }
}

TEST(ElasticBand, OfTheMirroredLineIsMirrored) {
  BandParameters parameters;
  parameters.most_left_m = parameters.most_right_m = 1;
  const Polyline line = corner(25);
  Polyline mirrored = line;
  for (Point& point : mirrored) point.x_m = -point.x_m;
  const Polyline band = elastic_band(line, parameters);
  const Polyline other = elastic_band(mirrored, parameters);
  ASSERT_EQ(band.size(), other.size());
  for (std::size_t i = 0; i < band.size(); ++i) {
    EXPECT_NEAR(other[i].x_m, -band[i].x_m, 1e-9);
    EXPECT_NEAR(other[i].y_m, band[i].y_m, 1e-9);
  }
}

TEST(ElasticBand, DoesNotDependOnWhereTheLineLies) {
  const Polyline line = corner(25);
  Polyline moved = line;
  for (Point& point : moved) point = {100 - point.y_m, 50 + point.x_m};
  const Polyline band = elastic_band(line, {});
  const Polyline other = elastic_band(moved, {});
  ASSERT_EQ(band.size(), other.size());
  for (std::size_t i = 0; i < band.size(); ++i) {
    EXPECT_NEAR(other[i].x_m, 100 - band[i].y_m, 1e-6);
    EXPECT_NEAR(other[i].y_m, 50 + band[i].x_m, 1e-6);
  }
}

TEST(ElasticBand, WithoutSweepsIsTheMiddle) {
  BandParameters none;
  none.sweeps = 0;
  for (const double shift : shifts(corner(30), none)) EXPECT_NEAR(shift, 0, 0.05);
}

TEST(ElasticBand, BendsLessWithEachSweep) {
  double last = 1e9;
  for (const int sweeps : {0, 1, 4, 5, 20, 150}) {
    BandParameters parameters;
    parameters.sweeps = sweeps;
    const Path band(elastic_band(corner(30), parameters));
    double bending = 0;
    for (std::size_t i = 0; i < band.size(); ++i) bending += band.curvature(i) * band.curvature(i);
    EXPECT_LT(bending, last) << sweeps;
    last = bending;
  }
}

/// How far two bands of as many points are apart where they are furthest.
double furthest(const Polyline& a, const Polyline& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
  return most;
}

TEST(ElasticBand, ComesToRestAfterManySweeps) {
  // With few nodes it takes fewer.
  BandParameters many{.node_m = 6, .sweeps = 2000};
  const Polyline rest = elastic_band(corner(30), many);
  many.sweeps = 4000;
  EXPECT_LT(furthest(elastic_band(corner(30), many), rest), 1e-3);
}

TEST(ElasticBand, IsNotAtRestAfterTheSweepsThatTheCarsAreCalibratedWith) {
  BandParameters more;
  EXPECT_EQ(more.sweeps, 150);
  const Polyline calibrated = elastic_band(corner(30), more);
  more.sweeps = 4000;
  const double apart = furthest(calibrated, elastic_band(corner(30), more));
  EXPECT_GT(apart, 0.3);
  EXPECT_LT(apart, 1.5) << "about a metre, as its header says";
}

TEST(ElasticBand, OfAShortLineHasFiveNodes) {
  const Polyline band = elastic_band({{0, 0}, {0, 2}}, {});
  EXPECT_EQ(band.size(), 5U);
  EXPECT_DOUBLE_EQ(band[1].y_m, 0.5);
}

}  // namespace
}  // namespace jaywalk::lane
