// SPDX-License-Identifier: Apache-2.0
#include "search/failing_stretch.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "search/run_summary.h"
#include "search/suts/lane_keeping.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

const LaneKeeping& model() {
  static const LaneKeeping kModel({}, lane::drive_settings(*lane::find_controller("paper-rate")));
  return kModel;
}

/// A failing test on a road through these points whose worst place is `worst_m` along it.
ExecutedTest failure(const lane::Polyline& points, double worst_m) {
  TestInput input{Form::points, {}};
  for (const Point& point : points) {
    input.values.push_back(point.x_m);
    input.values.push_back(point.y_m);
  }
  ExecutedTest test{.input = std::move(input), .outcome = {}, .fitness = 1, .failed = true};
  test.outcome.measures.resize(model().measures().size());
  test.outcome.measures.at(*find_measure(model().measures(), "worst_arc_m")) = worst_m;
  return test;
}

FailingStretch stretch(const lane::Polyline& points, double worst_m) {
  return failing_stretch(failure(points, worst_m), model()).value();
}

/// A quarter of a circle of 40 m to the left after `straight_m` straight metres, moved and turned.
lane::Polyline bend(double straight_m, double turn_rad = 0, Point start = {50, 10}) {
  lane::Polyline points;
  const auto add = [&](double x, double y) {
    points.push_back({start.x_m + x * std::cos(turn_rad) - y * std::sin(turn_rad),
                      start.y_m + x * std::sin(turn_rad) + y * std::cos(turn_rad)});
  };
  for (double y = 0; y < straight_m; y += 10) add(0, y);
  for (int i = 0; i <= 6; ++i) {
    const double angle = i * std::numbers::pi / 12;
    add(40 * std::cos(angle) - 40, straight_m + 40 * std::sin(angle));
  }
  return points;
}

TEST(FailingStretch, EndsTenMetresAfterTheWorstPlaceWhichIsItsOrigin) {
  const FailingStretch straight = stretch({{100, 10}, {100, 60}, {100, 110}, {100, 180}}, 60);
  ASSERT_EQ(straight.line.size(), 21U);
  EXPECT_NEAR(straight.line.front().x_m, -40, 1e-6);
  EXPECT_NEAR(straight.line[16].x_m, 0, 1e-9);
  EXPECT_NEAR(straight.line.back().x_m, 10, 1e-6);
  for (const Point& point : straight.line) EXPECT_NEAR(point.y_m, 0, 1e-6);
}

TEST(FailingStretch, GoesStraightOnBeyondTheRoad) {
  const FailingStretch near_start = stretch({{100, 10}, {100, 60}, {100, 110}, {100, 180}}, 5);
  EXPECT_NEAR(near_start.line.front().x_m, -40, 1e-6);
  EXPECT_LT(near_start.pieces.size(), 40U) << "the pieces are the road's own";
}

TEST(FailingStretch, BendsToTheLeftWithTheRoad) {
  const FailingStretch in_bend = stretch(bend(60), 90);  // 30 m into the bend
  EXPECT_NEAR(in_bend.line.back().y_m, 40 * (1 - std::cos(0.25)), 0.1);
  // It came from the straight to the left behind, as the road turned by 0.75 rad.
  EXPECT_NEAR(in_bend.line.front().y_m, 40 * (1 - std::cos(0.75)) + 10 * std::sin(0.75), 0.3);
}

TEST(FailingStretch, IsTheSameWhereverTheRoadLiesAndWhatComesBefore) {
  const FailingStretch one = stretch(bend(60), 80);
  EXPECT_LT(separation_m(one, stretch(bend(60, 0.7, {120, 40}), 80)), 0.05);
  EXPECT_LT(separation_m(one, stretch(bend(100), 120)), 0.2) << "40 m of it are before";
  EXPECT_GT(separation_m(one, stretch(bend(60), 90)), 2) << "elsewhere in the bend";
}

TEST(FailingStretch, CopiesAreCountedOnce) {
  const std::vector<FailingStretch> all = {stretch(bend(60), 80), stretch(bend(60, 1), 80),
                                           stretch(bend(60), 100), stretch(bend(60, 2), 80)};
  EXPECT_EQ(distinct(all, 1), 2U);
  EXPECT_EQ(distinct(all, 100), 1U);
  EXPECT_EQ(distinct(all, 0), 4U);
  EXPECT_DOUBLE_EQ(twin_share(all, 1), 0.75);
  EXPECT_DOUBLE_EQ(twin_share(std::span(all).first(1), 1), 0);
}

// Replacing (10 degrees, 1 m) by (11 degrees, 1 m) costs half of 1 / (1 + 1).
TEST(EditDistance, WeighsTurnsAndLengths) {
  const std::vector<RoadPiece> a = {{0, 1}, {10, 1}, {0, 1}};
  EXPECT_DOUBLE_EQ(edit_distance(a, a), 0);
  EXPECT_DOUBLE_EQ(edit_distance(a, std::vector<RoadPiece>{{0.2, 1.1}, {10, 1}, {0, 1}}), 0);
  EXPECT_DOUBLE_EQ(edit_distance(a, std::vector<RoadPiece>{{0, 1}, {11, 1}, {0, 1}}), 0.25);
  EXPECT_DOUBLE_EQ(edit_distance(a, std::vector<RoadPiece>{{0, 1}, {0, 1}}), 1);
  EXPECT_DOUBLE_EQ(edit_distance(a, {}), 3);
}

TEST(Sparseness, IsTheMeanOfTheLargestDistances) {
  const auto of = [](std::vector<RoadPiece> pieces) {
    return FailingStretch{.line = {}, .pieces = std::move(pieces)};
  };
  // Distances 1 (first, second), 3 (first, third), 2 (second, third).
  const std::vector<FailingStretch> all = {of({}), of({{0, 1}}), of({{0, 1}, {0, 1}, {0, 1}})};
  EXPECT_DOUBLE_EQ(sparseness(all), (3 + 2 + 3) / 3.0);
  EXPECT_DOUBLE_EQ(sparseness(std::span(all).first(1)), 0);
}

TEST(RunSummary, TellsCopiesFromDistinctFailures) {
  SearchRun run;
  for (const double turn : {0.0, 0.5, 1.0}) {
    run.tests.push_back({.test = failure(bend(60, turn, {100, 40}), 80)});
  }
  run.tests.push_back({.test = failure(bend(60), 100)});
  const RunSummary summary = summarise(run, model());
  EXPECT_DOUBLE_EQ(summary.failures, 4);
  EXPECT_DOUBLE_EQ(summary.distinct_1m, 2);
  EXPECT_DOUBLE_EQ(summary.twins_pct, 75);
  EXPECT_GT(summary.sparseness, 0);
  EXPECT_TRUE(std::isnan(summarise(run, CornerSut()).distinct_1m)) << "it has no roads";
}

}  // namespace
}  // namespace jaywalk::search
