// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/export/exports.h"
#include "search/report/search_page.h"
#include "search/search_experiment.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

using testing::HasSubstr;

const lane::Polyline kPoints{{100, 10}, {100, 30}, {97, 50}, {100, 70}, {112, 88}};

/// One <geometry> of an OpenDRIVE file.
struct Geometry {
  double s, x, y, heading, length;
  double bu, cu, du, bv, cv, dv;

  /// Where it ends.
  [[nodiscard]] Point end() const {
    const double u = bu + cu + du;
    const double v = bv + cv + dv;
    return {x + u * std::cos(heading) - v * std::sin(heading),
            y + u * std::sin(heading) + v * std::cos(heading)};
  }
};

std::vector<Geometry> geometries(const std::string& xml) {
  std::vector<Geometry> all;
  for (std::size_t at = 0; (at = xml.find("<geometry", at)) != std::string::npos; ++at) {
    Geometry g{};
    const int read = std::sscanf(
        xml.c_str() + at,
        "<geometry s=\"%lf\" x=\"%lf\" y=\"%lf\" hdg=\"%lf\" length=\"%lf\"> <paramPoly3 "
        "pRange=\"normalized\" aU=\"0\" bU=\"%lf\" cU=\"%lf\" dU=\"%lf\" aV=\"0\" bV=\"%lf\" "
        "cV=\"%lf\" dV=\"%lf\"/>",
        &g.s, &g.x, &g.y, &g.heading, &g.length, &g.bu, &g.cu, &g.du, &g.bv, &g.cv, &g.dv);
    EXPECT_EQ(read, 11);
    all.push_back(g);
  }
  return all;
}

TEST(OpenDrive, HasTheSplineItself) {
  const std::vector<Geometry> all = geometries(to_opendrive(kPoints, "road"));
  ASSERT_EQ(all.size(), kPoints.size() - 1);
  double s = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].x, kPoints[i].x_m, 1e-6);
    EXPECT_NEAR(all[i].y, kPoints[i].y_m, 1e-6);
    EXPECT_NEAR(all[i].end().x_m, kPoints[i + 1].x_m, 1e-6);
    EXPECT_NEAR(all[i].end().y_m, kPoints[i + 1].y_m, 1e-6);
    EXPECT_NEAR(all[i].bv, 0, 1e-6);  // it begins along its heading
    EXPECT_NEAR(all[i].s, s, 1e-5);
    EXPECT_GE(all[i].length, lane::distance(kPoints[i], kPoints[i + 1]) - 1e-6);
    s += all[i].length;
  }
  EXPECT_NEAR(s, lane::length(*lane::interpolate(kPoints)), 0.02);
}

TEST(OpenDrive, GoesOnSmoothlyFromPieceToPiece) {
  const std::vector<Geometry> all = geometries(to_opendrive(kPoints, "road"));
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const double u = all[i].bu + 2 * all[i].cu + 3 * all[i].du;
    const double v = all[i].bv + 2 * all[i].cv + 3 * all[i].dv;
    EXPECT_NEAR(std::remainder(all[i].heading + std::atan2(v, u) - all[i + 1].heading, 2 * M_PI), 0,
                1e-6);
  }
}

TEST(OpenScenario, StartsTheCarInTheRightLaneOfTheRoadFile) {
  const std::string xml = to_openscenario(kPoints, "road.xodr", {.speed_limit_mps = 20});
  EXPECT_THAT(xml, HasSubstr("<LogicFile filepath=\"road.xodr\"/>"));
  EXPECT_THAT(xml, HasSubstr("laneId=\"-1\" offset=\"0\" s=\"2.5\""));
  EXPECT_THAT(xml, HasSubstr("revMajor=\"1\" revMinor=\"0\""));
}

TEST(OpenScenario, DrivesTheCarUpToTheSpeedLimit) {
  const std::string xml = to_openscenario(kPoints, "road.xodr", {.speed_limit_mps = 20});
  EXPECT_THAT(xml, HasSubstr("name=\"SpeedLimit\" parameterType=\"double\" value=\"20\""));
  EXPECT_THAT(xml, HasSubstr("<AbsoluteTargetSpeed value=\"$SpeedLimit\"/>"));
  EXPECT_LT(xml.find("<Story "), xml.find("<StopTrigger>"));
}

TEST(CompetitionJson, HasPointsVerdictAndOutcome) {
  TestRow row;
  row.test = {.input = {}, .outcome = {.measures = {1}}, .fitness = 1, .failed = true};
  const std::string json = to_competition_json(row, kPoints, 12);
  EXPECT_THAT(json, HasSubstr("\"id\": 12"));
  EXPECT_THAT(json, HasSubstr("\"is_valid\": true"));
  EXPECT_THAT(json, HasSubstr("\"test_outcome\": \"FAIL\""));
  EXPECT_THAT(json, HasSubstr("\"interpolated_points\""));
}

/// The page of a search that is not about roads, with that name.
std::string small_page(const std::string& name) {
  SearchExperiment experiment;
  experiment.name = name;
  experiment.plan = corner_plan("graft", 60);
  experiment.plan.repetitions = 2;
  const SearchResults results = run_searches(experiment.plan, nullptr);
  return to_html(experiment, group(experiment, results));
}

TEST(Page, HasTheFiguresOfASearchThatIsNotAboutRoads) {
  const std::string page = small_page("<corner>");
  EXPECT_THAT(page, HasSubstr("&lt;corner&gt;"));
  EXPECT_THAT(page, HasSubstr("failing tests"));
  EXPECT_THAT(page, testing::Not(HasSubstr("nan")));
  EXPECT_THAT(page, testing::Not(HasSubstr("<corner>")));
  EXPECT_THAT(page, testing::Not(HasSubstr("Failing roads"))) << "and nothing of roads";
}

/// The page of a scenario's search before anything has run.
std::string empty_page(const std::string& file, std::vector<std::string> sets = {}) {
  auto experiment = read_search(std::string(JAYWALK_SOURCE_DIR) + "/scenarios/search/" + file,
                                {.sets = std::move(sets), .generators = {}});
  EXPECT_TRUE(experiment.ok()) << experiment.diagnostics().render();
  return to_html(experiment.value(), group(experiment.value(), {}));
}

// Failing from 85 % on at 70 km/h, in half the time or for another measure is another experiment.
TEST(Page, HasThePublishedTableOnlyIfTheSearchIsSetUpAsThePublishedOne) {
  const auto published = HasSubstr("Table 1 of Peltomäki");
  const auto left_out = HasSubstr("Left out: the published results");
  EXPECT_THAT(empty_page("lane-keeping.yaml"), published);
  EXPECT_THAT(empty_page("lane-keeping.yaml", {"repetitions=2", "seed=1"}), published);
  for (const std::string& page :
       {empty_page("lane-keeping-beamng.yaml"),
        empty_page("lane-keeping.yaml", {"sut.speed_limit_kmh=70"}),
        empty_page("lane-keeping.yaml", {"fitness.fails_at=0.85"}),
        empty_page("lane-keeping.yaml", {"budget.virtual_s=3600"}),
        empty_page("lane-keeping.yaml", {"fitness.measure=max_lateral_error_m"})}) {
    EXPECT_THAT(page, testing::Not(published));
    EXPECT_THAT(page, left_out);
  }
  EXPECT_THAT(empty_page("crossing-search.yaml"), testing::Not(left_out)) << "it has no roads";
}

TEST(Page, HasTheLooksOfTheOtherReports) {
  const std::string page = small_page("corner");
  EXPECT_THAT(page, HasSubstr("@media (prefers-color-scheme: dark)"));
  EXPECT_THAT(page, HasSubstr("@media print"));
  EXPECT_THAT(page, HasSubstr("<a href=\"#fitness\">"));
  EXPECT_THAT(page, HasSubstr("<title>graft, 100: ")) << "where the budget is spent";
  EXPECT_THAT(page, HasSubstr("2 repetitions</title>")) << "of the boxes";
}

}  // namespace
}  // namespace jaywalk::search
