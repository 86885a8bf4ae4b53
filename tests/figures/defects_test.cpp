// SPDX-License-Identifier: Apache-2.0
// Defects in scenarios: the same tests with the healthy twin and with a defective AV.

#include "env/vehicle/defects.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scenario/scenarios.h"

namespace jaywalk::testing_scenario {
namespace {

std::vector<double> speeds(const Recording& recording) {
  std::vector<double> result;
  for (std::size_t tick = 0; tick < recording.scenes(); ++tick) {
    result.push_back(recording.scene(tick)[0].speed_mps);
  }
  return result;
}

/// In how many of the first tests the AV drives otherwise than it does healthy.
int changed(const std::string& name, std::uint64_t tests, const std::string& defect,
            std::vector<std::string> sets = {}) {
  const auto healthy = scenario(name, sets);
  sets.push_back("world.av.defect=" + defect);
  const auto defective = scenario(name, sets);
  int count = 0;
  for (std::uint64_t test = 0; test < tests; ++test) {
    const auto as_healthy = speeds(run(*healthy, "proximity", 3, test).recording);
    if (speeds(run(*defective, "proximity", 3, test).recording) != as_healthy) ++count;
  }
  return count;
}

TEST(DefectsInScenarios, LeadToFailuresThatTheHealthyTwinAvoids) {
  const auto failures = [](std::vector<std::string> sets) {
    return verdicts(*scenario("rules_of_the_road", std::move(sets)), "far", "avoidability", 60)
        .of(Verdict::fail);
  };
  EXPECT_EQ(failures({}), 0U);
  EXPECT_GT(failures({"world.av.defect=latency=1"}), 0U);
  EXPECT_GT(failures({"world.av.defect=weak-brakes"}), 0U);
  EXPECT_EQ(failures({"world.av.defect=latency=1", "world.av.defect=[]"}), 0U);
}

TEST(DefectsInScenarios, SeeTheObstaclesOfTheRoad) {
  EXPECT_GT(changed("zebra", 40, "near-obstacle=2"), 0);
  EXPECT_EQ(changed("zebra", 40, "near-obstacle=2", {"world.obstacles=[]"}), 0);
}

TEST(DefectsInScenarios, AreTheSameForAnyOrderOfTests) {
  const auto prepared = scenario("rules_of_the_road", {"world.av.defect=[latency, slow-brakes]"});
  const auto alone = speeds(run(*prepared, "near", 1, 7).recording);
  (void)run(*prepared, "near", 1, 6);
  EXPECT_EQ(speeds(run(*prepared, "near", 1, 7).recording), alone);
}

TEST(DefectsInScenarios, AreOnControllersOfOnesOwn) {
  EXPECT_GT(changed("external", 3, "weak-brakes=1"), 0);
}

constexpr const char* kBehaviours[] = {"brink", "feint", "loiter", "shadow", "decoy_and_runner",
                                       "tail",  "stall", "sprint", "crowd",  "repeat",
                                       "hunter"};

TEST(StandardSet, HasNoBehaviourThatDropsAnIntention) {
  const auto prepared = scenario("defects", {"experiment.defects=[]"});
  for (std::size_t index = 0; index < prepared->behaviours().size(); ++index) {
    for (const std::uint32_t agents : {1U, 3U}) {
      std::size_t drops = 0;
      for (std::uint64_t test = 0; test < 50; ++test) {
        drops += run_test(*prepared, {.behaviour = index, .agents = agents, .test = test})
                     .troubles.drops.size();
      }
      EXPECT_EQ(drops, 0U) << prepared->behaviours()[index].name << " with " << agents;
    }
  }
}

// Others of the crossing, beside cars that stand close together, on the pavement and at the road's
// end.
TEST(ParkedCars, AreWalkedRound) {
  for (const std::string tick : {"world.tick=0.1", "world.tick=0.4", "world.tick=1"}) {
    const auto prepared = scenario(
        "defects",
        {"experiment.defects=[]", tick, "world.pedestrians.features=true",
         "world.obstacles=[{rows: [2, 2], cells: [40, 43]}, {rows: [2, 2], cells: [44, 46]}, "
         "{rows: [9, 9], cells: [50, 65]}, {rows: [0, 1], cells: [61, 62]}]",
         "behaviours=[random_action, random_behaviour, proximity, intersect, intersect_literal, "
         "election, election_by_intersect, recalculating, negotiating, personality, by_features, "
         "directed, coverage_directed, scripted, learner, learner_team, learner_coverage, "
         "learner_directed, hunter]"});
    const std::vector<Rectangle> cars = prepared->scenario().world->ground().obstacles;
    for (std::size_t index = 0; index < prepared->behaviours().size(); ++index) {
      std::size_t drops = 0;
      std::size_t overlaps = 0;
      for (std::uint64_t test = 0; test < 40; ++test) {
        Recording recording;
        const TestRun run = run_test(*prepared, {.behaviour = index, .agents = 3, .test = test},
                                     {.record = &recording});
        drops += run.troubles.drops.size();
        for (std::size_t at = 0; at < recording.scenes(); ++at) {
          for (const ActorState& each : recording.scene(at).subspan(1)) {
            const double half = size_of(ActorKind::pedestrian).width_m / 2 - 1e-5;
            overlaps += std::ranges::count_if(cars, [&](const Rectangle& car) {
              return car.overlaps(
                  {each.x_m - half, each.x_m + half, each.y_m - half, each.y_m + half});
            });
          }
        }
      }
      EXPECT_EQ(drops, 0U) << prepared->behaviours()[index].name << ", " << tick;
      EXPECT_EQ(overlaps, 0U) << prepared->behaviours()[index].name << ", " << tick;
    }
  }
}

/// The behaviour that finds most of a defect, and its world.
struct Specialist {
  const char* name;
  const char* defect;
  std::uint32_t agents = 1;
  const char* setting = "world.av.start=0";
};

void PrintTo(const Specialist& row, std::ostream* out) { *out << row.name << " at " << row.defect; }

class Specialists : public ::testing::TestWithParam<Specialist> {};

// Seed 0, with which no behaviour was written; only how long stall stands was chosen with it.
TEST_P(Specialists, AreBetterThanAnyOtherAtTheirDefect) {
  const Specialist& row = GetParam();
  const auto prepared = scenario(
      "defects",
      {"experiment.defects=[]", std::string("world.av.defect=") + row.defect, row.setting});
  const auto failures = [&](const std::string& name) {
    return verdicts(*prepared, name, "avoidability", 40, row.agents).of(Verdict::fail);
  };
  const auto kills = failures(row.name);
  EXPECT_GT(kills, failures("random_behaviour"));
  for (const std::string other : kBehaviours) {
    if (other == row.name) continue;
    EXPECT_GT(kills, failures(other)) << other;
  }
}

INSTANTIATE_TEST_SUITE_P(
    StandardSet, Specialists,
    ::testing::Values(Specialist{"brink", "comfort-braking=2"},
                      Specialist{"feint", "kerb-standing"}, Specialist{"loiter", "lateral-bias"},
                      Specialist{"shadow", "near-obstacle", 1, "world.av.start=-40"},
                      Specialist{"decoy_and_runner", "nearest-only", 2, "world.av.start=-40"},
                      Specialist{"tail", "short-range=20"}, Specialist{"stall", "gives-up=15"},
                      Specialist{"sprint", "fast-as-noise", 1, "world.pedestrians.speed_mps=3"},
                      Specialist{"crowd", "group-as-first", 2},
                      Specialist{"repeat", "trusts-walkers"},
                      Specialist{"hunter", "ignores-along"}));

TEST(PlainModels, FailBeforeTheHunterFromNearlyEveryStart) {
  for (const std::string model : {"braking", "aeb", "idm"}) {
    const auto prepared = scenario("defects", {"experiment.defects=[]", "world.av.model=" + model});
    EXPECT_GE(verdicts(*prepared, "hunter", "avoidability", 40).of(Verdict::fail), 34U) << model;
  }
}

TEST(BrokenDrivers, AreFoundByTheHunterUnlessTheyAreHealthy) {
  const auto failures = [](const std::string& behaviour, const std::string& fault) {
    const auto prepared = scenario(
        "broken", {"experiment.defects=[]", "world.av.command=[python3, " +
                                                project_file("scenarios/controllers/broken.py") +
                                                ", " + fault + "]"});
    return verdicts(*prepared, behaviour, "avoidability", 15).of(Verdict::fail);
  };
  EXPECT_EQ(failures("hunter", "healthy"), 0U);
  for (const char* fault : {"cry-wolf", "soft-stop", "pulsed-brakes"}) {
    EXPECT_GT(failures("hunter", fault), 3 * failures("random_behaviour", fault)) << fault;
  }
}

}  // namespace
}  // namespace jaywalk::testing_scenario
