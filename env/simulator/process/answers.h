#pragma once

// Reads a simulator's answers in the simulator protocol. Every function returns a message about the
// first error in the answer, or an empty text.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/simulator/simulator.h"

namespace jaywalk {

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
