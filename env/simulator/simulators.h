#pragma once

// The functions that the rows of simulators.def name.

#include <memory>
#include <span>
#include <vector>

#include "env/simulator/simulator.h"

namespace jaywalk {

[[nodiscard]] std::span<const SettingKey> process_keys();
[[nodiscard]] std::vector<SettingProblem> check_process(const SimulatorParameters& parameters,
                                                        const SimulatedSite* site);
[[nodiscard]] std::unique_ptr<Simulator> make_process(const SimulatorParameters& parameters);

[[nodiscard]] std::span<const SettingKey> sumo_keys();
[[nodiscard]] std::vector<SettingProblem> check_sumo(const SimulatorParameters& parameters,
                                                     const SimulatedSite* site);
[[nodiscard]] std::unique_ptr<Simulator> make_sumo(const SimulatorParameters& parameters);

}  // namespace jaywalk
