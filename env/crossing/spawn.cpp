// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/spawn.h"

#include <cassert>

#include "env/crossing/road_user.h"
#include "interpreter/support/random.h"

namespace jaywalk {
namespace {

struct SpawnRow {
  int row = 0;
  Interval cells;
};

std::vector<SpawnRow> spawn_rows(const CrossingParameters& parameters) {
  std::vector<SpawnRow> result;
  for (int row = 0; row < grid(parameters).rows; ++row) {
    const Interval cells = spawn_cells(parameters, row);
    if (!cells.empty()) result.push_back({row, cells});
  }
  return result;
}

/// Whether some cells of a pavement's row may be something else.
bool is_uneven(const CrossingParameters& parameters) {
  return !parameters.map.empty() || !parameters.obstacles.empty();
}

int draw_below(SplitMix64& random, int bound) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(bound)));
}

/// As spawn: a row first, then one of its free cells; or one of all free cells.
std::vector<Position> spawn_unevenly(const CrossingParameters& parameters, std::size_t agents,
                                     std::uint64_t seed) {
  std::vector<std::vector<Position>> choices;
  for (const Position each : free_spawn_cells(parameters)) {
    const bool new_row = choices.empty() || (parameters.spawn.choose == SpawnChoice::row &&
                                             choices.back().front().x != each.x);
    if (new_row) choices.emplace_back();
    choices.back().push_back(each);
  }
  SplitMix64 random(seed);
  std::vector<Position> result;
  while (result.size() < agents) {
    const auto pick = [&](const auto& list) -> const auto& {
      return list[static_cast<std::size_t>(draw_below(random, static_cast<int>(list.size())))];
    };
    result.push_back(pick(pick(choices)));
  }
  return result;
}

}  // namespace

Interval spawn_cells(const CrossingParameters& parameters, int row) {
  if (band_kind(parameters, row) != BandKind::pavement) return {};
  const auto dead = parameters.spawn.dead_zones.find(row);
  const int first = dead == parameters.spawn.dead_zones.end() ? 0 : dead->second;
  return {first, parameters.length - 1};
}

std::vector<Position> free_spawn_cells(const CrossingParameters& parameters) {
  const Layout layout(parameters);
  std::vector<Position> result;
  for (const SpawnRow& row : spawn_rows(parameters)) {
    for (int y = row.cells.first; y <= row.cells.last; ++y) {
      const Position here{row.row, y};
      const RoadUser body{.place = middle(here)};
      if (layout.at(here) == Surface::pavement &&
          layout.blocked_cells(box_of(body, parameters.cell_m)).empty()) {
        result.push_back(here);
      }
    }
  }
  return result;
}

std::vector<Position> spawn(const CrossingParameters& parameters, std::size_t agents,
                            std::uint64_t seed) {
  const std::vector<SpawnRow> rows = spawn_rows(parameters);
  assert(!rows.empty() && "parameters without problems leave cells to spawn on");
  if (is_uneven(parameters)) return spawn_unevenly(parameters, agents, seed);
  int all = 0;
  for (const SpawnRow& row : rows) all += row.cells.size();

  SplitMix64 random(seed);
  std::vector<Position> result;
  result.reserve(agents);
  while (result.size() < agents) {
    if (parameters.spawn.choose == SpawnChoice::row) {
      const auto index =
          static_cast<std::size_t>(draw_below(random, static_cast<int>(rows.size())));
      const SpawnRow& row = rows[index];
      result.push_back({row.row, row.cells.first + draw_below(random, row.cells.size())});
      continue;
    }
    int cell = draw_below(random, all);
    auto row = rows.begin();
    for (; cell >= row->cells.size(); ++row) cell -= row->cells.size();
    result.push_back({row->row, row->cells.first + cell});
  }
  return result;
}

}  // namespace jaywalk
