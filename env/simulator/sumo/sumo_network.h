// SPDX-License-Identifier: Apache-2.0
#pragma once

// The network that SUMO simulates on, made from a road's bands by `netconvert`: the lanes of one
// direction beside each other are an edge, each pavement is one. It is longer than the road at both
// ends, so that vehicles come from somewhere and leave behind it. Where the world has a signalled
// crosswalk, edges are parted by a traffic light. SUMO's map is the world's plane.

#include <span>
#include <string>
#include <vector>

#include "env/scene.h"
#include "env/simulator/simulator.h"
#include "env/simulator/sumo/traci_message.h"

namespace jaywalk {

/// A lane for vehicles.
struct SumoLane {
  /// In the order of its traffic; more than one where lights part them.
  std::vector<std::string> edges;
  /// Where each begins, in metres from the begin of the first.
  std::vector<double> begins_m;
  int index = 0;
  /// On the world's plane.
  double left_m = 0;
  double right_m = 0;
  bool oncoming = false;
};

/// A traffic light of the lanes that lead one way: their stop line before a signalled crosswalk.
struct SumoLight {
  std::string name;
  /// Each has a lamp of its own.
  std::size_t lanes = 1;
  /// Indices into the crosswalks of the ground; more than one if they begin together.
  std::vector<std::size_t> crosswalks;
};

/// How far the edges before and behind a light are apart: netconvert makes none that touch.
inline constexpr double kLightM = 0.4;

/// The inputs of netconvert, and the names in them.
struct SumoNetworkPlan {
  std::string nodes;
  std::string edges;
  bool left_hand = false;
  /// From the AV's left to its right.
  std::vector<SumoLane> lanes;
  std::vector<SumoLight> lights;
  /// The first pavement, or one beside the road if that has none: where persons begin.
  std::string walking_edge;
  /// Where all edges begin and end along the road.
  double from_m = 0;
  double to_m = 0;
};

/// Whether traffic keeps left, that is, the forward lanes lie to the left, the oncoming ones to the
/// right.
[[nodiscard]] bool keeps_left(std::span<const RoadBand> bands);

/// REQUIRES: the road has bands.
[[nodiscard]] SumoNetworkPlan plan_sumo_network(const SimulatedRoad& road, double first_m,
                                                double last_m);

/// Has the network written to a file that exists. What went wrong, if it did.
[[nodiscard]] std::string make_sumo_network(const SumoNetworkPlan& plan, const std::string& path);

/// Whether a given map is a network of SUMO already (`.net.xml`) and needs no conversion.
[[nodiscard]] bool is_sumo_network(const std::string& map);
/// Makes a network from a map of another kind: OpenStreetMap's (`.osm`, `.osm.xml`), OpenDRIVE's
/// (`.xodr`), or an `.xml` file with the nodes and edges of SUMO's plain format. Returns why that
/// failed; empty if it did not.
[[nodiscard]] std::string convert_to_sumo_network(const std::string& map, bool left_hand,
                                                  const std::string& path);

/// Where the world's road lies on SUMO's map: the plane of env/scene.h laid along a line on it. A
/// place of the world is an arc length along the line (y) and a distance to its right (x), the
/// Frenet frame of the line; before and behind it the line goes on straight.
class RoadFrame {
 public:
  /// The map is the world's plane.
  RoadFrame() = default;
  /// Along a line of at least two places that differ, from `begin_m` of its length, with the
  /// world's x = `line_x_m` on it.
  RoadFrame(const std::vector<TraciPoint>& line, double begin_m, double line_x_m);

  struct Pose {
    double x_m = 0;
    double y_m = 0;
    double heading_rad = 0;
  };
  [[nodiscard]] Pose to_map(Pose world) const;
  [[nodiscard]] Pose to_world(Pose map) const;
  /// The length of the line; 0 where the map is the world's plane.
  [[nodiscard]] double length_m() const { return ends_m_.empty() ? 0 : ends_m_.back(); }

 private:
  struct Segment {
    TraciPoint from;
    double heading_rad = 0;
    double length_m = 0;
  };
  [[nodiscard]] std::size_t segment_at(double along_m) const;

  std::vector<Segment> segments_;
  std::vector<double> ends_m_;  // of the segments, from the line's begin
  double begin_m_ = 0;
  double line_x_m_ = 0;
};

}  // namespace jaywalk
