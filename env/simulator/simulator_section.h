// SPDX-License-Identifier: Apache-2.0
#pragma once

// The key `world.simulator` of a scenario: a simulator's name, or its name with its own keys, which
// only the simulator's row of simulators.def knows.

#include <string>

#include "env/config/section_reader.h"
#include "env/simulator/parameters.h"

namespace jaywalk {

struct SimulatedSite;

/// Reads one layer into the parameters.
void read_simulator(const ConfigNode& node, const std::string& path, const SectionContext& context,
                    SimulatorParameters& parameters);
/// Points at the keys that the problems are of.
void report_settings(std::vector<SettingProblem> problems, const ValueOrigins& origins,
                     const std::string& scenario, Diagnostics& diagnostics);

/// Reports the simulator's errors in the settings and in the site; the site is null if it has
/// errors itself. REQUIRES: a simulator is named.
void check_simulator(const SimulatorParameters& parameters, const SimulatedSite* site,
                     const std::string& scenario, const SectionContext& context);

}  // namespace jaywalk
