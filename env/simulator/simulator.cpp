// SPDX-License-Identifier: Apache-2.0
#include "env/simulator/simulator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace jaywalk {

ActorState body_at(const SimulatedBody& body, double share) {
  ActorState state = body.after;
  const auto between = [share](double from, double to) { return from + (to - from) * share; };
  state.x_m = between(body.before.x_m, body.after.x_m);
  state.y_m = between(body.before.y_m, body.after.y_m);
  return state;
}

int steps_of(double tick_s, double step_s) {
  if (!(step_s > 0) || step_s >= tick_s) return 1;
  return std::max(1, static_cast<int>(std::lround(tick_s / step_s)));
}

std::span<const SimulatorKind> simulator_kinds() {
  static const std::array kKinds{
#define JAYWALK_SIMULATOR(name, summary, keys, check, make) \
  SimulatorKind{name, summary, keys(), check, make},
#include "env/simulator/simulators.def"
#undef JAYWALK_SIMULATOR
  };
  return kKinds;
}

const SimulatorKind* find_simulator(std::string_view name) {
  const auto all = simulator_kinds();
  const auto found = std::ranges::find(all, name, &SimulatorKind::name);
  return found == all.end() ? nullptr : &*found;
}

Simulator& Simulators::of(const SimulatorParameters& parameters) {
  if (kept_ != nullptr && parameters_ == parameters) return *kept_;
  kept_.reset();
  parameters_ = parameters;
  kept_ = find_simulator(parameters.name)->make(parameters);
  return *kept_;
}

}  // namespace jaywalk
