// SPDX-License-Identifier: Apache-2.0
#include "env/lane/spline.h"

#include <gtest/gtest.h>

namespace jaywalk::lane {
namespace {

TEST(Spline, GoesThroughItsPointsAtTheirRelativeChordLength) {
  const std::vector<Point> points{{0, 0}, {3, 4}, {3, 9}, {-2, 9}, {-2, 19}};
  const auto spline = Spline::through(points);
  ASSERT_TRUE(spline);
  const double chords[] = {0, 5, 10, 15, 25};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point point = spline->at(chords[i] / 25);
    EXPECT_NEAR(point.x_m, points[i].x_m, 1e-12);
    EXPECT_NEAR(point.y_m, points[i].y_m, 1e-12);
  }
}

// Four points determine one cubic; its third derivative jumps nowhere, so neither does ours.
TEST(Spline, IsTheCubicItselfIfThePointsLieOnOne) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}};
  std::vector<Point> bent = points;
  for (Point& point : bent) point.x_m = 10 * point.x_m;
  const auto spline = Spline::through(bent);
  ASSERT_TRUE(spline);
  for (const Spline::Piece& piece : spline->pieces()) {
    EXPECT_NEAR(piece.c2.x_m, 0, 1e-9);
    EXPECT_NEAR(piece.c3.x_m, 0, 1e-9);
  }
  EXPECT_NEAR(spline->at(0.3).x_m, 12, 1e-12);
}

TEST(Spline, HasNoKnotAtTheSecondAndTheLastButOnePoint) {
  const std::vector<Point> points{{0, 0}, {10, 3}, {17, 11}, {12, 25}, {20, 33}, {35, 30}};
  const auto spline = Spline::through(points);
  ASSERT_TRUE(spline);
  const auto& pieces = spline->pieces();
  ASSERT_EQ(pieces.size(), 5U);
  const auto relative = [](double a, double b) { return std::abs(a - b) / (1 + std::abs(a)); };
  EXPECT_LT(relative(pieces[0].c3.x_m, pieces[1].c3.x_m), 1e-9);
  EXPECT_LT(relative(pieces[3].c3.y_m, pieces[4].c3.y_m), 1e-9);
  EXPECT_GT(relative(pieces[1].c3.x_m, pieces[2].c3.x_m), 1e-3);
}

TEST(Spline, DrawsAParabolaThroughThreePointsAndALineThroughTwo) {
  const auto parabola = Spline::through(std::vector<Point>{{0, 0}, {10, 0}, {10, 10}});
  ASSERT_TRUE(parabola);
  EXPECT_EQ(parabola->pieces().size(), 1U);
  EXPECT_NEAR(parabola->at(0.5).x_m, 10, 1e-12);
  EXPECT_NEAR(parabola->at(0.5).y_m, 0, 1e-12);
  const auto line = Spline::through(std::vector<Point>{{0, 0}, {10, 20}});
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->at(1.1).y_m, 22, 1e-12);
}

TEST(Spline, NeedsTwoPointsThatDiffer) {
  EXPECT_FALSE(Spline::through(std::vector<Point>{{1, 1}}));
  EXPECT_FALSE(Spline::through(std::vector<Point>{{1, 1}, {1, 1}, {2, 2}}));
}

}  // namespace
}  // namespace jaywalk::lane
