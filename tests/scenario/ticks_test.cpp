// SPDX-License-Identifier: Apache-2.0
// Behaviours reckon in metres and seconds: they do the same whatever the length of a tick.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "env/config/parameter_settings.h"
#include "scenarios.h"

namespace jaywalk::testing_scenario {
namespace {

constexpr std::uint64_t kTests = 200;

/// The case study's speeds at ticks of that length, in seconds.
std::vector<std::string> at_tick(const std::string& seconds, std::vector<std::string> more = {}) {
  more.insert(more.begin(),
              {"world.tick=" + seconds, "world.av.speed_mps=9", "world.pedestrians.speed_mps=1.5"});
  return more;
}

std::vector<std::string> installed_pedestrians() {
  std::vector<std::string> names;
  for (const std::string& path : installed_behaviours("crossing", installed_files())) {
    const std::string name = std::filesystem::path(path).stem().string();
    if (name != "cyclist" && name != "signal") names.push_back(name);
  }
  return names;
}

/// Whether a behaviour decides by chance in every tick, or at a tick of a given number.
bool reckons_in_ticks(const std::string& name) {
  return name == "random_action" || name == "random_behaviour" || name == "scripted" ||
         name.starts_with("learner");
}

/// Whether a behaviour times its steps to tenths of a second, as the AV does its braking: it comes
/// too late at ticks of a second.
bool needs_short_ticks(const std::string& name) {
  return name == "crowd" || name == "decoy_and_runner" || name == "hunter";
}

/// In how many tests a behaviour's only pedestrian meets the precondition; none may fail in a plan.
int met(const std::string& name, const std::string& tick) {
  const auto prepared = paper({.preset = {},
                               .sets = at_tick(tick, {"world.pedestrians.features=true"}),
                               .behaviours = {name},
                               .files = installed_files()});
  if (!prepared) return 0;
  int count = 0;
  for (std::uint64_t test = 0; test < kTests; ++test) {
    const TestRun result = run_test(*prepared, {.agents = 1, .test = test});
    EXPECT_TRUE(result.completed) << result.message;
    EXPECT_TRUE(result.troubles.drops.empty()) << name << " at ticks of " << tick << " s";
    count += result.outcome.success ? 1 : 0;
  }
  return count;
}

class Ticks : public testing::TestWithParam<std::string> {};

TEST_P(Ticks, OfAnyLengthLeadToTheSameBehaviour) {
  const std::string& name = GetParam();
  const int at_a_second = met(name, "1");
  for (const char* tick : {"0.5", "0.1"}) {
    const int shorter = met(name, tick);
    EXPECT_GT(shorter, 0) << name << " at ticks of " << tick << " s";
    if (reckons_in_ticks(name) || needs_short_ticks(name)) continue;
    // A second is a coarse tick: whoever decides once in it steps out up to a second later.
    EXPECT_NEAR(shorter, at_a_second, 0.2 * kTests) << name << " at ticks of " << tick << " s";
  }
}

INSTANTIATE_TEST_SUITE_P(Behaviours, Ticks, testing::ValuesIn(installed_pedestrians()),
                         [](const auto& each) { return each.param; });

TEST(Directed, StandsInTheWayInGoodTimeAtAnyTick) {
  for (const char* tick : {"1", "0.5", "0.1"}) {
    const auto prepared = scenario("several_assertions", at_tick(tick, {"world.until=collision"}));
    const VerdictCounts counts = verdicts(*prepared, "avoidability", "avoidability", kTests);
    EXPECT_GE(counts.of(Verdict::fail), 100U) << "collisions at ticks of " << tick << " s";
    EXPECT_EQ(counts.of(Verdict::unavoidable), 0U) << "at ticks of " << tick << " s";
    EXPECT_EQ(counts.of(Verdict::pass), 0U) << "whoever stands there is hit, " << tick << " s";
  }
}

TEST(Directed, HasLeftTheLaneBeforeTheAvComesAtAnyTick) {
  for (const char* tick : {"1", "0.5", "0.1"}) {
    const auto prepared = scenario("several_assertions", at_tick(tick, {"world.until=collision"}));
    EXPECT_GE(verdicts(*prepared, "recovery", "recovery", kTests).exercised(), 50U)
        << "at ticks of " << tick << " s";
    EXPECT_EQ(verdicts(*prepared, "recovery", "avoidability", kTests).of(Verdict::fail), 0U)
        << "collisions at ticks of " << tick << " s";
  }
}

/// How often a step brings two pedestrians' bodies into each other.
int touches(const PreparedScenario& prepared, const std::string& name) {
  int count = 0;
  for (std::uint64_t test = 0; test < 20; ++test) {
    const Recording recording = run(prepared, name, 10, test).recording;
    const auto apart = [&](std::size_t tick, std::size_t i, std::size_t j) {
      const auto scene = recording.scene(tick);
      return std::array{std::abs(scene[i].x_m - scene[j].x_m),
                        std::abs(scene[i].y_m - scene[j].y_m)};
    };
    for (std::size_t tick = 1; tick < recording.scenes(); ++tick) {
      for (std::size_t i = 1; i < recording.scene(tick).size(); ++i) {
        for (std::size_t j = i + 1; j < recording.scene(tick).size(); ++j) {
          const auto now = apart(tick, i, j);
          const auto before = apart(tick - 1, i, j);
          const bool overlap = std::max(now[0], now[1]) < kPedestrianSizeM - 1e-6;
          if (overlap && now[0] + now[1] < before[0] + before[1] - 1e-6) ++count;
        }
      }
    }
  }
  return count;
}

TEST(Negotiation, KeepsBodiesApartAtShortTicks) {
  const auto prepared = scenario("negotiation", at_tick("0.1"));
  EXPECT_GT(touches(*prepared, "proximity"), 0);
  EXPECT_EQ(touches(*prepared, "negotiating"), 0);
}

TEST(TrafficSignal, ShowsItsColoursForAsLongAtAnyTick) {
  for (const char* tick : {"0.5", "0.1"}) {
    const auto prepared = scenario("traffic", at_tick(tick));
    const Recording recording = run(*prepared, "proximity", 1, 0).recording;
    std::vector<std::pair<std::string, double>> shown;
    for (const RecordedEvent& event : recording.events()) {
      if (event.kind != "signal" || shown.size() == 3) continue;
      shown.emplace_back(event.text, static_cast<double>(event.tick) * recording.tick_s());
    }
    ASSERT_GE(shown.size(), 2U) << tick;
    EXPECT_EQ(shown[0].first, "amber");
    EXPECT_NEAR(shown[0].second, 13, 0.51) << tick;
    EXPECT_EQ(shown[1].first, "red");
    EXPECT_NEAR(shown[1].second - shown[0].second, 2, 1e-6) << tick;
  }
}

}  // namespace
}  // namespace jaywalk::testing_scenario
