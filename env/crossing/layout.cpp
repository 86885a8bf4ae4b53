// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "env/crossing/parameters.h"

namespace jaywalk {
namespace {

struct SurfaceLetter {
  char letter;
  Surface ground;
};

constexpr std::array kLetters{SurfaceLetter{'.', Surface::pavement},
                              SurfaceLetter{'>', Surface::lane}, SurfaceLetter{'<', Surface::lane},
                              SurfaceLetter{'x', Surface::lane},
                              SurfaceLetter{'#', Surface::blocked}};

Interval clipped(Interval cells, int count) {
  return {std::max(cells.first, 0), std::min(cells.last, count - 1)};
}

AreaKind kind_of(Surface surface) {
  return surface == Surface::lane || surface == Surface::crosswalk ? AreaKind::lane
                                                                   : AreaKind::pavement;
}

Rectangle rectangle(Interval rows, Interval cells, double cell_m) {
  return {rows.first * cell_m, (rows.last + 1) * cell_m, cells.first * cell_m,
          (cells.last + 1) * cell_m};
}

Area area(AreaKind kind, Interval rows, Interval cells, double cell_m) {
  const Rectangle box = rectangle(rows, cells, cell_m);
  return {
      .kind = kind,
      .corners = {
          {box.left, box.near}, {box.right, box.near}, {box.right, box.far}, {box.left, box.far}}};
}

Ground ground_of_bands(const CrossingParameters& parameters) {
  const std::vector<Interval> rows = band_rows(parameters);
  Ground result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool lane = parameters.bands[i].kind == BandKind::lane;
    result.areas.push_back(area(lane ? AreaKind::lane : AreaKind::pavement, rows[i],
                                {0, parameters.length - 1}, parameters.cell_m));
    result.areas.back().of_av = lane && rows[i].contains(parameters.av.rows.first);
  }
  return result;
}

/// The stretches of each row that are of one kind, and the AV's lane, or else where its body
/// drives.
Ground ground_of_map(const CrossingParameters& parameters) {
  const Layout layout(parameters);
  const Grid grid = layout.grid();
  Ground result;
  for (int row = 0; row < grid.rows; ++row) {
    for (int first = 0; first < grid.cells;) {
      const AreaKind kind = kind_of(layout.at({row, first}));
      int end = first + 1;
      while (end < grid.cells && kind_of(layout.at({row, end})) == kind) ++end;
      result.areas.push_back(area(kind, {row, row}, {first, end - 1}, parameters.cell_m));
      first = end;
    }
  }
  const Interval lane = av_lane(parameters);
  result.areas.push_back(area(AreaKind::lane, lane.empty() ? parameters.av.rows : lane,
                              {0, grid.cells - 1}, parameters.cell_m));
  result.areas.back().of_av = true;
  return result;
}

GroundCrosswalk ground_crosswalk(const CrossingParameters& parameters, const Layout& layout,
                                 std::size_t index) {
  const Crosswalk& crosswalk = parameters.crosswalks[index];
  GroundCrosswalk result{.zebra = crosswalk.kind == CrosswalkKind::zebra,
                         .parts = {},
                         .begins_m = crosswalk.cells.first * parameters.cell_m,
                         .signals = {}};
  for (int row = 0; row < layout.grid().rows; ++row) {
    for (int cell = crosswalk.cells.first; cell <= crosswalk.cells.last; ++cell) {
      if (layout.at({row, cell}) != Surface::crosswalk) continue;
      result.parts.push_back(rectangle({row, row}, {cell, cell}, parameters.cell_m));
    }
  }
  for (const ActorParameters& actor : parameters.actors) {
    if (actor.kind == ActorKind::signal && actor.crosswalk == index) {
      result.signals.push_back(actor.name);
    }
  }
  return result;
}

}  // namespace

std::optional<Surface> find_surface(char letter) {
  const auto found = std::ranges::find(kLetters, letter, &SurfaceLetter::letter);
  if (found == kLetters.end()) return std::nullopt;
  return found->ground;
}

Layout::Layout(const CrossingParameters& parameters)
    : grid_(jaywalk::grid(parameters)), cell_m_(parameters.cell_m) {
  const bool drawn = !parameters.map.empty();
  for (int row = 0; !drawn && row < grid_.rows; ++row) {
    rows_.push_back(band_kind(parameters, row) == BandKind::pavement ? Surface::pavement
                                                                     : Surface::lane);
  }
  if (!drawn && parameters.crosswalks.empty() && parameters.obstacles.empty()) return;

  for (int row = 0; row < grid_.rows; ++row) {
    for (int y = 0; y < grid_.cells; ++y) {
      const auto r = static_cast<std::size_t>(row);
      cells_.push_back(drawn ? find_surface(parameters.map[r][static_cast<std::size_t>(y)])
                                   .value_or(Surface::blocked)
                             : rows_[r]);
    }
  }
  const auto at = [&](int row, int y) -> Surface& {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.cells) +
                  static_cast<std::size_t>(y)];
  };
  for (const Crosswalk& crosswalk : parameters.crosswalks) {
    const Interval cells = clipped(crosswalk.cells, grid_.cells);
    for (int row = 0; row < grid_.rows; ++row) {
      for (int y = cells.first; y <= cells.last; ++y) {
        if (at(row, y) == Surface::lane) at(row, y) = Surface::crosswalk;
      }
    }
  }
  for (const Obstacle& obstacle : parameters.obstacles) {
    const Interval rows = clipped(obstacle.rows, grid_.rows);
    const Interval cells = clipped(obstacle.cells, grid_.cells);
    for (int row = rows.first; row <= rows.last; ++row) {
      for (int y = cells.first; y <= cells.last; ++y) at(row, y) = Surface::blocked;
    }
  }
  has_blocked_cells_ = std::ranges::find(cells_, Surface::blocked) != cells_.end();
}

std::vector<Position> Layout::blocked_cells(const Rectangle& area) const {
  std::vector<Position> result;
  if (!has_blocked_cells_) return result;
  const auto cells = [&](double from, double to, int count) {
    // Places are rounded, so that bodies that touch may overlap a little.
    constexpr double kTouching = 1e-6;
    return clipped({static_cast<int>(std::floor(from / cell_m_ + kTouching)),
                    static_cast<int>(std::ceil(to / cell_m_ - kTouching)) - 1},
                   count);
  };
  const Interval rows = cells(area.left, area.right, grid_.rows);
  const Interval along = cells(area.near, area.far, grid_.cells);
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int y = along.first; y <= along.last; ++y) {
      if (at({row, y}) == Surface::blocked) result.push_back({row, y});
    }
  }
  return result;
}

Ground ground(const CrossingParameters& parameters) {
  Ground result = parameters.map.empty() ? ground_of_bands(parameters) : ground_of_map(parameters);
  result.obstacles = obstacles(parameters);
  const Layout layout(parameters);
  for (std::size_t i = 0; i < parameters.crosswalks.size(); ++i) {
    result.crosswalks.push_back(ground_crosswalk(parameters, layout, i));
  }
  result.moves_evenly = !parameters.simulator.name.empty();
  result.cruise_mps = parameters.av.speed * parameters.cell_m / parameters.tick_s;
  return result;
}

std::vector<Rectangle> obstacles(const CrossingParameters& parameters) {
  std::vector<Rectangle> result;
  for (const Obstacle& each : parameters.obstacles) {
    result.push_back(rectangle(each.rows, each.cells, parameters.cell_m));
  }
  return result;
}

}  // namespace jaywalk
