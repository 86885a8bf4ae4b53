// SPDX-License-Identifier: Apache-2.0
#pragma once

// The choices of one test's agents and the rewards that followed, in the form that learners take.
// Which rewards a test gives, the scenario's `learning.reward` says. Read policy/learner.h and
// policy/learning_spec.h first.

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "env/ground.h"
#include "env/world/world.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/judge/recording.h"
#include "experiment/policy/learning_spec.h"
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

/// Distributes the rewards of each tick as it passes.
class TickRewards {
 public:
  /// REQUIRES: both outlive it.
  TickRewards(const LearningSpec& spec, EpisodeRecorder& episodes)
      : spec_(spec), episodes_(episodes) {}
  /// Call this before the first tick and after each.
  void tick(const World& world);

 private:
  const LearningSpec& spec_;
  EpisodeRecorder& episodes_;
  std::vector<double> scored_;  // so far, by agent
  bool begun_ = false;
};

/// Whether some end of a test is rewarded that only its recording shows.
[[nodiscard]] bool needs_recording(const RewardTerms& reward);

/// A test that is over.
struct FinishedTest {
  const WorldResult& outcome;
  const Recording& recording;
  const Ground& ground;
  std::span<const Assertion> assertions;
};

/// Distributes the rewards at the end of the test: agents that met the precondition get its reward,
/// all agents those of the test. `covered` has the bins of situations that earlier tests covered,
/// as "item bin", and receives the test's own.
void add_end_rewards(const LearningSpec& spec, const FinishedTest& test,
                     std::set<std::string>& covered, EpisodeRecorder& episodes);

}  // namespace jaywalk
