// SPDX-License-Identifier: Apache-2.0
// The AgentSpeak programs against the specification in C++ (reference.h): every agent's every step.

#include <set>

#include <gtest/gtest.h>

#include "exact.h"
#include "reference.h"
#include "scenarios.h"

namespace jaywalk {
namespace {

using reference::Behaviour;
using testing_scenario::behaviour;
using testing_scenario::paper;

/// The positions of all agents before the first tick and after each.
using Path = std::vector<std::vector<Position>>;

Path path_of(const PreparedScenario& prepared, const TestSetup& setup) {
  Path path;
  TestOptions options;
  options.observe = [&](const World& world, const Mas&) {
    const auto positions = find_crossing(world)->positions();
    path.emplace_back(positions.begin(), positions.end());
  };
  const TestRun result = run_test(prepared, setup, options);
  EXPECT_TRUE(result.completed) << result.message;
  return path;
}

Direction step_between(Position from, Position to) {
  for (int i = 0; i < kDirectionCount; ++i) {
    if (neighbour(from, static_cast<Direction>(i)) == to) return static_cast<Direction>(i);
  }
  ADD_FAILURE() << "no step in the first tick";
  return Direction::forward;
}

// The path that the specification gives, for the ways in which the agents set out.
Path expected_path(Behaviour kind, const PreparedScenario& prepared, const Path& observed) {
  SymbolTable symbols;
  const CrossingVocabulary vocabulary(symbols);
  Crossing world(crossing_parameters(*prepared.scenario().world), vocabulary, observed[0]);
  reference::Pedestrians pedestrians(kind, world, 0);
  for (std::size_t i = 0; i < observed[0].size(); ++i) {
    pedestrians.walk(i, step_between(observed[0][i], observed[1][i]));
  }
  Path path{observed[0]};
  while (!world.finished()) {
    reference::tick(world, vocabulary, pedestrians.decide());
    path.emplace_back(world.positions().begin(), world.positions().end());
  }
  return path;
}

struct Subject {
  Behaviour kind;
  const char* program;
};

void PrintTo(const Subject& subject, std::ostream* stream) { *stream << subject.program; }

class DeterministicBehaviour : public testing::TestWithParam<Subject> {};

TEST_P(DeterministicBehaviour, StepsAsSpecified) {
  const auto prepared = paper();
  ASSERT_NE(prepared, nullptr);
  const std::size_t index = behaviour(*prepared, GetParam().program);
  for (const std::uint32_t agents : {1U, 2U, 3U, 10U}) {
    for (std::uint64_t test = 0; test < 60; ++test) {
      const TestSetup setup{.behaviour = index, .agents = agents, .seed = 3, .test = test};
      const Path observed = path_of(*prepared, setup);
      ASSERT_GE(observed.size(), 2U);
      ASSERT_EQ(observed, expected_path(GetParam().kind, *prepared, observed))
          << agents << " agents, test " << test;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, DeterministicBehaviour,
                         testing::Values(Subject{Behaviour::proximity, "proximity"},
                                         Subject{Behaviour::intersect, "intersect"},
                                         Subject{Behaviour::intersect_literal, "intersect_literal"},
                                         Subject{Behaviour::election, "election"},
                                         Subject{Behaviour::election_by_intersect,
                                                 "election_by_intersect"}),
                         [](const auto& each) { return std::string(each.param.program); });

TEST(Behaviours, SetOutInBothWaysEquallyOften) {
  const auto prepared = paper();
  int forward = 0;
  constexpr int kTests = 600;
  for (std::uint64_t test = 0; test < kTests; ++test) {
    const Path path = path_of(
        *prepared,
        {.behaviour = behaviour(*prepared, "proximity"), .agents = 1, .seed = 0, .test = test});
    forward += path[1][0].y > path[0][0].y ? 1 : 0;
  }
  // Four deviations, and some who are forced inward at the end.
  EXPECT_NEAR(forward, kTests / 2, 60);
}

TEST(Behaviours, OfTheRandomActionTakeEveryStepEquallyOften) {
  const auto prepared = paper();
  std::map<std::pair<int, int>, int> steps;
  int all = 0;
  for (std::uint64_t test = 0; test < 100; ++test) {
    const Path path = path_of(
        *prepared,
        {.behaviour = behaviour(*prepared, "random_action"), .agents = 5, .seed = 0, .test = test});
    for (std::size_t t = 1; t < path.size(); ++t) {
      for (std::size_t i = 0; i < path[t].size(); ++i) {
        const Position from = path[t - 1][i];
        if (from.x == 0 || from.x == 11 || from.y == 65) continue;  // fewer steps to choose from
        ++steps[{path[t][i].x - from.x, path[t][i].y - from.y}];
        ++all;
      }
    }
  }
  ASSERT_EQ(steps.size(), 5U);
  const double share = all / 5.0;
  for (const auto& [step, count] : steps) {
    EXPECT_NEAR(count, share, 4 * std::sqrt(share)) << step.first << ", " << step.second;
  }
}

TEST(Behaviours, DrawDifferentlyInEachAgentAndTest) {
  const auto prepared = paper();
  const std::size_t index = behaviour(*prepared, "random_action");
  std::set<std::vector<std::pair<int, int>>> walks;
  for (std::uint64_t test = 0; test < 5; ++test) {
    const Path path =
        path_of(*prepared, {.behaviour = index, .agents = 4, .seed = 0, .test = test});
    for (std::size_t i = 0; i < 4; ++i) {
      std::vector<std::pair<int, int>> walk;
      for (std::size_t t = 1; t < std::min<std::size_t>(path.size(), 5); ++t) {
        walk.emplace_back(path[t][i].x - path[0][i].x, path[t][i].y - path[0][i].y);
      }
      walks.insert(std::move(walk));
    }
  }
  EXPECT_GE(walks.size(), 18U);  // of 20; four random steps may coincide
}

}  // namespace
}  // namespace jaywalk
