// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which simulator moves the vehicles of a scenario's tests, for stores and reports.

#include <string>

#include "experiment/scenario/scenario.h"
#include "interpreter/support/diagnostics.h"

namespace jaywalk {

/// `SUMO 1.15.0`, or `SUMO 1.15.0, network sha256 3f2a…` of one that has a map; empty if the world
/// moves its vehicles by itself. The simulator is started for that. Errors: it cannot be, or finds
/// that it cannot simulate the scenario.
[[nodiscard]] Result<std::string> simulator_version(const Scenario& scenario);

}  // namespace jaywalk
