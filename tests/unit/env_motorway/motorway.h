// SPDX-License-Identifier: Apache-2.0
#pragma once

// A motorway with vehicles at given places, for the tests of this folder.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "env/motorway/motorway.h"

namespace jaywalk::motorway {

/// A motorway and the words of its agents.
class MotorwayTest : public testing::Test {
 protected:
  MotorwayTest() : vocabulary_(symbols_) { parameters_.av.vehicle.model = "constant"; }

  /// A vehicle of an agent, at a steady speed in the middle of a lane.
  [[nodiscard]] MotorwayVehicle vehicle(int lane, double front_m, double speed_mps = 30) const {
    return {.x_m = middle_of_lane(parameters_, lane),
            .front_m = front_m,
            .speed_mps = speed_mps,
            .lane = lane};
  }
  [[nodiscard]] Motorway with(std::vector<MotorwayVehicle> vehicles) const {
    return Motorway(parameters_, vocabulary_, std::move(vehicles));
  }

  /// One tick in which the agent acts. Why it could not; empty if it could.
  std::string act(Motorway& motorway, MotorwayAction action, std::vector<Value> args = {},
                  std::uint32_t agent = 0) {
    const ActionRequest request{AgentId{agent}, vocabulary_.action(action), args};
    std::vector<ActionResult> results(1);
    motorway.execute({&request, 1}, results);
    motorway.advance();
    EXPECT_EQ(results[0].succeeded, results[0].reason.empty());
    return results[0].reason;
  }
  static void idle(Motorway& motorway, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      motorway.execute({}, {});
      motorway.advance();
    }
  }

  /// The first arguments of the agent's percepts of that name.
  [[nodiscard]] std::vector<std::vector<double>> perceived(const Motorway& motorway,
                                                           std::string_view name,
                                                           std::uint32_t agent = 0) const {
    Percepts percepts;
    motorway.perceive(AgentId{agent}, percepts);
    std::vector<std::vector<double>> all;
    for (std::size_t i = 0; i < percepts.size(); ++i) {
      if (symbols_.functor(percepts.predicate(i)) != name) continue;
      auto& args = all.emplace_back();
      for (const Value value : percepts.args(i)) args.push_back(value.as_number());
    }
    return all;
  }

  SymbolTable symbols_;
  MotorwayVocabulary vocabulary_;
  MotorwayParameters parameters_;
};

using Rows = std::vector<std::vector<double>>;

}  // namespace jaywalk::motorway
