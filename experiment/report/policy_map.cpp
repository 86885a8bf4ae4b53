// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/policy_map.h"

#include <algorithm>
#include <cmath>

#include "experiment/policy/policy.h"
#include "experiment/test_run/test_run.h"
#include "interpreter/agent/agent.h"

namespace jaywalk::reporting {
namespace {

/// Chooses as the policy does, and counts where which option was drawn.
class PlacedChoices final : public OptionPolicies {
 public:
  PlacedChoices(const Policy& policy, double cell_m) : policy_(policy), cell_m_(cell_m) {
    for (const LearnedPlans& each : policy.plans()) {
      maps_.push_back({.part = each.policy, .options = each.options, .places = {}});
    }
  }

  void see(Scene scene) { scene_ = std::move(scene); }

  [[nodiscard]] std::string weigh(const LearnedChoice& choice,
                                  std::span<double> probabilities) override {
    return policy_.weigh(choice, Learner::Mode::exploit, probabilities);
  }

  void drawn(const LearnedChoice& choice, const DrawnOption& drawn) override {
    const auto map = std::ranges::find(maps_, choice.policy, &PolicyMap::part);
    const auto numbers = policy_.numbers(choice.policy, choice.options);
    const std::size_t actor = 1 + choice.agent.number();
    if (map == maps_.end() || !numbers || actor >= scene_.size()) return;
    const auto cell = [&](double metres) { return static_cast<int>(std::floor(metres / cell_m_)); };
    const Square square{cell(scene_[actor].x_m), cell(scene_[actor].y_m - scene_.front().y_m)};
    std::vector<std::uint64_t>& chosen = map->places[square];
    chosen.resize(map->options.size());
    ++chosen[(*numbers)[drawn.chosen]];
    ++map->choices;
  }

  [[nodiscard]] std::vector<PolicyMap> maps() && {
    std::erase_if(maps_, [](const PolicyMap& map) { return map.choices == 0; });
    return std::move(maps_);
  }

 private:
  const Policy& policy_;
  double cell_m_;
  std::vector<PolicyMap> maps_;
  Scene scene_;  // as the agents see it
};

}  // namespace

std::vector<PolicyMap> policy_maps(const PreparedScenario& prepared, const PolicyMapTests& tests) {
  const WorldSpec& world = *prepared.scenario().world;
  const std::shared_ptr<const Policy>& policy = prepared.behaviours()[tests.behaviour].policy;
  if (policy == nullptr || !world.command().empty() || !world.simulator().name.empty()) return {};
  PlacedChoices choices(*policy, world.plan().cell_m);
  TestRunner runner(prepared);
  TestOptions options;
  options.policies = &choices;
  options.observe = [&](const World& now, const Mas&) { choices.see(now.scene()); };
  for (std::uint64_t i = 0; i < tests.count; ++i) {
    (void)runner.run({.behaviour = tests.behaviour,
                      .agents = tests.agents,
                      .seed = tests.seed,
                      .test = tests.first + i},
                     options);
  }
  return std::move(choices).maps();
}

}  // namespace jaywalk::reporting
