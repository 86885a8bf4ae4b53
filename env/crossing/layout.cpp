#include "env/crossing/layout.h"

#include <algorithm>
#include <array>

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

Layout::Layout(const CrossingParameters& parameters) : grid_(jaywalk::grid(parameters)) {
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
}

}  // namespace jaywalk
