// SPDX-License-Identifier: Apache-2.0
#pragma once

// The section `learning` of a scenario (docs/reference/scenarios.md): rewards, the learner and
// its settings.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jaywalk {

/// Files of policies that are longer are not read.
inline constexpr std::size_t kMostPolicyBytes = std::size_t{1} << 28U;

/// Settings of a learner from a scenario's `learning`; each learner uses those that it knows.
struct LearnerSettings {
  /// For q-table: the width of each feature's bins; 1 where it is not given.
  std::vector<double> bins;
  /// For both: the weight of real later rewards against the expectation after one step, 0 to 1.
  double trace = 0.8;
  /// For q-table the least share of its error by which a value is corrected; for actor-critic the
  /// step size of its optimiser. Not set: 0.05 and 0.003.
  std::optional<double> rate;
  /// For both: the number of episodes after which `explores` or `entropy` has halved.
  double halves_after = 500;
  /// For q-table: the share of random choices, at first and at least.
  double explores = 0.5;
  double explores_least = 0.01;
  /// For actor-critic: units in each hidden layer, passes over each generation, how far the
  /// probability of an option may change in one, and the weight of entropy, at first and at least.
  std::uint32_t hidden = 32;
  std::uint32_t passes = 4;
  double clip = 0.2;
  double entropy = 0.3;
  double entropy_least = 0.01;

  friend bool operator==(const LearnerSettings&, const LearnerSettings&) = default;
};

/// The weights of a test's reward for its agents, which is a weighted sum.
struct RewardTerms {
  /// Weight of the world's score: the agent's rewards less its costs, tick by tick.
  double score = 0;
  /// Weight of each test whose precondition is met.
  double precondition = 0;
  /// Weight of each test in which the AV is to blame for breaking an assertion, by the assertion's
  /// id.
  std::vector<std::pair<std::string, double>> violation;
  /// Weight of an assertion's robustness with its sign turned, at most 10 to either side; a test
  /// that does not meet the assertion's precondition counts as the most robust.
  std::vector<std::pair<std::string, double>> robustness;
  /// Weight of each bin of a situation (situations.def) that no earlier test covered.
  double new_bins = 0;
  /// Weight of the share of steps that a person might take, 0 to 1.
  double natural_steps = 0;

  friend bool operator==(const RewardTerms&, const RewardTerms&) = default;
};

struct LearningSpec {
  /// A name of learners.def.
  std::string learner = "q-table";
  LearnerSettings settings;
  RewardTerms reward{.score = 1};
  /// Whether every agent of a test gets the mean of all agents' rewards.
  bool is_shared = false;
  /// The factor by which a reward counts less when it comes a second later, 0 to 1.
  double discount = 0.98;
  /// Tests between which nothing is learned; they run side by side.
  std::uint64_t generation = 32;

  friend bool operator==(const LearningSpec&, const LearningSpec&) = default;
};

}  // namespace jaywalk
