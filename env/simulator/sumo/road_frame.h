#pragma once

// Where the world's road lies on SUMO's map: the plane of env/scene.h laid along a line on it. A
// place of the world is an arc length along the line (y) and a distance to its right (x), the
// Frenet frame of the line; before and behind it the line goes on straight.

#include <vector>

#include "env/scene.h"
#include "env/simulator/sumo/traci_message.h"

namespace jaywalk {

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
