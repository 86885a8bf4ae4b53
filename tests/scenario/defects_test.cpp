// Defects in scenarios: the same tests with the healthy twin and with a defective AV.

#include "env/vehicle/defects.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "scenarios.h"

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

TEST(StandardSet, HasNoNewBehaviourThatDropsAnIntention) {
  const auto prepared = scenario("defects", {"experiment.defects=[]"});
  for (const char* name : {"brink", "feint", "loiter", "shadow", "decoy_and_runner", "tail",
                           "stall", "sprint", "crowd", "repeat", "hunter"}) {
    for (const std::uint32_t agents : {1U, 3U}) {
      std::size_t drops = 0;
      for (std::uint64_t test = 0; test < 30; ++test) {
        drops += run_trial(*prepared, {.behaviour = behaviour(*prepared, name),
                                       .agents = agents,
                                       .test = test})
                     .troubles.drops.size();
      }
      EXPECT_EQ(drops, 0U) << name << " with " << agents;
    }
  }
}

// Seed 0, with which no behaviour was written.
TEST(Specialists, AreBetterThanAnyOtherAtTheirDefect) {
  const auto failures = [](const std::string& behaviour, const std::string& defect,
                           const std::string& speed) {
    const auto prepared = scenario("defects", {"experiment.defects=[]", "world.av.defect=" + defect,
                                               "world.pedestrians.speed_mps=" + speed});
    return verdicts(*prepared, behaviour, "avoidability", 40).of(Verdict::fail);
  };
  struct Row {
    const char* best;
    const char* defect;
    const char* speed;
  };
  for (const Row& row : {Row{"loiter", "lateral-bias", "1.5"}, Row{"sprint", "fast-as-noise", "3"},
                         Row{"tail", "short-range=20", "1.5"}}) {
    const auto kills = failures(row.best, row.defect, row.speed);
    for (const char* other : {"random_behaviour", "brink", "feint", "loiter", "shadow", "tail",
                              "sprint", "repeat", "hunter"}) {
      if (std::string(other) == row.best) continue;
      EXPECT_GT(kills, failures(other, row.defect, row.speed)) << other << " at " << row.defect;
    }
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
