// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/situation_table.h"

#include <algorithm>
#include <limits>

namespace jaywalk {
namespace {

constexpr std::uint8_t kNoBin = std::numeric_limits<std::uint8_t>::max();

}  // namespace

SituationTable::SituationTable(const ExperimentPlan& plan)
    : plan_(plan), cells_(plan.behaviours.size() * plan.agents.size()) {}

std::size_t SituationTable::cell_index(std::size_t behaviour, std::uint32_t agents) const {
  const auto place = std::ranges::find(plan_.agents, agents) - plan_.agents.begin();
  return behaviour * plan_.agents.size() + static_cast<std::size_t>(place);
}

void SituationTable::add(const TestKey& test, const SituationBins& bins) {
  Cell& cell = cells_[cell_index(test.behaviour, test.agents)];
  const std::size_t items = situation_items().size();
  std::call_once(cell.started, [&] { cell.bins.assign(plan_.tests * items, kNoBin); });
  for (std::size_t item = 0; item < bins.size(); ++item) {
    if (bins[item]) {
      cell.bins[test.number * items + item] = static_cast<std::uint8_t>(*bins[item]);
    }
  }
}

void SituationTable::add_to(SituationCoverage& coverage, std::size_t behaviour,
                            std::uint32_t agents, std::uint64_t first, std::uint64_t last) const {
  const Cell& cell = cells_[cell_index(behaviour, agents)];
  const std::size_t items = situation_items().size();
  SituationBins bins(items);
  for (std::uint64_t test = first; test < last; ++test) {
    for (std::size_t item = 0; item < items; ++item) {
      const std::uint8_t bin = cell.bins.empty() ? kNoBin : cell.bins[test * items + item];
      bins[item] = bin == kNoBin ? std::nullopt : std::optional<std::uint32_t>(bin);
    }
    coverage.add(bins);
  }
}

SituationCoverage SituationTable::coverage(std::size_t behaviour, std::uint32_t agents,
                                           std::uint64_t tests) const {
  SituationCoverage coverage;
  add_to(coverage, behaviour, agents, 0, tests);
  return coverage;
}

}  // namespace jaywalk
