// SPDX-License-Identifier: Apache-2.0
#include "env/crossing/parameters.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "env/crossing/road_user.h"
#include "env/crossing/spawn.h"
#include "env/vehicle/vehicle_section.h"

namespace jaywalk {
namespace {

// Keeps a whole number that came out a little less (0.1 · 3 / 0.3) from being rounded away.
constexpr double kRounding = 1e-9;
// Beyond any grid, and small enough to be added up.
constexpr double kFar = 1e9;

int to_cell(double whole) { return static_cast<int>(std::clamp(whole, -kFar, kFar)); }
int floor_to_cell(double value) { return to_cell(std::floor(value + kRounding)); }
int ceil_to_cell(double value) { return to_cell(std::ceil(value - kRounding)); }

void check_av(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const AvParameters& av = parameters.av;
  const int rows = grid(parameters).rows;
  if (av.rows.empty() || av.rows.first < 0 || av.rows.last >= rows) {
    found.push_back({"world.av.rows", fmt::format("rows {} to {} are not within the grid's 0 to {}",
                                                  av.rows.first, av.rows.last, rows - 1)});
  } else if (parameters.zone.rows == ZoneRows::lane && av_lane(parameters).empty()) {
    found.push_back(
        {"world.zone.rows", fmt::format("row {} of the AV lies in no lane that the zone "
                                        "could cover",
                                        av.rows.first)});
  }
  if (zone_origin(parameters, 0) >= parameters.road_end) {
    found.push_back(
        {"world.road_end",
         fmt::format("the AV has passed cell {} before the first tick", parameters.road_end)});
  }
}

// Refuses keys that a simulator makes meaningless, since the world does not drive the AV then.
void check_simulator(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const AvParameters& av = parameters.av;
  if (parameters.simulator.name.empty()) return;
  const auto refuse = [&](std::string_view key) {
    found.push_back({fmt::format("world.av.{}", key),
                     fmt::format("the simulator '{}' drives the AV, so that '{}' has no meaning",
                                 parameters.simulator.name, key)});
  };
  if (av.vehicle.model != "constant") refuse("model");
  if (!av.vehicle.defects.empty()) refuse("defect");
  if (av.twin) refuse("twin");
  if (av.carry_over) refuse("carry_over");
}

void check_zone(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const ZoneParameters& zone = parameters.zone;
  const int rows = grid(parameters).rows;
  const Interval given = zone.given_rows;
  if (zone.rows == ZoneRows::given && (given.empty() || given.first < 0 || given.last >= rows)) {
    found.push_back(
        {"world.zone.rows", fmt::format("rows {} to {} are not within the grid's 0 to {}",
                                        given.first, given.last, rows - 1)});
  }
  const Interval ahead = zone_ahead(parameters);
  if (ahead.empty()) {
    found.push_back({zone.ahead ? "world.zone.ahead" : "world.zone.ttc",
                     fmt::format("no cell lies in the zone: its first is {}, its last {} ahead",
                                 ahead.first, ahead.last)});
  }
}

void check_spawn(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const Grid bounds = grid(parameters);
  int cells = 0;
  for (const auto& [row, count] : parameters.spawn.dead_zones) {
    if (row < 0 || row >= bounds.rows || band_kind(parameters, row) != BandKind::pavement) {
      found.push_back({"world.spawn.dead_zones",
                       fmt::format("row {} is not a row of a pavement, where agents spawn", row)});
    }
  }
  for (int row = 0; row < bounds.rows; ++row) {
    if (band_kind(parameters, row) != BandKind::pavement) continue;
    const auto dead = parameters.spawn.dead_zones.find(row);
    const int first = dead == parameters.spawn.dead_zones.end() ? 0 : dead->second;
    cells += first < bounds.cells ? bounds.cells - first : 0;
  }
  if (cells == 0 || (found.empty() && free_spawn_cells(parameters).empty())) {
    found.push_back({"world.spawn.dead_zones", "no cell of a pavement is left to spawn on"});
  }
}

void check_obstacles(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const Grid bounds = grid(parameters);
  const auto inside = [](Interval all, Interval part) {
    return !part.empty() && part.first >= all.first && part.last <= all.last;
  };
  for (const Obstacle& each : parameters.obstacles) {
    if (!inside({0, bounds.rows - 1}, each.rows) || !inside({0, bounds.cells - 1}, each.cells)) {
      found.push_back(
          {"world.obstacles",
           fmt::format("an obstacle on rows {} to {}, cells {} to {} is not on the grid "
                       "of {} rows and {} cells",
                       each.rows.first, each.rows.last, each.cells.first, each.cells.last,
                       bounds.rows, bounds.cells)});
    }
  }
  for (const Crosswalk& each : parameters.crosswalks) {
    if (inside({0, bounds.cells - 1}, each.cells)) continue;
    found.push_back({"world.crosswalks",
                     fmt::format("a crosswalk on cells {} to {} is not on the grid of {} cells",
                                 each.cells.first, each.cells.last, bounds.cells)});
  }
}

void check_way(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const Layout layout(parameters);
  for (int y = std::max(parameters.av.start, 0); y < layout.grid().cells; ++y) {
    for (int row = parameters.av.rows.first; row <= parameters.av.rows.last; ++row) {
      if (layout.is_free({row, y})) continue;
      found.push_back({parameters.map.empty() ? "world.obstacles" : "world.map",
                       fmt::format("the AV's way is blocked in row {}, cell {}", row, y)});
      return;
    }
  }
}

void check_actors(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  const Layout layout(parameters);
  for (const ActorParameters& actor : parameters.actors) {
    if (actor.kind == ActorKind::signal) {
      const bool fits = actor.crosswalk < parameters.crosswalks.size() &&
                        parameters.crosswalks[actor.crosswalk].kind == CrosswalkKind::signalled;
      if (fits) continue;
      found.push_back({"world.actors",
                       fmt::format("the signal '{}' belongs to crosswalk {}, which is no signalled "
                                   "one of the {}",
                                   actor.name, actor.crosswalk + 1, parameters.crosswalks.size())});
    } else if (!layout.is_free(actor.start)) {
      found.push_back(
          {"world.actors",
           fmt::format("'{}' cannot start in row {}, cell {}: that is blocked or not on "
                       "the grid",
                       actor.name, actor.start.x, actor.start.y)});
    } else if (const RoadUser body{
                   .kind = actor.kind, .place = middle(actor.start), .facing = actor.way};
               !layout.blocked_cells(box_of(body, parameters.cell_m)).empty()) {
      found.push_back({"world.actors",
                       fmt::format("'{}' cannot start in row {}, cell {}: its body reaches into "
                                   "a blocked cell",
                                   actor.name, actor.start.x, actor.start.y)});
    }
  }
}

// Carrying over needs whole cells per tick, and a zone that is exactly the AV's drive of a tick.
void check_carry_over(const CrossingParameters& parameters, std::vector<ParameterProblem>& found) {
  if (!parameters.av.carry_over || !parameters.simulator.name.empty()) return;
  const double speed = parameters.av.speed;
  const auto refuse = [&](std::string message) {
    found.push_back({"world.av.carry_over", std::move(message)});
  };
  if (parameters.av.vehicle.model != "constant" || speed != std::floor(speed)) {
    refuse("only an AV that keeps a speed of whole cells per tick can carry cells over");
  } else if (zone_ahead(parameters) != Interval{1, static_cast<int>(speed)}) {
    refuse("the zone has to be the cells that the AV drives in a tick");
  } else if (parameters.end != TestEnd::precondition || parameters.aftermath > 0 ||
             parameters.time_limit_s > 0) {
    refuse("a test has to end with the precondition or the road, without aftermath or time limit");
  } else if (zone_origin(parameters, 1) > parameters.road_end) {
    refuse(fmt::format("the AV passes cell {} within the first tick", parameters.road_end));
  }
}

}  // namespace

bool is_steady(const CrossingParameters& parameters) {
  return parameters.av.vehicle.model == "constant" && parameters.simulator.name.empty();
}

Grid grid(const CrossingParameters& parameters) {
  int rows = 0;
  for (const Band& band : parameters.bands) rows += band.rows;
  return {rows, parameters.length};
}

std::vector<Interval> band_rows(const CrossingParameters& parameters) {
  std::vector<Interval> result;
  int first = 0;
  for (const Band& band : parameters.bands) {
    result.push_back({first, first + band.rows - 1});
    first += band.rows;
  }
  return result;
}

BandKind band_kind(const CrossingParameters& parameters, int row) {
  for (const Band& band : parameters.bands) {
    if (row < band.rows) return band.kind;
    row -= band.rows;
  }
  assert(false && "the row lies on the grid");
  return BandKind::pavement;
}

Interval av_lane(const CrossingParameters& parameters) {
  const std::vector<Interval> rows = band_rows(parameters);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (parameters.bands[i].kind == BandKind::lane && rows[i].contains(parameters.av.rows.first)) {
      return rows[i];
    }
  }
  return {};
}

Interval zone_rows(const CrossingParameters& parameters) {
  switch (parameters.zone.rows) {
    case ZoneRows::lane:
      return av_lane(parameters);
    case ZoneRows::av:
      return parameters.av.rows;
    case ZoneRows::given:
      return parameters.zone.given_rows;
  }
  return {};
}

Interval zone_ahead(const CrossingParameters& parameters) {
  return zone_ahead(parameters, parameters.av.speed);
}

Interval zone_ahead(const CrossingParameters& parameters, double speed) {
  const ZoneParameters& zone = parameters.zone;
  if (zone.ahead) return *zone.ahead;
  if (speed <= 0) return {1, 0};
  // The middle of the k-th cell ahead is reached after (k - 1/2) / speed.
  const double cells_per_second = speed / parameters.tick_s;
  return {ceil_to_cell(zone.ttc.from * cells_per_second + 0.5),
          floor_to_cell(zone.ttc.to * cells_per_second + 0.5)};
}

int zone_origin(const CrossingParameters& parameters, int ticks) {
  return zone_origin_at(parameters, parameters.av.speed * ticks);
}

int zone_origin_at(const CrossingParameters& parameters, double driven) {
  const AvParameters& av = parameters.av;
  const int ahead =
      parameters.zone.origin == ZoneOrigin::stopping_distance ? av.stopping_distance : 0;
  return av.start + ahead + floor_to_cell(driven);
}

int max_ticks(const CrossingParameters& parameters) {
  const auto ticks = [](double value) {
    return static_cast<int>(std::clamp(std::ceil(value - kRounding), 1.0, kFar));
  };
  if (parameters.time_limit_s > 0) return ticks(parameters.time_limit_s / parameters.tick_s);
  if (is_steady(parameters)) return 0;
  return ticks(10 * (parameters.road_end - parameters.av.start) / parameters.av.speed);
}

std::vector<ParameterProblem> problems(const CrossingParameters& parameters) {
  std::vector<ParameterProblem> found;
  check_av(parameters, found);
  check_simulator(parameters, found);
  if (parameters.simulator.name.empty()) {
    check_defects(parameters.av.vehicle, parameters.av.twin, found);
  }
  check_zone(parameters, found);
  check_carry_over(parameters, found);
  check_spawn(parameters, found);
  check_obstacles(parameters, found);
  if (!found.empty()) return found;
  check_way(parameters, found);
  check_actors(parameters, found);
  return found;
}

}  // namespace jaywalk
