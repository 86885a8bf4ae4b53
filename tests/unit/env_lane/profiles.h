// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cars and roads that several tests drive.

#include <string_view>
#include <utility>
#include <vector>

#include "env/lane/drive.h"
#include "env/lane/validity.h"
#include "interpreter/support/random.h"

namespace jaywalk::lane {

inline DriveSettings profile(std::string_view name) {
  return drive_settings(*find_controller(name));
}

/// Roads of five independent curvatures, valid ones alone.
inline std::vector<Road> random_roads(std::size_t count) {
  SplitMix64 random(7);
  std::vector<Road> roads;
  while (roads.size() < count) {
    std::vector<double> curvatures(5);
    for (double& each : curvatures) {
      each = 0.07 * (static_cast<double>(random.next() >> 11U) * 0x1.0p-52 - 1);
    }
    RoadVerdict verdict = validate(integrate(curvatures));
    if (verdict.valid()) roads.push_back(std::move(*verdict.road));
  }
  return roads;
}

}  // namespace jaywalk::lane
