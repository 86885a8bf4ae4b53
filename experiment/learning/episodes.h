#pragma once

// The choices of one test's agents and the rewards that followed, in the form that learners take.
// Read policy/learner.h first.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiment/policy/policy.h"

namespace jaywalk {

/// Stands between the agents and their exploring policy, and records their choices.
class EpisodeRecorder final : public OptionPolicies {
 public:
  /// A reward counts `discount` of itself a tick earlier. The policy must outlive it.
  EpisodeRecorder(const Policy& policy, double discount) : policy_(policy), discount_(discount) {}

  [[nodiscard]] std::string weigh(const LearnedChoice& choice,
                                  std::span<double> probabilities) override;
  void drawn(const LearnedChoice& choice, const DrawnOption& drawn) override;

  /// Adds an agent's reward for the tick that just ended; agents are numbered from 0.
  void add_reward(std::uint32_t agent, double reward);
  /// The next tick begins.
  void tick() { ++tick_; }
  /// Adds an agent's reward for the end of the test. REQUIRES: it is over.
  void add_last_reward(std::uint32_t agent, double reward);

  /// Each agent's choices by a part of the policy, in the order of the agents' numbers.
  [[nodiscard]] std::vector<Episode> episodes(const std::string& part) const;
  /// The rewards of all agents as they counted when they first chose, their mean.
  [[nodiscard]] double mean_return() const;

 private:
  struct Taken {
    std::uint64_t tick = 0;
    Transition transition;
  };
  using Key = std::pair<std::uint32_t, std::string>;  // agent and part of the policy
  void reward(std::uint32_t agent, double reward, std::uint64_t tick);

  const Policy& policy_;
  double discount_;
  std::uint64_t tick_ = 0;
  std::map<Key, std::vector<Taken>> taken_;
};

}  // namespace jaywalk
