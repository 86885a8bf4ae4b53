#include "env/crossing/spawn.h"

#include <cassert>

#include "env/grid/random.h"

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

int draw_below(SplitMix64& random, int bound) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(bound)));
}

}  // namespace

Interval spawn_cells(const CrossingParameters& parameters, int row) {
  if (band_kind(parameters, row) != BandKind::pavement) return {};
  const auto dead = parameters.spawn.dead_zones.find(row);
  const int first = dead == parameters.spawn.dead_zones.end() ? 0 : dead->second;
  return {first, parameters.length - 1};
}

std::vector<Position> spawn(const CrossingParameters& parameters, std::size_t agents,
                            std::uint64_t seed) {
  const std::vector<SpawnRow> rows = spawn_rows(parameters);
  assert(!rows.empty() && "parameters without problems leave cells to spawn on");
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
