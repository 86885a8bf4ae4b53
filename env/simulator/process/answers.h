#pragma once

// What a simulator answers in the simulator protocol. Every function returns what is wrong with the
// answer, in words for people; empty if nothing is.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "env/simulator/simulator.h"

namespace jaywalk {

/// The version that is spoken.
inline constexpr int kSimulatorProtocol = 1;

/// Whom an answer may speak of: the actors of the test, by number, then the simulator's traffic.
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
