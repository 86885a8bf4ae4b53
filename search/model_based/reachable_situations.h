// SPDX-License-Identifier: Apache-2.0
#pragma once

// Model-based generation: which situations tests of a scenario can meet at all, found breadth-first
// over what one pedestrian can do from each cell in which tests begin, against an AV whose
// controller is part of the model. Each situation comes with the shortest walk that meets it, which
// agents/crossing/scripted.asl repeats.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "experiment/judge/situations/situations.h"
#include "experiment/test_run/prepared_scenario.h"

namespace jaywalk::search {

struct ReachPlan {
  std::shared_ptr<const PreparedScenario> prepared;
  /// Index of scripted among its behaviours.
  std::size_t behaviour = 0;
  /// Tests whose start cells are taken, of this seed.
  std::uint64_t tests = 2000;
  std::uint64_t seed = 0;
  /// Ticks after which a walk is given up, and states after which everything is.
  std::uint32_t most_ticks = 1000;
  std::uint64_t most_states = 5'000'000;
  unsigned threads = 1;
  /// Asked now and then, after some walks; true ends it, incomplete. Not set: never.
  std::function<bool()> interrupted;
};

struct Reach {
  /// By item, then bin (situation_items()): a walk that covers it; none if no walk does.
  std::vector<std::vector<std::optional<ScriptedWalk>>> walks;
  /// Different cells in which tests begin, and different states that walks lead to.
  std::uint64_t starts = 0;
  std::uint64_t states = 0;
  /// Every walk was followed to the end of its test; otherwise bins without a walk may be met.
  bool complete = false;
};

/// Of walks that leave all actors in the same places, and whose starts are in the same bins, only
/// the shortest is followed; up to situation::kLate_s, where the time of an event matters, the
/// first of each length. For AVs that brake, the velocities must be the same, too; other memory of
/// their controllers is not compared.
[[nodiscard]] Reach reach(const ReachPlan& plan);

/// How many bins of an item, or of all, have a walk.
[[nodiscard]] std::uint64_t reachable(const std::vector<std::optional<ScriptedWalk>>& item);

/// As a table for people: each item with the bins that no test can meet.
[[nodiscard]] std::string reach_text(const Reach& reach);
/// As parse_reach_file() reads it: a row for each bin.
[[nodiscard]] std::string reach_csv(const Reach& reach);

}  // namespace jaywalk::search
