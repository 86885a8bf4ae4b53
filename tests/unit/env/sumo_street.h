// SPDX-License-Identifier: Apache-2.0
#pragma once

// A street of two lanes, one for each direction, between pavements; and settings that are text.

#include <string>
#include <utility>

#include "env/simulator/simulator.h"

namespace jaywalk {

inline SettingValue text(std::string value) {
  SettingValue setting;
  setting.text = std::move(value);
  return setting;
}

inline SimulatedRoad street() {
  SimulatedRoad road;
  road.length_m = 99;
  road.bands = {{AreaKind::pavement, 0, 3, false},
                {AreaKind::lane, 3, 9, false},
                {AreaKind::lane, 9, 15, true},
                {AreaKind::pavement, 15, 18, false}};
  return road;
}

}  // namespace jaywalk
