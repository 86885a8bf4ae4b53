// SPDX-License-Identifier: Apache-2.0
// Avoidable and unavoidable collisions: the judge of recorded tests and the AV model
// `careful-competent` are the same driver, so they cannot disagree.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "experiment/judge/signals/signals.h"
#include "tests/scenario/scenarios.h"

namespace jaywalk::testing_scenario {
namespace {

Recording drive(const PreparedScenario& prepared, const TestSetup& setup) {
  Recording recording;
  const TestRun result = run_test(prepared, setup, {.record = &recording});
  EXPECT_TRUE(result.completed) << result.message;
  return recording;
}

/// Whether they touch within `ticks` ticks.
bool collides(const TestView& view, ActorIndex actor, std::size_t ticks) {
  const auto touched = view.values(SignalId::collision, actor);
  const auto within = touched.first(std::min(ticks, touched.size()));
  return std::ranges::find(within, 1) != within.end();
}

struct Counts {
  int avoidable = 0;
  int unavoidable = 0;
  // The healthy driver in the same test decides otherwise.
  int wrong = 0;
};

struct JudgedWorld {
  std::string scenario;
  std::string behaviour;
  std::uint32_t agents;
  std::vector<std::string> sets;
};

/// Judges the collisions of an AV, and holds them against those of the healthy driver in the same
/// tests.
Counts judge_collisions(const JudgedWorld& world, const std::vector<std::string>& vehicle,
                        std::uint64_t seed, std::uint64_t tests) {
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), world.sets.begin(), world.sets.end());
    return scenario(world.scenario, std::move(more));
  };
  const auto driven = with(vehicle);
  const auto healthy = with({"world.av.model=careful-competent"});
  const Ground on = driven->scenario().world->ground();
  Counts counts;
  for (std::uint64_t test = 0; test < tests; ++test) {
    const TestSetup setup{.behaviour = behaviour(*driven, world.behaviour),
                          .agents = world.agents,
                          .seed = seed,
                          .test = test};
    const Recording record = drive(*driven, setup);
    const Recording competent = drive(*healthy, setup);
    const TestView view(record, on);
    const TestView competent_view(competent, on);
    for (const ActorIndex user : view.road_users()) {
      if (!collides(view, user, view.ticks())) continue;
      const bool avoidable = view.values(SignalId::avoidable, user).front() != 0;
      // A slower driver may meet another actor after the judged drive has ended.
      const bool avoided = !collides(competent_view, user, view.careful_drive().size());
      ++(avoidable ? counts.avoidable : counts.unavoidable);
      if (avoidable != avoided) {
        ++counts.wrong;
        ADD_FAILURE() << world.scenario << " " << world.behaviour << " " << vehicle.back()
                      << " seed " << seed << " test " << test << " p" << user << ": judged "
                      << (avoidable ? "avoidable" : "unavoidable");
      }
    }
  }
  return counts;
}

const std::string kReactions = "world.av.reaction=";
const std::string kModel = "world.av.model=";

std::vector<std::vector<std::string>> vehicles() {
  const std::string careful = kModel + "careful-competent";
  return {{kModel + "constant"},
          {careful},
          {careful, kReactions + "0.1"},
          {careful, kReactions + "0.7"},
          {careful, kReactions + "1.2"},
          {careful, "world.av.deceleration=3"},
          {kModel + "braking"},
          {kModel + "braking", "world.av.deceleration=2"},
          {kModel + "aeb"},
          {kModel + "idm"}};
}

TEST(Avoidability, AgreesWithTheHealthyDriverInTheSameTests) {
  const std::string near = "behaviours.near.parameters.radius=";
  // Nobody in these worlds moves otherwise because the vehicle does, once it is a risk.
  const std::string at_random =
      "behaviours.proximity.program=" + project_file("agents/crossing/random_behaviour.asl");
  const std::vector<JudgedWorld> worlds = {
      {"rules_of_the_road", "near", 1, {near + "20"}},
      {"rules_of_the_road", "near", 1, {near + "20", "world.tick=0.25"}},
      {"rules_of_the_road", "near", 1, {near + "22", "world.tick=1"}},
      {"rules_of_the_road", "near", 1, {near + "34", "world.av.speed_mps=15"}},
      {"rules_of_the_road", "near", 1, {near + "17", "world.av.rows=[2, 3]"}},
      {"rules_of_the_road", "near", 1, {near + "18", "world.pedestrians.speed_mps=2"}},
      {"zebra", "proximity", 1, {"behaviours.proximity.parameters.radius=18"}},
      {"zebra", "proximity", 5, {at_random, "world.until=road_end"}},
      {"traffic", "proximity", 5, {at_random}},
      {"paper", "random_behaviour", 5, {"world.until=road_end"}},
      {"paper", "random_action", 5, {"world.until=road_end", "world.tick=0.5"}}};
  for (const JudgedWorld& world : worlds) {
    Counts sum;
    for (const auto& vehicle : vehicles()) {
      for (const std::uint64_t seed : {0U, 1U}) {
        const Counts counts = judge_collisions(world, vehicle, seed, 40);
        sum.avoidable += counts.avoidable;
        sum.unavoidable += counts.unavoidable;
        sum.wrong += counts.wrong;
      }
    }
    EXPECT_EQ(sum.wrong, 0) << world.sets.back();
    EXPECT_GT(sum.avoidable, 10) << world.sets.back();
    EXPECT_GT(sum.unavoidable, 10) << world.sets.back();
  }
}

}  // namespace
}  // namespace jaywalk::testing_scenario
