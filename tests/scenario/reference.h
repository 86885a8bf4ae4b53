// SPDX-License-Identifier: Apache-2.0
#pragma once

// The behaviours of the case study once more, written down in C++ from the specification: what the
// AgentSpeak programs are compared with, step by step. Nothing but tests may use it.

#include <cstdint>
#include <optional>
#include <vector>

#include "env/crossing/crossing.h"
#include "interpreter/support/random.h"

namespace jaywalk::reference {

enum class Behaviour {
  random_action,
  random_behaviour,
  proximity,
  intersect,
  intersect_literal,
  election,
  election_by_intersect,
};

/// A step, or none.
using Step = std::optional<Direction>;

class Pedestrians {
 public:
  /// The world must outlive the pedestrians.
  Pedestrians(Behaviour behaviour, const Crossing& world, std::uint64_t seed);

  /// Everybody's step of the coming tick.
  [[nodiscard]] std::vector<Step> decide();
  /// Sets how an agent walks; in the first tick that is its first step.
  void walk(std::size_t agent, Direction way) { walkers_[agent].way = way; }

 private:
  struct Walker {
    std::optional<Direction> way;       // along the pavement
    std::optional<Direction> crossing;  // across the road
  };

  [[nodiscard]] bool chance(std::uint64_t one_in) { return random_.below(one_in) == 0; }
  [[nodiscard]] Step step_of(std::size_t agent);
  [[nodiscard]] Step random_action(Position position);
  [[nodiscard]] Step walk_on(std::size_t agent);
  [[nodiscard]] Step cross(std::size_t agent);
  [[nodiscard]] Direction way_across(Position position) const;
  [[nodiscard]] int distance(Position position) const;
  [[nodiscard]] std::optional<int> zone_entry(Position position) const;
  [[nodiscard]] bool crosses_early(Position position) const;
  void elect();

  Behaviour behaviour_;
  const Crossing& world_;
  SplitMix64 random_;
  std::vector<Walker> walkers_;
  bool elected_ = false;
};

/// Runs a whole test of the world with these pedestrians.
[[nodiscard]] CrossingResult run(Behaviour behaviour, const CrossingParameters& parameters,
                                 const std::vector<Position>& start, std::uint64_t seed,
                                 std::optional<Direction> way = {});

/// One tick in which each agent takes the given step.
void tick(Crossing& world, const CrossingVocabulary& vocabulary, const std::vector<Step>& steps);

}  // namespace jaywalk::reference
