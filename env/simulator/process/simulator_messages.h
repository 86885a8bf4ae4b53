// SPDX-License-Identifier: Apache-2.0
#pragma once

// The messages of Jaywalk in the simulator protocol, as JSON; the numbers of the question and of
// the test are added when one is sent. Lengths are metres, angles rad, times seconds.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/simulator/simulator.h"

namespace jaywalk {

/// A test begins: its road, the AV, the actors where they stand, the scenario's `options`. A tick
/// of the test is divided into `steps`.
[[nodiscard]] nlohmann::json reset_message(const SimulatedTest& test,
                                           const SimulatorParameters& parameters, int steps);

/// `period_s` seconds pass; the actors are where they are after `share` (0 to 1) of the tick.
[[nodiscard]] nlohmann::json step_message(const SimulatedTick& tick, double share, double period_s);

// A simulator's answers. Every function returns a message about the first error in the answer, or
// an empty text.

/// The version that is spoken.
inline constexpr int kSimulatorProtocol = 1;

/// The actors that an answer may refer to: those of the test, by number, then the simulator's
/// traffic.
struct SimulatedCast {
  std::size_t actors = 0;
  /// The names of its traffic.
  std::vector<std::string> traffic;
};

[[nodiscard]] std::string read_hello(const nlohmann::json& answer, SimulatorIdentity& identity);

/// Every answer repeats the number of its test.
[[nodiscard]] std::string check_echo(const nlohmann::json& answer, std::uint64_t test);

/// The answer to `reset`: adds its traffic to the cast.
[[nodiscard]] std::string read_start(const nlohmann::json& answer, SimulatedCast& cast,
                                     SimulatedStart& start);

/// The answer to `step`, whose time has to be `time_s`, in seconds since the test began.
[[nodiscard]] std::string read_scene(const nlohmann::json& answer, const SimulatedCast& cast,
                                     double time_s, SimulatedScene& scene);

}  // namespace jaywalk
