// SPDX-License-Identifier: Apache-2.0
#pragma once

// The search space of roads: what vectors and sequences stand for, and which of them are roads.
// Used by every SUT that drives. Read env/lane/validity.h first.

#include "env/lane/validity.h"
#include "search/suts/suts.h"
#include "search/test_input.h"

namespace jaywalk::search {

struct RoadSpaceSettings {
  /// Curvatures of a vector, and metres between its points (Peltomäki et al. 2022, section 2.1).
  std::size_t curvatures = 5;
  double step_m = 15;
  /// The curvature that 1 stands for, in 1/m.
  double most_curvature = 0.07;
  /// By how much neighbours differ at most in the first tests of generators that learn, in 1/m.
  double most_difference = 0.05;
  /// Metres between the points of a sequence, and how many values it has (Frenetic).
  double sequence_step_m = 10;
  std::size_t sequence_length = 20;
  std::size_t sequence_spread = 5;
  lane::RoadRules rules;

  friend bool operator==(const RoadSpaceSettings&, const RoadSpaceSettings&) = default;
};

class RoadSpace : public SearchSpace {
 public:
  explicit RoadSpace(const RoadSpaceSettings& settings) : settings_(settings) {}

  [[nodiscard]] const RoadSpaceSettings& settings() const { return settings_; }
  [[nodiscard]] std::size_t dimension() const override { return settings_.curvatures; }
  [[nodiscard]] std::optional<SequenceBounds> sequences() const override;
  /// In the competition's words.
  [[nodiscard]] Validity check(const TestInput& input) const override;
  [[nodiscard]] bool contains(const TestInput& input) const override;
  /// The first curvature is uniform, each further one differs from the one before it by a uniform
  /// amount and may leave the range, as in the experiments' code.
  [[nodiscard]] TestInput draw_initial(Random& random) const override;
  /// No values if the road does not fit into the map.
  [[nodiscard]] TestInput as_points(const TestInput& input) const override;
  /// The directions of 74 stretches of equal length, the first one turned up; from -pi to pi.
  [[nodiscard]] std::vector<double> signature(const TestInput& input) const override;

  [[nodiscard]] std::vector<double> unwrapped_signature(const TestInput& input) const override;

  [[nodiscard]] lane::Polyline road_points(const TestInput& input) const;

 private:
  RoadSpaceSettings settings_;
};

/// The keys `roads` of an experiment.
void read_road_space(const ConfigNode& node, const std::string& path, const ConfigReader& reader,
                     RoadSpaceSettings& space);

/// The road space in words.
[[nodiscard]] SutSetting road_setting(const RoadSpaceSettings& space);

}  // namespace jaywalk::search
