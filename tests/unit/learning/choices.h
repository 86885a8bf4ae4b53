// SPDX-License-Identifier: Apache-2.0
#pragma once

// Agents that choose by a policy of two parts, `step` with the options go and stay, and `turn` with
// left and right; what they choose is what the test says.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "experiment/learning/episodes.h"
#include "interpreter/mas/mas.h"
#include "tests/helpers/programs.h"

namespace jaywalk::testing_learning {

/// Has learned nothing.
inline Policy policy_of_two_parts(const LearnerSettings& settings = {}) {
  PolicyOrigin origin;
  origin.spec.settings = settings;
  return {std::move(origin),
          std::vector<LearnedPlans>{{.policy = "step", .options = {"go", "stay"}},
                                    {.policy = "turn", .options = {"left", "right"}}}};
}

class Choosers {
 public:
  explicit Choosers(std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
      ids_.push_back(
          mas_.add_agent({.name = "a" + std::to_string(i), .program = compiled_.program}));
    }
  }

  [[nodiscard]] LearnedChoice choice(std::uint32_t agent, std::string_view part) const {
    return {mas_.agent(ids_[agent]), part, features, part == "step" ? steps_ : turns_};
  }
  /// The agent takes an option of a part, by its index.
  void choose(EpisodeRecorder& episodes, std::uint32_t agent, std::size_t chosen,
              std::string_view part = "step") const {
    constexpr std::array kProbabilities{0.25, 0.75};
    episodes.drawn(choice(agent, part), {.probabilities = kProbabilities, .chosen = chosen});
  }

  /// The features that all agents observe.
  std::vector<double> features{1};

 private:
  test::CompiledProgram compiled_{"b."};
  // The table lives as long as this does.
  Mas mas_{
      std::shared_ptr<const SymbolTable>(std::shared_ptr<void>(), &compiled_.symbols), {}, nullptr};
  std::vector<AgentId> ids_;
  std::vector<std::string> steps_{"go", "stay"};
  std::vector<std::string> turns_{"left", "right"};
};

}  // namespace jaywalk::testing_learning
