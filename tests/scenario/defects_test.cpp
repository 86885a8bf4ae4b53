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

}  // namespace
}  // namespace jaywalk::testing_scenario
