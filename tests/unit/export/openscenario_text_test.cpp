// SPDX-License-Identifier: Apache-2.0
#include "experiment/export/openscenario/openscenario_text.h"

#include <map>
#include <numbers>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/export/crossings.h"
#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A recording with its world; what is written of both.
class ScenarioTextTest : public testing::Test {
 protected:
  ScenarioText text(ScenarioDialect dialect = ScenarioDialect::standard) {
    plan_ = plan_roads(world_);
    return {recording_, world_, plan_, dialect};
  }
  static std::size_t occurrences(const std::string& text, std::string_view of) {
    std::size_t count = 0;
    for (std::size_t at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) {
      ++count;
    }
    return count;
  }
  std::map<std::string, std::string> values(const BatchShape& shape) {
    const ParameterValues list = text().values(reactive_courses(recording_), shape);
    return {list.begin(), list.end()};
  }

  // The AV at 10 m/s; a pedestrian crosses far ahead of it.
  Recording recording_ =
      drive(1, {steps({0, 0}, {0, 10}, 4), {{6, 60}, {6, 61}, {5, 61}, {4, 61}}});
  CrossingParameters world_;
  RoadPlan plan_;
};

TEST_F(ScenarioTextTest, PutsTheReferencePointOfAVehicleOnItsRearAxle) {
  const std::string document = text().trajectories("t", timed_courses(recording_));
  // 0.3 of 4 m behind its middle.
  EXPECT_THAT(document, HasSubstr("y=\"-1.2000\" z=\"0\" h=\"1.570796\""));
  EXPECT_THAT(document, HasSubstr("<Center x=\"1.2000\" y=\"0\" z=\"0.750\"/>"));
}

TEST_F(ScenarioTextTest, PutsTheReferencePointOfAPedestrianInItsMiddle) {
  const std::string document = text().trajectories("t", timed_courses(recording_));
  EXPECT_THAT(document, HasSubstr("<WorldPosition x=\"6.0000\" y=\"60.0000\""));
  EXPECT_THAT(document, HasSubstr("<Center x=\"0.0000\" y=\"0\" z=\"0.900\"/>"));
}

TEST_F(ScenarioTextTest, EscapesTheNamesOfActors) {
  Recording named(
      1, {{"av", ActorKind::vehicle, 4, 2}, {"p<1> & \"2\"", ActorKind::pedestrian, 0.5, 0.5}});
  for (std::size_t tick = 0; tick < recording_.scenes(); ++tick) named.add(recording_.scene(tick));
  recording_ = named;
  for (const std::string& document : {text().trajectories("t", timed_courses(recording_)),
                                      text().reactive("t", reactive_courses(recording_))}) {
    EXPECT_THAT(document, HasSubstr("entityRef=\"p&lt;1&gt; &amp; &quot;2&quot;\""));
    EXPECT_THAT(document, Not(HasSubstr("p<1>")));
  }
}

TEST_F(ScenarioTextTest, GivesNothingNoSign) {
  recording_ = drive(1, {steps({-1e-9, 0}, {0, 10}, 4), steps({-1e-9, 60}, {0, 1}, 4)});
  const std::string document = text().trajectories("t", timed_courses(recording_));
  EXPECT_THAT(document, HasSubstr("x=\"0.0000\" y=\"60.0000\""));
  EXPECT_THAT(document, Not(HasSubstr("-0.0000")));
}

TEST_F(ScenarioTextTest, OfATimetableHasAVertexForEachWaypointInAbsoluteTime) {
  const Courses courses = timed_courses(recording_);
  const std::string document = text().trajectories("t", courses);
  EXPECT_EQ(occurrences(document, "<Vertex "),
            courses.courses[0].points.size() + courses.courses[1].points.size());
  EXPECT_EQ(occurrences(document, "domainAbsoluteRelative=\"absolute\""), 2U);
  EXPECT_THAT(document, Not(HasSubstr("<CollisionCondition>")));
}

TEST_F(ScenarioTextTest, OfAReactiveTestBeginsWalksByTheTimeToCollision) {
  const std::string document = text().reactive("t", reactive_courses(recording_));
  EXPECT_THAT(document, HasSubstr("<Condition name=\"the AV comes to p1\""));
  EXPECT_EQ(occurrences(document, "<TimeToCollisionCondition "), 1U);
  EXPECT_EQ(occurrences(document, "domainAbsoluteRelative=\"relative\""), 1U)
      << "the AV keeps to a timetable";
  EXPECT_THAT(document, HasSubstr("<CollisionCondition><EntityRef entityRef=\"p1\"/>"));
}

TEST_F(ScenarioTextTest, StartsEachAtTheSpeedOfItsFirstStretch) {
  const std::string document = text().reactive("t", reactive_courses(recording_));
  EXPECT_THAT(document, HasSubstr("<AbsoluteTargetSpeed value=\"10.0000\"/>"));
  EXPECT_THAT(document, HasSubstr("<AbsoluteTargetSpeed value=\"0.0000\"/>"))
      << "who waits for the AV stands";
}

TEST_F(ScenarioTextTest, EndsWhenTheTestDid) {
  EXPECT_THAT(text().trajectories("t", timed_courses(recording_)),
              HasSubstr("<Condition name=\"the test is over\" delay=\"0\" conditionEdge=\"none\">"
                        "<ByValueCondition><SimulationTimeCondition value=\"3.0000\""));
}

TEST_F(ScenarioTextTest, OfCarlaHasItsNamesAndItsCriterion) {
  const std::string document =
      text(ScenarioDialect::carla).trajectories("t", timed_courses(recording_));
  EXPECT_THAT(document, HasSubstr("<ScenarioObject name=\"hero\">"));
  EXPECT_THAT(document, HasSubstr("value=\"ego_vehicle\""));
  EXPECT_THAT(document, HasSubstr("walker.pedestrian.0001"));
  EXPECT_THAT(document, HasSubstr("criteria_CollisionTest"));
  const std::string standard = text().trajectories("t", timed_courses(recording_));
  EXPECT_THAT(standard, HasSubstr("<ScenarioObject name=\"av\">"));
  EXPECT_THAT(standard, Not(HasSubstr("criteria_CollisionTest")));
}

TEST_F(ScenarioTextTest, MakesObstaclesALittleSmallerThanTheirCells) {
  world_.obstacles = {{{0, 1}, {4, 7}}};
  const std::string document = text().trajectories("t", timed_courses(recording_));
  EXPECT_THAT(document, HasSubstr("<ScenarioObject name=\"obstacle1\">"));
  EXPECT_THAT(document, HasSubstr("width=\"2.9800\" length=\"5.9800\""));
  EXPECT_THAT(document, HasSubstr("<WorldPosition x=\"1.5000\" y=\"9.0000\""));
}

TEST_F(ScenarioTextTest, GivesEachKindOfActorItsKindOfObject) {
  recording_ = Recording(1, {{"av", ActorKind::vehicle, 4, 2},
                             {"walker", ActorKind::pedestrian, 0.5, 0.5},
                             {"rider", ActorKind::cyclist, 1.8, 0.6},
                             {"lamp", ActorKind::signal, 0, 0}});
  for (int i = 0; i < 2; ++i) {
    recording_.add(Scene{{0, 10.0 * i, 10, 1.57}, {9, 5, 0, 0}, {9, 9, 0, 0}, {0, 0, 0, 0}});
  }
  const std::string document = text().trajectories("t", timed_courses(recording_));
  EXPECT_THAT(document, HasSubstr("<ScenarioObject name=\"walker\"><Pedestrian "));
  EXPECT_THAT(document, HasSubstr("<ScenarioObject name=\"rider\"><Vehicle name=\"bicycle\" "
                                  "vehicleCategory=\"bicycle\">"));
  EXPECT_THAT(document, HasSubstr("<ScenarioObject name=\"av\"><Vehicle name=\"car\""));
  EXPECT_THAT(document, Not(HasSubstr("lamp"))) << "a signal is part of the road";
}

TEST_F(ScenarioTextTest, OfSignalsHasThePhasesThatWereSeen) {
  world_ = crosswalk_world(CrosswalkKind::signalled, {20, 22});
  recording_ =
      Recording(0.5, {{"av", ActorKind::vehicle, 4, 2}, {"signal1", ActorKind::signal, 0, 0}});
  recording_.add(RecordedEvent{.tick = 3, .actor = 1, .kind = "signal", .text = "amber"});
  recording_.add(RecordedEvent{.tick = 5, .actor = 1, .kind = "signal", .text = "red"});
  const std::string phases = text().signals(4);
  EXPECT_THAT(phases, HasSubstr("<Phase name=\"green\" duration=\"1.0000\">"));
  EXPECT_THAT(phases, HasSubstr("<Phase name=\"amber\" duration=\"1.0000\">"));
  EXPECT_THAT(phases, HasSubstr("<Phase name=\"red\" duration=\"2.5000\">")) << "a tick longer";
  EXPECT_THAT(phases, HasSubstr("trafficSignalId=\"1\" state=\"on;off;off\""));
  EXPECT_THAT(phases, HasSubstr("trafficSignalId=\"2\" state=\"off;off;on\""));
}

TEST_F(ScenarioTextTest, HasNoPhaseWithoutDuration) {
  world_ = crosswalk_world(CrosswalkKind::signalled, {20, 22});
  recording_ =
      Recording(1, {{"av", ActorKind::vehicle, 4, 2}, {"signal1", ActorKind::signal, 0, 0}});
  recording_.add(RecordedEvent{.tick = 1, .actor = 1, .kind = "signal", .text = "red"});
  EXPECT_THAT(text().signals(4), Not(HasSubstr("\"green\"")));
}

TEST_F(ScenarioTextTest, OfAWorldWithoutSignalsSaysNothingOfThem) {
  EXPECT_EQ(text().signals(4), "");
}

TEST_F(ScenarioTextTest, OfABatchGivesAValueForEachOfItsParameters) {
  const BatchShape shape{3, 5};
  const ParameterValues list = text().values(reactive_courses(recording_), shape);
  const std::string document = text().batch("b", shape, list);
  EXPECT_EQ(occurrences(document, "<ParameterDeclaration "), list.size());
  for (const auto& [name, value] : list) {
    EXPECT_THAT(document, HasSubstr(fmt::format("<ParameterDeclaration name=\"{}\" "
                                                "parameterType=\"double\" value=\"{}\"/>",
                                                name, value)));
    EXPECT_THAT(document, HasSubstr("\"$" + name + "\"")) << "and uses it";
  }
}

TEST_F(ScenarioTextTest, OfABatchLetsShorterCoursesStandAtTheirEnd) {
  auto of = values({2, 4});
  EXPECT_EQ(of["p1_X3"], of["p1_X2"]);
  EXPECT_EQ(of["p1_Y3"], of["p1_Y2"]);
  EXPECT_LT(std::stod(of["p1_T2"]), std::stod(of["p1_T3"])) << "times have to rise";
}

TEST_F(ScenarioTextTest, OfABatchWaitsForEverForTheConditionThatDoesNotCount) {
  auto of = values({2, 4});
  EXPECT_EQ(of["p1_Time"], "1000000.0000") << "the time to collision counts";
  EXPECT_GT(std::stod(of["p1_Ttc"]), 0);
  EXPECT_EQ(of["av_Time"], "-0.0010") << "the AV sets out at once";
  EXPECT_EQ(of.count("av_Ttc"), 0U);
}

TEST_F(ScenarioTextTest, OfABatchTakesTheClockWhereTheAvHasPassed) {
  recording_ = drive(1, {steps({0, 0}, {0, 10}, 4), {{6, -20}, {6, -20}, {5, -20}, {4, -20}}});
  auto of = values({2, 4});
  EXPECT_EQ(of["p1_Time"], "1.0000");
  EXPECT_EQ(of["p1_Ttc"], "-1.0000") << "which no time to collision is below";
}

}  // namespace
}  // namespace jaywalk
