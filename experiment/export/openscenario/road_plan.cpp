// SPDX-License-Identifier: Apache-2.0
// Bands become lanes of one straight road. A map's junctions (its letters x) cut that road, and
// what its columns begin with is a side road there, as what its rows begin with is the AV's.

#include "experiment/export/openscenario/road_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "env/crossing/layout.h"

namespace jaywalk {
namespace {

PlannedLane lane_of(char letter, double width_m) {
  const bool road = letter == '>' || letter == '<' || letter == 'x';
  const LaneType type = road            ? LaneType::driving
                        : letter == '#' ? LaneType::none
                                        : LaneType::sidewalk;
  return {.type = type, .width_m = width_m, .forward = letter != '<'};
}

void add_lane(std::vector<PlannedLane>& lanes, const PlannedLane& lane) {
  const bool same = !lanes.empty() && lanes.back().type == lane.type &&
                    (lane.type != LaneType::driving || lanes.back().forward == lane.forward);
  if (same) {
    lanes.back().width_m += lane.width_m;
  } else {
    lanes.push_back(lane);
  }
}

/// Traffic keeps to the left: the reference line runs at the right of the lanes that go its way.
std::size_t lanes_on_the_left(const std::vector<PlannedLane>& lanes) {
  for (std::size_t i = lanes.size(); i > 0; --i) {
    if (lanes[i - 1].type == LaneType::driving && lanes[i - 1].forward) return i;
  }
  return 0;
}

double width_of(const std::vector<PlannedLane>& lanes, std::size_t count) {
  double width = 0;
  for (std::size_t i = 0; i < count; ++i) width += lanes[i].width_m;
  return width;
}

bool is_road(char letter) { return letter == '>' || letter == '<' || letter == 'x'; }

class Planner {
 public:
  explicit Planner(const CrossingParameters& parameters)
      : parameters_(parameters), cell_(parameters.cell_m), grid_(grid(parameters)) {
    find_carriageway();
  }

  RoadPlan run() {
    plan_.width_m = grid_.rows * cell_;
    plan_.length_m = grid_.cells * cell_;
    // Junctions first: they cut the AV's road into pieces, to which side roads, objects and signals
    // refer.
    find_junctions();
    add_main_road();
    for (std::size_t i = 0; i < junctions_.size(); ++i) add_side_roads(i);
    for (PlannedJunction& junction : plan_.junctions) connect(junction);
    drop_dead_ends();
    add_buildings();
    add_obstacles();
    add_crosswalks();
    compare_with_map();
    return std::move(plan_);
  }

 private:
  [[nodiscard]] char letter(int row, int cell) const {
    return parameters_.map[static_cast<std::size_t>(row)][static_cast<std::size_t>(cell)];
  }
  [[nodiscard]] bool drawn() const { return !parameters_.map.empty(); }

  /// The rows from the first lane to the last.
  void find_carriageway() {
    const std::vector<Interval> rows = band_rows(parameters_);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (parameters_.bands[i].kind != BandKind::lane) continue;
      if (carriageway_.empty()) carriageway_.first = rows[i].first;
      carriageway_.last = rows[i].last;
    }
  }

  /// The cells along the road that junctions take, from the map's letters x.
  void find_junctions() {
    for (int cell = 0; drawn() && cell < grid_.cells; ++cell) {
      bool has_x = false;
      for (int row = 0; row < grid_.rows; ++row) has_x = has_x || letter(row, cell) == 'x';
      if (!has_x) continue;
      if (!junctions_.empty() && junctions_.back().last == cell - 1) {
        junctions_.back().last = cell;
      } else {
        junctions_.push_back({cell, cell});
      }
    }
    constexpr int kFirstJunction = 1001;
    for (std::size_t i = 0; i < junctions_.size(); ++i) {
      plan_.junctions.push_back({.id = kFirstJunction + static_cast<int>(i), .connections = {}});
    }
  }

  [[nodiscard]] std::vector<PlannedLane> main_lanes() const {
    std::vector<PlannedLane> lanes;
    for (int row = 0; drawn() && row < grid_.rows; ++row) {
      add_lane(lanes, lane_of(letter(row, 0), cell_));
    }
    for (std::size_t i = 0; !drawn() && i < parameters_.bands.size(); ++i) {
      const Band& band = parameters_.bands[i];
      lanes.push_back({.type = band.kind == BandKind::lane ? LaneType::driving : LaneType::sidewalk,
                       .width_m = band.rows * cell_,
                       .forward = band.direction == Direction::forward});
    }
    return lanes;
  }

  void add_main_road() {
    std::vector<PlannedLane> lanes = main_lanes();
    const std::size_t left = lanes_on_the_left(lanes);
    int begin = 0;
    for (std::size_t i = 0; i <= junctions_.size(); ++i) {
      // A junction at the very begin or end of the grid leaves no piece of road there.
      const int end = i < junctions_.size() ? junctions_[i].first : grid_.cells;
      if (end > begin) {
        PlannedRoad& road = add_road(lanes, left);
        road.x_m = width_of(lanes, left);
        road.y_m = begin * cell_;
        road.heading_rad = std::numbers::pi / 2;
        road.length_m = (end - begin) * cell_;
        if (i > 0) road.from = plan_.junctions[i - 1].id;
        if (i < junctions_.size()) road.to = plan_.junctions[i].id;
      }
      if (i < junctions_.size()) begin = junctions_[i].last + 1;
    }
    main_roads_ = plan_.roads.size();
  }

  PlannedRoad& add_road(std::vector<PlannedLane> lanes, std::size_t left) {
    PlannedRoad& road = plan_.roads.emplace_back();
    road.id = static_cast<int>(plan_.roads.size());
    road.name = road.id == 1 ? "road" : fmt::format("road {}", road.id);
    road.lanes = std::move(lanes);
    road.left = left;
    return road;
  }

  void add_side_roads(std::size_t index) {
    if (carriageway_.empty()) return;
    const Interval junction = junctions_[index];
    const int id = plan_.junctions[index].id;
    add_side_road(junction, 0, {0, carriageway_.first - 1}, std::nullopt, id);
    add_side_road(junction, grid_.rows - 1, {carriageway_.last + 1, grid_.rows - 1}, id,
                  std::nullopt);
  }

  /// The cells of a side road in the outermost row: its lanes, and its pavements where a building
  /// ends them.
  [[nodiscard]] Interval side_cells(Interval junction, int row) const {
    Interval cells{1, 0};
    for (int cell = junction.first; cell <= junction.last; ++cell) {
      if (!is_road(letter(row, cell))) continue;
      if (cells.empty()) cells.first = cell;
      cells.last = cell;
    }
    if (cells.empty()) return cells;
    const auto belongs = [&](int cell) {
      if (cell < 0 || cell >= grid_.cells) return false;
      const char here = letter(row, cell);
      return is_road(here) || (here == '.' && letter(row, 0) == '#');
    };
    while (belongs(cells.first - 1)) --cells.first;
    while (belongs(cells.last + 1)) ++cells.last;
    return cells;
  }

  void add_side_road(Interval junction, int row, Interval rows, std::optional<int> from,
                     std::optional<int> to) {
    if (rows.empty()) return;
    const Interval cells = side_cells(junction, row);
    if (cells.empty()) return;
    // It runs from the AV's left to its right, so the side ahead of the AV is its left side.
    std::vector<PlannedLane> lanes;
    for (int cell = cells.last; cell >= cells.first; --cell) {
      add_lane(lanes, lane_of(letter(row, cell), cell_));
    }
    const std::size_t left = lanes_on_the_left(lanes);
    PlannedRoad& road = add_road(lanes, left);
    road.x_m = rows.first * cell_;
    road.y_m = (cells.last + 1) * cell_ - width_of(lanes, left);
    road.length_m = rows.size() * cell_;
    road.from = from;
    road.to = to;
    side_roads_.push_back({rows, cells});
  }

  [[nodiscard]] static std::vector<LaneEnd> lane_ends(const PlannedRoad& road, bool at_end,
                                                      bool arriving) {
    std::vector<LaneEnd> ends;
    const double c = std::cos(road.heading_rad);
    const double s = std::sin(road.heading_rad);
    const double along = at_end ? road.length_m : 0;
    for (std::size_t i = 0; i < road.lanes.size(); ++i) {
      const PlannedLane& lane = road.lanes[i];
      // At its end a road's forward lanes arrive at the junction, at its begin the others.
      const bool arrives = lane.forward == at_end;
      if (lane.type != LaneType::driving || arrives != arriving) continue;
      // Metres from the reference line to the middle of the lane, to the left.
      const double t = width_of(road.lanes, road.left) - width_of(road.lanes, i) - lane.width_m / 2;
      ends.push_back({.road = road.id,
                      .lane = lane_id(road, i),
                      .at_end = at_end,
                      .x_m = road.x_m + along * c - t * s,
                      .y_m = road.y_m + along * s + t * c,
                      .heading_rad = road.heading_rad + (lane.forward ? 0 : std::numbers::pi),
                      .width_m = lane.width_m});
    }
    return ends;
  }

  /// Every lane that arrives with every lane of the other roads that leaves.
  void connect(PlannedJunction& junction) {
    std::vector<LaneEnd> arriving;
    std::vector<LaneEnd> leaving;
    for (const PlannedRoad& road : plan_.roads) {
      for (const bool at_end : {false, true}) {
        if ((at_end ? road.to : road.from) != junction.id) continue;
        std::ranges::copy(lane_ends(road, at_end, true), std::back_inserter(arriving));
        std::ranges::copy(lane_ends(road, at_end, false), std::back_inserter(leaving));
      }
    }
    constexpr int kFirstConnection = 100;
    for (const LaneEnd& from : arriving) {
      for (const LaneEnd& to : leaving) {
        // No connection leads back to the same road.
        if (from.road == to.road) continue;
        junction.connections.push_back({kFirstConnection + connections_++, from, to});
      }
    }
  }

  /// Removes junctions without any connection of lanes.
  void drop_dead_ends() {
    for (const PlannedJunction& junction : plan_.junctions) {
      if (!junction.connections.empty()) continue;
      plan_.unsaid.push_back("a junction of the map has no way through it");
      for (PlannedRoad& road : plan_.roads) {
        if (road.from == junction.id) road.from.reset();
        if (road.to == junction.id) road.to.reset();
      }
    }
    std::erase_if(plan_.junctions,
                  [](const PlannedJunction& junction) { return junction.connections.empty(); });
  }

  /// The part of the AV's road beside a cell, or the last one before it.
  PlannedRoad& main_road(int cell) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < main_roads_; ++i) {
      if (plan_.roads[i].y_m <= cell * cell_ + 1e-9) found = i;
    }
    return plan_.roads[found];
  }

  void add_object(ObjectType type, std::string name, Interval rows, Interval cells) {
    if (main_roads_ == 0) {
      plan_.unsaid.push_back(fmt::format("{} has no road to stand at", name));
      return;
    }
    main_road((cells.first + cells.last) / 2)
        .objects.push_back({type, std::move(name), rows, cells});
  }

  /// Blocked cells as rectangles: each as long as it can be, then as wide.
  void add_buildings() {
    // The cells that are not yet part of a building; covered cells become blank.
    std::vector<std::string> left = parameters_.map;
    int count = 0;
    const auto blocked = [&](int row, int cell) {
      return left[static_cast<std::size_t>(row)][static_cast<std::size_t>(cell)] == '#';
    };
    for (int row = 0; drawn() && row < grid_.rows; ++row) {
      for (int cell = 0; cell < grid_.cells; ++cell) {
        if (!blocked(row, cell)) continue;
        Interval cells{cell, cell};
        while (cells.last + 1 < grid_.cells && blocked(row, cells.last + 1)) ++cells.last;
        Interval rows{row, row};
        const auto whole = [&](int next) {
          for (int y = cells.first; y <= cells.last; ++y) {
            if (!blocked(next, y)) return false;
          }
          return true;
        };
        while (rows.last + 1 < grid_.rows && whole(rows.last + 1)) ++rows.last;
        for (int x = rows.first; x <= rows.last; ++x) {
          for (int y = cells.first; y <= cells.last; ++y) {
            left[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] = ' ';
          }
        }
        add_object(ObjectType::building, fmt::format("building{}", ++count), rows, cells);
      }
    }
  }

  void add_obstacles() {
    for (std::size_t i = 0; i < parameters_.obstacles.size(); ++i) {
      const Obstacle& each = parameters_.obstacles[i];
      add_object(ObjectType::obstacle, fmt::format("obstacle{}", i + 1), each.rows, each.cells);
    }
  }

  void add_crosswalks() {
    for (std::size_t i = 0; i < parameters_.crosswalks.size(); ++i) {
      const Crosswalk& each = parameters_.crosswalks[i];
      const std::string name = fmt::format("crosswalk{}", i + 1);
      if (carriageway_.empty()) {
        plan_.unsaid.push_back(fmt::format("{} has no lane to cross", name));
        continue;
      }
      add_object(ObjectType::crosswalk, name, carriageway_, each.cells);
      if (each.kind == CrosswalkKind::signalled) add_signals(i, each);
    }
  }

  void add_signals(std::size_t crosswalk, const Crosswalk& at) {
    SignalGroup group{.id = static_cast<int>(crosswalk) + 1,
                      .name = fmt::format("signal{}", crosswalk + 1),
                      .signals = {}};
    for (const ActorParameters& actor : parameters_.actors) {
      const bool own = actor.kind == ActorKind::signal && actor.crosswalk == crosswalk;
      if (own) group.name = actor.name;
    }
    PlannedRoad& road = main_road(at.cells.first);
    for (const bool forward : {true, false}) {
      const bool driven = std::ranges::any_of(road.lanes, [&](const PlannedLane& lane) {
        return lane.type == LaneType::driving && lane.forward == forward;
      });
      if (!driven) continue;
      // At the left side of the oncoming traffic, as it keeps left.
      const int edge_row = forward ? carriageway_.first : carriageway_.last + 1;
      const int edge_cell = forward ? at.cells.first : at.cells.last + 1;
      // Odd for the traffic that goes the AV's way, even for the other, so that ids are unique.
      const int id = 2 * group.id - (forward ? 1 : 0);
      const double s = std::clamp(edge_cell * cell_ - road.y_m, 0.0, road.length_m);
      road.signals.push_back({id, group.name, s, road.x_m - edge_row * cell_, forward});
      group.signals.push_back(id);
    }
    plan_.signals.push_back(std::move(group));
  }

  [[nodiscard]] bool is_covered(int row, int cell) const {
    if (carriageway_.contains(row)) return true;
    return std::ranges::any_of(side_roads_, [&](const SideRoad& side) {
      const int outermost = side.rows.first == 0 ? 0 : grid_.rows - 1;
      return side.rows.contains(row) && side.cells.contains(cell) &&
             is_road(letter(outermost, cell));
    });
  }

  /// Notes cells that are road in the map but not in the plan, or the other way round.
  void compare_with_map() {
    int missing = 0;
    int added = 0;
    std::string first;
    for (int row = 0; drawn() && row < grid_.rows; ++row) {
      for (int cell = 0; cell < grid_.cells; ++cell) {
        const char here = letter(row, cell);
        // Buildings are objects, whatever lies under them.
        if (here == '#' || is_road(here) == is_covered(row, cell)) continue;
        if (first.empty()) first = fmt::format("row {}, cell {}", row, cell);
        ++(is_road(here) ? missing : added);
      }
    }
    if (missing + added == 0) return;
    plan_.unsaid.push_back(fmt::format(
        "the map's roads are not straight bands: {} cells of road are left out and {} cells of "
        "pavement become road, the first in {}",
        missing, added, first));
  }

  struct SideRoad {
    Interval rows;
    Interval cells;
  };

  const CrossingParameters& parameters_;
  double cell_;
  Grid grid_;
  Interval carriageway_{1, 0};
  std::vector<Interval> junctions_;
  std::vector<SideRoad> side_roads_;
  std::size_t main_roads_ = 0;
  int connections_ = 0;
  RoadPlan plan_;
};

}  // namespace

int lane_id(const PlannedRoad& road, std::size_t lane) {
  const auto left = static_cast<int>(road.left);
  const auto index = static_cast<int>(lane);
  // OpenDRIVE counts from the reference line: to the left 1, 2, …, to the right -1, -2, …; there is
  // no 0.
  return index < left ? left - index : left - index - 1;
}

RoadPlan plan_roads(const CrossingParameters& parameters) { return Planner(parameters).run(); }

}  // namespace jaywalk
