// SPDX-License-Identifier: Apache-2.0
#pragma once

// The ground of a crossing world as roads, junctions, objects and signals, as OpenDRIVE has them;
// opendrive.cpp writes them. Axes and units are those of env/scene.h.

#include <optional>
#include <string>
#include <vector>

#include "env/crossing/parameters.h"

namespace jaywalk {

enum class LaneType { driving, sidewalk, none };

struct PlannedLane {
  LaneType type = LaneType::none;
  double width_m = 0;
  /// Traffic goes the road's way; of no meaning unless it is driven on.
  bool forward = true;
};

enum class ObjectType { crosswalk, obstacle, building };

/// A box on the ground, with its sides along the axes.
struct PlannedObject {
  ObjectType type = ObjectType::obstacle;
  std::string name;
  Interval rows;
  Interval cells;
};

/// A traffic light for the traffic along the road, or against it.
struct PlannedSignal {
  int id = 0;
  std::string name;
  double s_m = 0;
  double t_m = 0;
  bool forward = true;
};

struct PlannedRoad {
  int id = 1;
  std::string name;
  /// Where the reference line begins, and its way; it is straight.
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
  double length_m = 0;
  /// The lanes from left to right; the first `left` of them lie on the left side of the reference
  /// line.
  std::vector<PlannedLane> lanes;
  std::size_t left = 0;
  /// The junctions that it begins and ends at, by their ids.
  std::optional<int> from;
  std::optional<int> to;
  std::vector<PlannedObject> objects;
  std::vector<PlannedSignal> signals;
};

/// The end of a lane at a junction; the heading is that of the traffic.
struct LaneEnd {
  int road = 0;
  /// OpenDRIVE's lane number: 1, 2, … on the left side of the reference line, -1, -2, … on its
  /// right.
  int lane = 0;
  /// At the end of the road, not at its beginning.
  bool at_end = true;
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
  double width_m = 0;
};

/// A way through a junction.
struct Connection {
  int road = 0;
  LaneEnd from;
  LaneEnd to;
};

struct PlannedJunction {
  int id = 0;
  std::vector<Connection> connections;
};

/// The lights of one crosswalk, which show the same.
struct SignalGroup {
  int id = 0;
  std::string name;
  std::vector<int> signals;
};

struct RoadPlan {
  double width_m = 0;
  double length_m = 0;
  /// The AV's road, in as many parts as junctions leave, then the side roads.
  std::vector<PlannedRoad> roads;
  std::vector<PlannedJunction> junctions;
  /// The lights of each signalled crosswalk, in their order.
  std::vector<SignalGroup> signals;
  /// Parts of the world that are left out, each as a sentence.
  std::vector<std::string> unsaid;
};

/// REQUIRES: parameters without problems().
[[nodiscard]] RoadPlan plan_roads(const CrossingParameters& parameters);

/// `1`, `2`, … on the left side of the reference line, `-1`, `-2`, … on its right.
[[nodiscard]] int lane_id(const PlannedRoad& road, std::size_t lane);

/// As ASAM OpenDRIVE 1.6. Roads in the plane of env/scene.h, the AV's along y. The reference line
/// runs between the lanes that go the road's way and the others; traffic keeps to the left, so that
/// lane 1 drives along the road.
[[nodiscard]] std::string to_opendrive(const RoadPlan& plan, double cell_m);

}  // namespace jaywalk
