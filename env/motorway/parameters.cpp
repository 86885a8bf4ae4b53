#include "env/motorway/parameters.h"

#include <fmt/format.h>

#include "env/vehicle/section.h"

namespace jaywalk {

std::vector<ParameterProblem> problems(const MotorwayParameters& parameters) {
  std::vector<ParameterProblem> found;
  if (parameters.av.lane > parameters.lanes) {
    found.push_back({"world.av.lane", fmt::format("the AV's lane {} is none of the {}",
                                                  parameters.av.lane, parameters.lanes)});
  }
  if (parameters.av.width_m > parameters.lane_m) {
    found.push_back({"world.av.width", fmt::format("an AV of {} m does not fit a lane of {} m",
                                                   parameters.av.width_m, parameters.lane_m)});
  }
  if (parameters.av.start_m >= parameters.length_m) {
    found.push_back({"world.av.start", fmt::format("the road of {} m ends before the AV's start",
                                                   parameters.length_m)});
  }
  if (parameters.drivers.greatest_speed_mps < parameters.av.speed_mps) {
    found.push_back({"world.drivers.greatest_speed",
                     "drivers begin at the AV's speed, which is greater than their greatest"});
  }
  check_defects(parameters.av.vehicle, parameters.av.twin, found);
  return found;
}

}  // namespace jaywalk
