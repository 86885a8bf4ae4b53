// SPDX-License-Identifier: Apache-2.0
#pragma once

// The ground that SUMO simulates a test on: a network made from the bands, or a given map with the
// AV's way through it. Says where the world's road lies on it.

#include <optional>
#include <string>
#include <vector>

#include "env/simulator/simulator.h"
#include "env/simulator/sumo/sumo_network.h"
#include "env/simulator/sumo/sumo_process.h"
#include "env/simulator/sumo/sumo_settings.h"

namespace jaywalk {

/// The lane of a way that is SUMO's to choose.
inline constexpr int kBestLane = -1;

/// A way through the network: edges, and the lane of the first.
struct SumoWay {
  std::vector<std::string> edges;
  /// Where they begin, from the begin of the first; of ways on a network made from bands.
  std::vector<double> begins_m;
  int lane = 0;
  /// Metres from the first edge's begin to y = 0; counted the other way for oncoming traffic.
  double zero_m = 0;
  /// The length of the way, 0 if that is not known, and the x of the middle of its lane.
  double length_m = 0;
  double middle_x_m = 0;
  bool oncoming = false;
};

/// An edge of a way, by its number, and how far along it.
struct WayPlace {
  std::size_t edge = 0;
  double along_m = 0;
};

/// The place `position_m` along a way. A position in the gap between two edges is taken as the end
/// of the first one.
[[nodiscard]] WayPlace place_on(const SumoWay& way, double position_m);

class LaneWalker;

class SumoMap {
 public:
  /// The scenario's part, which must outlive it.
  explicit SumoMap(const SumoSettings& settings) : settings_(settings) {}

  /// Makes ready the network of a test. Why that failed, if it did. `changed`: the network is
  /// another one than that of the test before.
  [[nodiscard]] std::string prepare(const SimulatedTest& test, bool& changed);
  /// Finds the AV's way on a given map, with a SUMO that has loaded it. What the scenario asks of
  /// the map that it does not have; usually nothing.
  [[nodiscard]] std::vector<SettingProblem> survey(const SimulatedTest& test, SumoProcess& sumo);

  [[nodiscard]] std::string path() const;
  [[nodiscard]] const SumoWay& av_way() const { return av_way_; }
  /// The way of flow number `flow`. REQUIRES: prepared.
  [[nodiscard]] const SumoWay& flow_way(std::size_t flow) const { return flow_ways_[flow]; }
  [[nodiscard]] const RoadFrame& frame() const { return frame_; }
  /// The lights that show the colours of the world's signals.
  [[nodiscard]] const std::vector<SumoLight>& lights() const { return lights_; }
  /// Where persons begin.
  [[nodiscard]] const std::string& walking_edge() const { return walking_edge_; }

 private:
  [[nodiscard]] std::string prepare_bands(const SimulatedTest& test, bool& changed);
  /// The AV's way, once all edges are there.
  [[nodiscard]] std::optional<SettingProblem> find_way(const SimulatedTest& test,
                                                       LaneWalker& walker);

  const SumoSettings& settings_;
  MemoryFile made_;
  std::string made_from_;
  SumoWay av_way_;
  std::vector<SumoWay> flow_ways_;
  std::vector<SumoLight> lights_;
  RoadFrame frame_;
  std::string walking_edge_;
  bool surveyed_ = false;
};

}  // namespace jaywalk
