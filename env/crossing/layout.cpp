#include "env/crossing/layout.h"

#include <algorithm>
#include <array>
#include <cmath>

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

}  // namespace jaywalk
