#pragma once

// Everything about the crossing world that is a number or a choice. The defaults are the case
// study's, the preset `paper`. Rows count from the left of the automated vehicle (AV), cells along
// its way; one tick is the time of a pedestrian's step. Read ../grid/grid.h before.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "env/grid/grid.h"

namespace jaywalk {

/// The side of the box that stands for a pedestrian in scenes, in metres.
inline constexpr double kPedestrianSizeM = 0.5;

enum class BandKind { pavement, lane };

/// A strip along the road: some rows of one kind.
struct Band {
  BandKind kind = BandKind::pavement;
  int rows = 1;
  /// Which way traffic goes in a lane, forward or back; of no meaning for a pavement.
  Direction direction = Direction::forward;
};

struct AvParameters {
  /// Length in cells, and the rows that its body covers.
  int length = 3;
  Interval rows{3, 4};
  /// Cells per tick; constant, the AV never brakes. Where it is not whole, positions are rounded
  /// down to cells.
  double speed = 6;
  /// The cell of the leading edge before the first tick; may lie before the grid.
  int start = 0;
  /// Cells that it would take to stop; matters only to a zone measured from there.
  int stopping_distance = 0;
};

/// Which rows the precondition zone covers: those of the AV's lane, of its body, or given ones.
enum class ZoneRows { lane, av, given };
/// Where the zone's cells are counted from.
enum class ZoneOrigin { leading_edge, stopping_distance };

struct Seconds {
  double from = 0;
  double to = 1;
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
};

/// Spawning: a row first, each equally probable, then one of its cells; or one of all cells.
enum class SpawnChoice { row, cell };

struct SpawnParameters {
  SpawnChoice choose = SpawnChoice::row;
  /// For each pavement row how many of its first cells are left out, since no pedestrian could
  /// reach the AV's way from there in time. Rows that are not listed have none.
  std::map<int, int> dead_zones{{0, 18}, {1, 12}, {10, 36}, {11, 54}};
};

/// On the road, its cost takes the place of the pavement's or comes on top of it.
enum class RoadCost { replace, add };
/// Who gets the reward: the agents in the first cell that the AV's sweep meets, or all in the zone.
enum class Rewarded { first_hit, zone };

struct ScoringParameters {
  double pavement_cost = 1;  // per agent and tick
  double road_cost = 5;      // per agent and tick
  RoadCost costs = RoadCost::replace;
  double reward = 100;
  Rewarded rewarded = Rewarded::first_hit;
};

struct CrossingParameters {
  /// From the AV's left to its right.
  std::vector<Band> bands{{BandKind::pavement, 2},
                          {BandKind::lane, 4, Direction::forward},
                          {BandKind::lane, 4, Direction::back},
                          {BandKind::pavement, 2}};
  /// The length of the road in cells.
  int length = 66;
  double cell_m = 1.5;
  double tick_s = 1;
  AvParameters av;
  ZoneParameters zone;
  /// A test has failed when the zone's origin has come to this cell; it is the last one tested.
  int road_end = 65;
  /// For how many ticks a test goes on after the precondition was met, so that agents can perceive
  /// it. Nothing is scored any more.
  int aftermath = 0;
  SpawnParameters spawn;
  ScoringParameters scoring;
};

[[nodiscard]] Grid grid(const CrossingParameters& parameters);
/// The rows of each band, in the same order.
[[nodiscard]] std::vector<Interval> band_rows(const CrossingParameters& parameters);
/// The kind of the band that a row belongs to. REQUIRES: the row is on the grid.
[[nodiscard]] BandKind band_kind(const CrossingParameters& parameters, int row);
/// The rows of the lane in which the AV's first row lies; empty if it drives outside the lanes.
[[nodiscard]] Interval av_lane(const CrossingParameters& parameters);
[[nodiscard]] Interval zone_rows(const CrossingParameters& parameters);
/// The zone's first and last cell ahead of its origin.
[[nodiscard]] Interval zone_ahead(const CrossingParameters& parameters);
/// The cell of the zone's origin after so many ticks.
[[nodiscard]] int zone_origin(const CrossingParameters& parameters, int ticks);

/// What does not fit together. `path` names the parameter as scenarios spell it, `world.av.rows`.
struct ParameterProblem {
  std::string path;
  std::string message;
};

[[nodiscard]] std::vector<ParameterProblem> problems(const CrossingParameters& parameters);

}  // namespace jaywalk
