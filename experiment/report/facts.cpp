// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/facts.h"

#include <algorithm>
#include <cmath>

namespace jaywalk::reporting {
namespace {

/// Far outside of any world, where no picture reaches.
constexpr double kFarthest_m = 1e6;

Square square_of(double x_m, double y_m) {
  const auto index = [](double metres) {
    return static_cast<int>(
        std::floor(std::clamp(metres, -kFarthest_m, kFarthest_m) / kSquare_m + 1e-9));
  };
  return {index(x_m), index(y_m)};
}

}  // namespace

FactsTable::FactsTable(const ExperimentPlan& plan)
    : agents_(plan.agents),
      tests_(plan.tests),
      cells_(plan.behaviours.size() * plan.agents.size()) {}

std::size_t FactsTable::cell_index(std::size_t behaviour, std::uint32_t agents) const {
  const auto column =
      static_cast<std::size_t>(std::ranges::find(agents_, agents) - agents_.begin());
  return behaviour * agents_.size() + column;
}

void FactsTable::add(const TestKey& test, const TestResult& result) {
  Cell& cell = cells_[cell_index(test.behaviour, test.agents)];
  const std::lock_guard lock(cell.mutex);
  cell.facts.succeeded.resize(tests_);
  cell.facts.succeeded[test.number] = result.succeeded;
  cell.facts.errored.resize(tests_);
  cell.facts.errored[test.number] = result.errored;
  if (!result.errored) ++cell.facts.ticks[result.ticks];
}

void FactsTable::add_place(const TestKey& test, double x_m, double y_m) {
  Cell& cell = cells_[cell_index(test.behaviour, test.agents)];
  const std::lock_guard lock(cell.mutex);
  ++cell.facts.places[square_of(x_m, y_m)];
}

void FactsTable::add(const TestKey& test, const TestResult& result, const Recording& recording) {
  add(test, result);
  if (result.errored) return;
  for (const RecordedEvent& event : recording.events()) {
    if (event.kind != "precondition" || !event.actor) continue;
    const ActorState& state = recording.scene(event.tick)[*event.actor];
    add_place(test, state.x_m, state.y_m);
  }
}

const CellFacts& FactsTable::facts(std::size_t behaviour, std::uint32_t agents) const {
  return cells_[cell_index(behaviour, agents)].facts;
}

}  // namespace jaywalk::reporting
