// SPDX-License-Identifier: Apache-2.0
// The test bench beyond the paper's small world (case study, section 7): each scenario that shows a
// feature is run, and the feature has an effect.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "env/crossing/world.h"
#include "experiment/judge/situations/situations.h"
#include "scenarios.h"

namespace jaywalk {
namespace {

using testing_scenario::run;
using testing_scenario::scenario;
using testing_scenario::Seen;

int successes(const PreparedScenario& prepared, const std::string& name, std::uint32_t agents,
              std::uint64_t tests, std::uint64_t seed = 0) {
  int count = 0;
  for (std::uint64_t test = 0; test < tests; ++test) {
    count += run(prepared, name, agents, test, seed).outcome.success ? 1 : 0;
  }
  return count;
}

/// The slowest that the AV went.
double slowest(const Recording& recording) {
  double least = 1e9;
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    least = std::min(least, recording.scene(tick)[0].speed_mps);
  }
  return least;
}

TEST(ABrakingAv, CollidesLessOftenThanOneThatDoesNotBrake) {  // F6
  const auto collisions = [](const std::string& model) {
    const auto prepared = scenario("braking", {"world.av.model=" + model});
    std::size_t count = 0;
    for (std::uint64_t test = 0; test < 40; ++test) {
      count += run(*prepared, "proximity", 3, test).outcome.collisions.size();
    }
    return count;
  };
  const std::size_t constant = collisions("constant");
  EXPECT_GT(constant, 0U);
  for (const std::string model : {"braking", "careful-competent", "aeb", "idm"}) {
    EXPECT_LT(collisions(model), constant) << model;
  }
}

TEST(ABrakingAv, IsMetMoreOftenByWhoRecalculates) {  // F6
  const auto prepared = scenario("braking");
  for (const std::uint64_t seed : {0U, 1U}) {
    for (const std::uint32_t agents : {1U, 3U}) {
      EXPECT_GE(successes(*prepared, "recalculating", agents, 60, seed),
                successes(*prepared, "intersect", agents, 60, seed) + 12)
          << agents << " agents, seed " << seed;
    }
  }
}

TEST(ABrakingAv, DoesNotWaitForWhoWaitsForIt) {  // F6
  const auto prepared = scenario("braking");
  const double limit_s = crossing_parameters(*prepared->scenario().world).time_limit_s;
  bool slowed = false;
  for (const std::string name : {"proximity", "intersect", "recalculating"}) {
    for (std::uint64_t test = 0; test < 40; ++test) {
      const Recording recording = run(*prepared, name, 3, test).recording;
      const double seconds = static_cast<double>(recording.scenes() - 1) * recording.tick_s();
      EXPECT_LT(seconds, limit_s) << name << ", test " << test;
      slowed = slowed || (name == "recalculating" && slowest(recording) < 1);
    }
  }
  EXPECT_TRUE(slowed);
}

TEST(AnExternalController, DrivesTheAv) {  // F9
  const auto prepared = scenario("external");
  bool slowed = false;
  for (std::uint64_t test = 0; test < 5; ++test) {
    slowed = slowed || slowest(run(*prepared, "proximity", 3, test).recording) < 8;
  }
  EXPECT_TRUE(slowed);
}

TEST(AnExternalController, ThatFailsEndsTheTestWithTheReason) {  // F9
  const auto fails = [](const std::string& script) {
    const auto prepared = scenario(
        "external", {"world.av.process=test", "world.av.command=[sh, -c, '" + script + "']"});
    return run_test(*prepared, {.agents = 1}).message;
  };
  EXPECT_EQ(fails("read line; exit 4"),
            "the controller 'sh': it ended with exit code 4 before it answered");
  EXPECT_EQ(fails("read line; echo hello"),
            "the controller 'sh': line 1 of its output, 'hello': expected a JSON object");
  EXPECT_EQ(
      fails("read line; echo {}"),
      "the controller 'sh': line 1 of its output, '{}': expected {\"acceleration\": <m/s^2>}");
  EXPECT_EQ(
      fails(R"(while read line; do printf "{\"acceleration\": 0}\n{\"acceleration\": 0}\n"; done)"),
      "the controller 'sh': line 1 of its output, '{\"acceleration\": 0}': one line is an answer, "
      "but it also wrote '{\"acceleration\": 0}'");
  EXPECT_EQ(fails(R"(while read line; do echo "{\"acceleration\": 1e308}"; done)"),
            "the controller 'sh': line 1 of its output, '{\"acceleration\": 1e308}': no vehicle "
            "reaches 1e+308 m/s^2, let alone more than 1000");
  EXPECT_EQ(
      fails(R"(while read line; do echo "{\"acceleration\": -inf}"; done)"),
      "the controller 'sh': line 1 of its output, '{\"acceleration\": -inf}': expected a JSON "
      "object");
  EXPECT_EQ(fails(R"(while read line; do echo "{\"step\": 3, \"acceleration\": 0}"; done)"),
            "the controller 'sh': line 1 of its output, '{\"step\": 3, \"acceleration\": 0}': it "
            "answers step 3, expected 0");
}

TEST(PerceptionByFeatures, DoesNotGrowWithTheMapOrTheCrowd) {  // F3
  const auto percepts = [](const std::vector<std::string>& sets, std::size_t pedestrians) {
    const auto prepared = scenario("features", sets);
    const std::vector<Position> start(pedestrians, {2, 30});
    const auto world = prepared->world(0).make({.cells = start});
    Percepts seen;
    world->perceive(AgentId{0}, seen);
    return seen.size();
  };
  EXPECT_EQ(percepts({}, 200), percepts({"world.length=100", "world.road_end=99"}, 1));
}

TEST(PerceptionByFeatures, LeadsManyPedestriansAcrossALargeMap) {  // F3
  const Seen seen = run(*scenario("features"), "by_features", 200, 0);
  EXPECT_TRUE(seen.outcome.success);
}

TEST(Personality, DecidesHowOftenTheAvIsExercised) {  // F4
  const auto prepared = scenario("personality");
  const int timid = successes(*prepared, "timid", 1, 200);
  const int bold = successes(*prepared, "bold", 1, 200);
  EXPECT_EQ(timid, 0) << "it waits until the AV has passed";
  EXPECT_GT(bold, 20);
  EXPECT_NE(successes(*prepared, "cautious", 1, 200), bold);
}

std::uint64_t bins_covered(const PreparedScenario& prepared, const std::string& name,
                           std::uint64_t seed) {
  const Ground on = prepared.scenario().world->ground();
  SituationCoverage coverage;
  for (std::uint64_t test = 0; test < 160; ++test) {
    coverage.add(covered_bins(run(prepared, name, 3, test, seed).recording, on));
  }
  return coverage.covered();
}

TEST(ATeam, OfRandomAndDirectedAgentsCoversMoreThanEither) {  // F5
  const auto prepared = scenario("team");
  for (const std::uint64_t seed : {0U, 1U}) {
    const std::uint64_t mixed = bins_covered(*prepared, "mixed", seed);
    EXPECT_GE(mixed, bins_covered(*prepared, "random_action", seed) + 5) << seed;
    EXPECT_GE(mixed, bins_covered(*prepared, "coverage_directed", seed) + 5) << seed;
  }
}

constexpr std::uint64_t kTrafficTests = 20;
constexpr std::size_t kRider = 4;  // the AV, three pedestrians, then the actors
constexpr std::size_t kOncoming = 5;
constexpr std::size_t kLight = 6;

/// scenarios/traffic.yaml without some of its actors.
std::shared_ptr<const PreparedScenario> traffic_without(const std::string& actor) {
  Scenario scenario = testing_scenario::scenario("traffic")->scenario();
  CrossingParameters parameters = crossing_parameters(*scenario.world);
  auto& actors = parameters.actors;
  for (std::size_t i = 0; i < actors.size(); ++i) {
    if (actors[i].name != actor) continue;
    actors.erase(actors.begin() + static_cast<std::ptrdiff_t>(i));
    scenario.actors.erase(scenario.actors.begin() + static_cast<std::ptrdiff_t>(i));
    break;
  }
  scenario.world = std::make_shared<CrossingSpec>(std::move(parameters));
  Diagnostics warnings;
  return PreparedScenario::prepare(std::move(scenario), warnings).value();
}

/// The AV stands before the crosswalk of the scenario while its light is not green.
bool waits_at_the_light(const Recording& recording) {
  constexpr double kLineM = 105;
  bool green = true;
  for (std::size_t tick = 1; tick < recording.scenes(); ++tick) {
    for (const RecordedEvent& event : recording.events()) {
      if (event.kind == "signal" && event.tick == tick) green = event.text == "green";
    }
    const ActorState& av = recording.scene(tick)[0];
    const double to_line = kLineM - av.y_m - recording.actors()[0].length_m / 2;
    if (!green && av.speed_mps < 0.5 && to_line > 0 && to_line < 20) return true;
  }
  return false;
}

double seconds(const Recording& recording) {
  return static_cast<double>(recording.scenes() - 1) * recording.tick_s();
}

TEST(Traffic, MakesTheAvFollowTheCyclistAndStopAtTheRedLight) {  // F12
  const auto prepared = scenario("traffic");
  const auto no_light = traffic_without("light");
  const auto no_rider = traffic_without("rider");
  for (const std::uint64_t seed : {0U, 1U}) {
    int waited = 0;
    int waited_without_light = 0;
    int later_than_without_rider = 0;
    for (std::uint64_t test = 0; test < kTrafficTests; ++test) {
      const Recording recording = run(*prepared, "proximity", 3, test, seed).recording;
      waited += waits_at_the_light(recording) ? 1 : 0;
      const Recording dark = run(*no_light, "proximity", 3, test, seed).recording;
      waited_without_light += waits_at_the_light(dark) ? 1 : 0;
      const Recording alone = run(*no_rider, "proximity", 3, test, seed).recording;
      later_than_without_rider += seconds(recording) > seconds(alone) ? 1 : 0;
    }
    EXPECT_GE(waited, 18) << "seed " << seed;
    EXPECT_EQ(waited_without_light, 0) << "seed " << seed;
    EXPECT_GE(later_than_without_rider, 18) << "seed " << seed;
  }
}

TEST(Traffic, LeavesAtTheEndOfTheRoad) {  // F12
  const auto prepared = scenario("traffic");
  const double limit_s = crossing_parameters(*prepared->scenario().world).time_limit_s;
  const double road_m = prepared->scenario().world->plan().length_m();
  for (const std::uint64_t seed : {0U, 1U}) {
    for (std::uint64_t test = 0; test < kTrafficTests; ++test) {
      const Recording recording = run(*prepared, "proximity", 3, test, seed).recording;
      ASSERT_EQ(recording.actors()[kRider].kind, ActorKind::cyclist);
      ASSERT_EQ(recording.actors()[kLight].kind, ActorKind::signal);
      EXPECT_LT(seconds(recording), limit_s) << "test " << test << ", seed " << seed;
      const auto last = recording.scene(recording.scenes() - 1);
      EXPECT_GT(last[kRider].y_m, road_m) << "test " << test << ", seed " << seed;
      EXPECT_LT(last[kOncoming].y_m, 0) << "test " << test << ", seed " << seed;
    }
  }
}

TEST(AParkedCar, HidesWhoStepsOutBehindIt) {
  const auto first_slow_tick = [](const std::vector<std::string>& sets) {
    const auto prepared = scenario("zebra", sets);
    Scenario copy = prepared->scenario();
    testing_scenario::start_from(copy, {{0, {{1, 29}}}});
    Diagnostics warnings;
    const auto placed = PreparedScenario::prepare(std::move(copy), warnings);
    const Recording recording = run(*placed.value(), "proximity", 1, 0).recording;
    std::size_t tick = 0;
    while (tick < recording.scenes() && recording.scene(tick)[0].speed_mps > 8.9) ++tick;
    return tick;
  };
  EXPECT_GT(first_slow_tick({}), first_slow_tick({"world.obstacles=[]"}));
}

TEST(AMap, KeepsPedestriansOutOfHouses) {  // F7
  const auto prepared = scenario("junction");
  const Layout layout(crossing_parameters(*prepared->scenario().world));
  for (std::uint64_t test = 0; test < 10; ++test) {
    const Seen seen = run(*prepared, "by_features", 5, test);
    for (const Position start : seen.outcome.start) {
      EXPECT_EQ(layout.at(start), Surface::pavement);
    }
    for (std::size_t tick = 0; tick < seen.recording.scenes(); ++tick) {
      for (const ActorState& state : seen.recording.scene(tick).subspan(1)) {
        const Position at{static_cast<int>(state.x_m / 1.5), static_cast<int>(state.y_m / 1.5)};
        EXPECT_TRUE(layout.is_free(at));
      }
    }
  }
}

/// How often two pedestrians share a cell after a step of one of them.
int shared_cells(const PreparedScenario& prepared, const std::string& name) {
  int shared = 0;
  for (std::uint64_t test = 0; test < 30; ++test) {
    const Recording recording = run(prepared, name, 10, test).recording;
    for (std::size_t tick = 1; tick < recording.scenes(); ++tick) {
      const auto scene = recording.scene(tick).subspan(1);
      for (std::size_t i = 0; i < scene.size(); ++i) {
        for (std::size_t j = i + 1; j < scene.size(); ++j) {
          const bool same = scene[i].x_m == scene[j].x_m && scene[i].y_m == scene[j].y_m;
          if (same && (scene[i].speed_mps > 0 || scene[j].speed_mps > 0)) ++shared;
        }
      }
    }
  }
  return shared;
}

TEST(Negotiation, KeepsPedestriansFromWalkingThroughEachOther) {  // F16
  const auto prepared = scenario("negotiation");
  EXPECT_GT(shared_cells(*prepared, "proximity"), 0);
  EXPECT_EQ(shared_cells(*prepared, "negotiating"), 0);
}

TEST(Negotiation, CostsLittleAccuracy) {  // F16
  const auto prepared = scenario("negotiation");
  const int alone = successes(*prepared, "proximity", 3, 100);
  EXPECT_NEAR(successes(*prepared, "negotiating", 3, 100), alone, 15);
}

TEST(Speed, OfPedestriansIsThatOfTheirSteps) {  // F17
  const Recording recording = run(*scenario("speeds"), "proximity", 1, 0).recording;
  double fastest = 0;
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    fastest = std::max(fastest, recording.scene(tick)[1].speed_mps);
  }
  EXPECT_NEAR(fastest, 1.5, 1e-9);
}

TEST(Speed, AndDirectionOfTravelChangeTheResults) {  // F17
  EXPECT_GT(successes(*scenario("speeds", {"world.pedestrians.speed_mps=3"}), "intersect", 1, 200),
            successes(*scenario("speeds"), "intersect", 1, 200))
      << "who is faster reaches the AV's way from farther away";
  const int walking = successes(*scenario("speeds"), "proximity", 1, 200);
  EXPECT_NE(successes(*scenario("speeds", {"behaviours.proximity.parameters.first_way=back"}),
                      "proximity", 1, 200),
            walking);
}

TEST(Density, OfAgentsRaisesTheAccuracy) {  // F15
  const auto prepared = scenario("speeds");
  EXPECT_LT(successes(*prepared, "proximity", 1, 200), successes(*prepared, "proximity", 5, 200));
}

}  // namespace
}  // namespace jaywalk
