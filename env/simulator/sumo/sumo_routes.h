// SPDX-License-Identifier: Apache-2.0
#pragma once

// The vehicles and persons of a test as SUMO reads them: a file of routes.

#include <string>
#include <vector>

#include "env/simulator/simulator.h"
#include "env/simulator/sumo/sumo_map.h"
#include "env/simulator/sumo/sumo_settings.h"

namespace jaywalk {

/// A vehicle of the simulator's own traffic.
struct SumoTraffic {
  /// Its name in SUMO and in scenes.
  std::string name;
  std::size_t flow = 0;
  double depart_s = 0;
  /// Where its front is then, from the begin of its way.
  double position_m = 0;
};

/// SUMO's names of the AV, and of the actors that the world moves, by their index in the test.
inline constexpr std::string_view kSumoAv = "av";
[[nodiscard]] std::string sumo_body(std::size_t actor);
/// Whether SUMO has the actor, too, as a person or vehicle that its own vehicles brake for.
[[nodiscard]] bool is_body(const Actor& actor, const SumoSettings& settings);

/// The vehicles that are on the road when the test begins, and those that come in the minute after
/// it, in the order of their numbers. Drawn from the test's seed.
[[nodiscard]] std::vector<SumoTraffic> draw_traffic(const SimulatedTest& test,
                                                    const SumoSettings& settings,
                                                    const SumoMap& map);

/// REQUIRES: the map is prepared for the test.
[[nodiscard]] std::string sumo_routes(const SimulatedTest& test, const SumoSettings& settings,
                                      const SumoMap& map, const std::vector<SumoTraffic>& traffic,
                                      const std::string& token);

}  // namespace jaywalk
