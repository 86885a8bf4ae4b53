// SPDX-License-Identifier: Apache-2.0
// The signals of recorded tests agree with what the world itself says of them.

#include "experiment/judge/signals/signals.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "scenarios.h"

namespace jaywalk::testing_scenario {
namespace {

TEST(Signals, SeeThePreconditionWhenTheWorldDoes) {
  const auto prepared = paper();
  ASSERT_TRUE(prepared);
  const Ground ground_of_paper = prepared->scenario().world->ground();
  int successes = 0;
  for (std::size_t behaviour = 0; behaviour < prepared->behaviours().size(); ++behaviour) {
    for (std::uint64_t test = 0; test < 100; ++test) {
      Recording recording;
      const TestRun run = run_test(*prepared, {.behaviour = behaviour, .agents = 4, .test = test},
                                   {.record = &recording});
      const TestView view(recording, ground_of_paper);
      const auto last = static_cast<std::size_t>(run.outcome.ticks);
      ASSERT_EQ(view.ticks(), last + 1);
      successes += run.outcome.success ? 1 : 0;
      for (ActorIndex user = 1; user <= 4; ++user) {
        const auto inside = view.values(SignalId::in_zone, user);
        // A test ends when a pedestrian enters the zone.
        EXPECT_TRUE(std::ranges::all_of(inside.first(last), [](double in) { return in == 0; }));
        const bool hit = std::ranges::count(run.outcome.met_by, user - 1) > 0;
        if (hit) {
          EXPECT_EQ(inside[last], 1) << "behaviour " << behaviour << ", test " << test;
        }
        if (!run.outcome.success) {
          EXPECT_EQ(inside[last], 0);
        }
      }
    }
  }
  EXPECT_GT(successes, 100);
  EXPECT_LT(successes, 650);
}

}  // namespace
}  // namespace jaywalk::testing_scenario
