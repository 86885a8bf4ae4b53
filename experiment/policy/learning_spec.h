#pragma once

// How agents are to learn: what is rewarded, which learner, and its settings, as the section
// `learning` of a scenario says it (docs/reference/scenarios.md).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jaywalk {

/// Files of policies that are longer are not read.
inline constexpr std::size_t kMostPolicyBytes = std::size_t{1} << 28U;

/// How to learn, as a scenario's `learning` has it; each learner uses what it knows of.
struct LearnerSettings {
  /// Of q-table: the width of each feature's bins; those that are not given have 1.
  std::vector<double> bins;
  /// Of both: how much of what follows later counts beside what is expected after one step, 0 to 1.
  double trace = 0.8;
  /// Of q-table, by which part of its error a value is corrected at least; of actor-critic, the
  /// step of its optimiser. Not set: 0.05 and 0.003.
  std::optional<double> rate;
  /// Of both: after how many episodes `explores` or `entropy` has halved.
  double halves_after = 500;
  /// Of q-table: the share of choices that are made at random, at first and at least.
  double explores = 0.5;
  double explores_least = 0.01;
  /// Of actor-critic: units in each hidden layer, passes over each generation, how far the
  /// probability of an option may change in one, and what chance is worth, at first and at least.
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
  /// Every agent of a test gets the mean of what all get.
  bool is_shared = false;
  /// The factor by which a reward counts less when it comes a second later, 0 to 1.
  double discount = 0.98;
  /// Tests between which nothing is learned; they run side by side.
  std::uint64_t generation = 32;

  friend bool operator==(const LearningSpec&, const LearningSpec&) = default;
};

}  // namespace jaywalk
