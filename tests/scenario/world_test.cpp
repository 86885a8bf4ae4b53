// SPDX-License-Identifier: Apache-2.0
// The world alone gives the case study's exact answers when the specification's behaviours, in C++,
// act in it. Then the AgentSpeak programs can be measured by the same world (behaviours_test.cpp).

#include <gtest/gtest.h>

#include "env/crossing/spawn.h"
#include "exact.h"
#include "reference.h"

namespace jaywalk {
namespace {

using reference::Behaviour;

// Over all start cells and both ways to set out, each weighted by its probability.
double enumerated_accuracy(Behaviour behaviour) {
  const CrossingParameters paper;
  double sum = 0;
  for (const int row : {0, 1, 10, 11}) {
    const Interval cells = spawn_cells(paper, row);
    int successes = 0;
    for (int cell = cells.first; cell <= cells.last; ++cell) {
      for (const Direction way : {Direction::forward, Direction::back}) {
        successes += reference::run(behaviour, paper, {{row, cell}}, 0, way).success ? 1 : 0;
      }
    }
    sum += successes / (4.0 * 2.0 * cells.size());
  }
  return sum;
}

double simulated_accuracy(Behaviour behaviour, std::size_t agents, std::uint64_t tests) {
  const CrossingParameters paper;
  std::uint64_t successes = 0;
  for (std::uint64_t test = 0; test < tests; ++test) {
    const std::vector<Position> start = spawn(paper, agents, mix(1, test));
    successes += reference::run(behaviour, paper, start, mix(2, test)).success ? 1U : 0U;
  }
  return static_cast<double>(successes) / static_cast<double>(tests);
}

TEST(World, GivesTheExactAccuracyOfDeterministicBehaviours) {
  EXPECT_NEAR(enumerated_accuracy(Behaviour::proximity), 0.47917, 5e-6);
  EXPECT_NEAR(enumerated_accuracy(Behaviour::intersect), 1, 1e-12);
  EXPECT_NEAR(enumerated_accuracy(Behaviour::intersect_literal), 0.49109, 5e-6);
  EXPECT_NEAR(enumerated_accuracy(Behaviour::election), 0.47917, 5e-6);
  EXPECT_NEAR(enumerated_accuracy(Behaviour::election_by_intersect), 1, 1e-12);
}

TEST(World, GivesTheAccuracyOfRandomBehavioursWithinChance) {
  constexpr std::uint64_t kWorldTests = 5000;
  for (const exact::Answer& answer : exact::kAnswers) {
    if (answer.behaviour != Behaviour::random_action &&
        answer.behaviour != Behaviour::random_behaviour) {
      continue;  // enumerated above
    }
    for (const std::size_t agents : {1U, 3U, 10U}) {
      const double expected = exact::accuracy(answer.probability, agents);
      EXPECT_NEAR(simulated_accuracy(answer.behaviour, agents, kWorldTests), expected,
                  exact::tolerance(expected, kWorldTests) + 1e-12)
          << answer.program << ", " << agents;
    }
  }
}

TEST(World, GivesTheAccuracyOfElectionsWithinChance) {
  constexpr std::uint64_t kWorldTests = 5000;
  for (const exact::ElectionAnswer& answer : exact::kElection) {
    EXPECT_NEAR(simulated_accuracy(Behaviour::election, answer.agents, kWorldTests),
                answer.accuracy, exact::tolerance(answer.accuracy, kWorldTests) + 0.009)
        << answer.agents;
  }
}

}  // namespace
}  // namespace jaywalk
