// SPDX-License-Identifier: Apache-2.0
#pragma once

// Everything about the crossing world that is a number or a choice. The defaults are the case
// study's, the preset `paper`. Rows count from the far left as the automated vehicle (AV) drives,
// cells along its way; one tick is the time of a pedestrian's step. Read ../grid/grid.h first.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "env/config/reader.h"
#include "env/grid/grid.h"
#include "env/scene.h"
#include "env/simulator/parameters.h"
#include "env/vehicle/vehicle.h"

namespace jaywalk {

enum class BandKind { pavement, lane };

/// A strip along the road: some rows of one kind.
struct Band {
  BandKind kind = BandKind::pavement;
  int rows = 1;
  /// Which way traffic goes in a lane, forward or back; of no meaning for a pavement.
  Direction direction = Direction::forward;

  friend bool operator==(const Band&, const Band&) = default;
};

struct AvParameters {
  /// Length in cells, and the rows that its body covers.
  int length = 3;
  Interval rows{3, 4};
  /// The cruising speed in cells per tick, which the AV keeps unless its model brakes. If its
  /// position is not a whole number, the AV's cell is the position rounded down.
  double speed = 6;
  /// How it drives.
  VehicleParameters vehicle;
  /// How a custom controller would drive if it were healthy; not needed where the vehicle's defects
  /// say what to leave out. Sensors and period are those of `vehicle`
  /// (env/vehicle/vehicle_section.h).
  std::optional<VehicleParameters> twin;
  /// The cell of the leading edge before the first tick; may lie before the grid.
  int start = 0;
  /// Cells that it would take to stop; matters only to a zone measured from there.
  int stopping_distance = 0;
  /// Whether the cells that the AV had left to drive in the tick that ended a test become its head
  /// start in the next test, as in the program that the paper's figures come from. Each test then
  /// depends on the one before it.
  bool carry_over = false;

  friend bool operator==(const AvParameters&, const AvParameters&) = default;
};

/// Which rows the precondition zone covers: those of the AV's lane, of its body, or given ones.
enum class ZoneRows { lane, av, given };
/// Where the zone's cells are counted from.
enum class ZoneOrigin { leading_edge, stopping_distance };

struct Seconds {
  double from = 0;
  double to = 1;

  friend bool operator==(const Seconds&, const Seconds&) = default;
};

/// The precondition of the assertion under test: a pedestrian in a zone in front of the AV.
struct ZoneParameters {
  ZoneRows rows = ZoneRows::lane;
  Interval given_rows;  // of ZoneRows::given
  ZoneOrigin origin = ZoneOrigin::leading_edge;
  /// The window of times to collision (TTC) that it covers: the cells whose middle the AV reaches
  /// within that time. Used unless `ahead` is given.
  Seconds ttc;
  /// The first and last cell ahead of the origin.
  std::optional<Interval> ahead;

  friend bool operator==(const ZoneParameters&, const ZoneParameters&) = default;
};

/// Spawning: a row first, each equally probable, then one of its cells; or one of all cells.
enum class SpawnChoice { row, cell };

struct SpawnParameters {
  SpawnChoice choose = SpawnChoice::row;
  /// For each pavement row how many of its first cells are left out, since no pedestrian could
  /// reach the AV's way from there in time. Rows that are not listed have none.
  std::map<int, int> dead_zones{{0, 18}, {1, 12}, {10, 36}, {11, 54}};

  friend bool operator==(const SpawnParameters&, const SpawnParameters&) = default;
};

/// How the road's cost combines with the pavement's: it replaces it, or is added to it.
enum class RoadCost { replace, add };
/// Which agents get the reward: those in the first cell that the AV's sweep meets, or all in the
/// zone.
enum class Rewarded { first_hit, zone };

struct ScoringParameters {
  double pavement_cost = 1;  // per agent and tick
  double road_cost = 5;      // per agent and tick
  RoadCost costs = RoadCost::replace;
  double reward = 100;
  Rewarded rewarded = Rewarded::first_hit;

  friend bool operator==(const ScoringParameters&, const ScoringParameters&) = default;
};

struct PedestrianParameters {
  /// Cells that a step leads, that is, the greatest speed in cells per tick; steps may be shorter.
  double speed = 1;
  /// Other road users no further away than this, in cells, are perceived; 0: none are.
  double sight = 0;
  /// Whether they perceive the ground around them (`ground(Way,Kind)` and its kin): features that
  /// do not grow with the map.
  bool features = false;

  friend bool operator==(const PedestrianParameters&, const PedestrianParameters&) = default;
};

/// A zebra or a signalled crossing: these cells along the road, over all its lanes.
enum class CrosswalkKind { zebra, signalled };
struct Crosswalk {
  CrosswalkKind kind = CrosswalkKind::zebra;
  Interval cells;

  friend bool operator==(const Crosswalk&, const Crosswalk&) = default;
};

/// A parked car, a kiosk: its cells are blocked, and bodies behind it are hidden from the AV.
struct Obstacle {
  Interval rows;
  Interval cells;

  friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// A road user other than the AV and the pedestrians, or a traffic signal. It is an agent, too.
struct ActorParameters {
  std::string name;
  ActorKind kind = ActorKind::cyclist;
  /// Where its middle is at the beginning; a signal's is without meaning.
  Position start;
  Direction way = Direction::forward;
  /// Cells per tick at most.
  double speed = 3;
  /// Which crosswalk a signal belongs to, counted from 0.
  std::size_t crosswalk = 0;

  friend bool operator==(const ActorParameters&, const ActorParameters&) = default;
};

/// What ends a test before the road does.
enum class TestEnd { precondition, collision, road };

struct CrossingParameters {
  /// From the AV's left to its right.
  std::vector<Band> bands{{BandKind::pavement, 2},
                          {BandKind::lane, 4, Direction::forward},
                          {BandKind::lane, 4, Direction::back},
                          {BandKind::pavement, 2}};
  /// The length of the road in cells.
  int length = 66;
  /// Instead of bands and length: a line for each row, a letter for each cell (layout.h).
  std::vector<std::string> map;
  std::vector<Crosswalk> crosswalks;
  std::vector<Obstacle> obstacles;
  std::vector<ActorParameters> actors;
  PedestrianParameters pedestrians;
  /// The simulator that moves the AV and other traffic; without a name the world moves the AV.
  SimulatorParameters simulator;
  double cell_m = 1.5;
  double tick_s = 1;
  AvParameters av;
  ZoneParameters zone;
  /// A test ends, its precondition not met, when the zone's origin comes to this cell; it is the
  /// last one tested.
  int road_end = 65;
  /// For how many ticks a test goes on after the precondition was met, so that agents can perceive
  /// it. Nothing is scored any more.
  int aftermath = 0;
  TestEnd end = TestEnd::precondition;
  /// Seconds after which a test ends in any case; 0: ten times the time for the road at full speed
  /// if the AV can brake, else no limit.
  double time_limit_s = 0;
  SpawnParameters spawn;
  ScoringParameters scoring;

  friend bool operator==(const CrossingParameters&, const CrossingParameters&) = default;
};

/// Whether the AV keeps its speed whatever is in its way: no model brakes, no simulator drives.
[[nodiscard]] bool is_steady(const CrossingParameters& parameters);
[[nodiscard]] Grid grid(const CrossingParameters& parameters);
/// The rows of each band, in the same order.
[[nodiscard]] std::vector<Interval> band_rows(const CrossingParameters& parameters);
/// The kind of the band that a row belongs to; of a map, what its row begins with.
/// REQUIRES: the row is on the grid.
[[nodiscard]] BandKind band_kind(const CrossingParameters& parameters, int row);
/// The ticks after which a test ends in any case; 0: no limit.
[[nodiscard]] int max_ticks(const CrossingParameters& parameters);
/// The rows of the lane in which the AV's first row lies; empty if it drives outside the lanes.
[[nodiscard]] Interval av_lane(const CrossingParameters& parameters);
[[nodiscard]] Interval zone_rows(const CrossingParameters& parameters);
/// The zone's first and last cell ahead of its origin, at the cruising speed or at another one (in
/// cells per tick).
[[nodiscard]] Interval zone_ahead(const CrossingParameters& parameters);
[[nodiscard]] Interval zone_ahead(const CrossingParameters& parameters, double speed);
/// The cell of the zone's origin after `ticks` ticks at the cruising speed.
[[nodiscard]] int zone_origin(const CrossingParameters& parameters, int ticks);
/// The cell of the zone's origin when the AV's leading edge is `driven` cells ahead of its start.
[[nodiscard]] int zone_origin_at(const CrossingParameters& parameters, double driven);

/// The values that do not fit together.
[[nodiscard]] std::vector<ParameterProblem> problems(const CrossingParameters& parameters);

}  // namespace jaywalk
