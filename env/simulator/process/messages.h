#pragma once

// The messages of Jaywalk in the simulator protocol, as JSON; the numbers of the question and of
// the test are added when one is sent. Lengths are metres, angles rad, times seconds.

#include <nlohmann/json.hpp>

#include "env/simulator/simulator.h"

namespace jaywalk {

/// A test begins: its road, the AV, the actors where they stand, the scenario's `options`. A tick
/// of the test is divided into `steps`.
[[nodiscard]] nlohmann::json reset_message(const SimulatedTest& test,
                                           const SimulatorParameters& parameters, int steps);

/// `period_s` seconds pass; the actors are where they are after `share` (0 to 1) of the tick.
[[nodiscard]] nlohmann::json step_message(const SimulatedTick& tick, double share, double period_s);

}  // namespace jaywalk
