// SPDX-License-Identifier: Apache-2.0
#pragma once

// Learners: they learn from agents' choices and give the probability of each option. A learner is a
// policy of its own: a file (policy.h) keeps its state, from which learning can go on. Each learner
// is a source file and a row of learners.def.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "experiment/policy/learning_spec.h"

namespace jaywalk {

/// One choice of an agent, and the rewards until its next one.
struct Transition {
  std::vector<double> features;
  /// The options that there were, by their numbers in the policy, and which of them was chosen, as
  /// an index of these.
  std::vector<std::uint32_t> options;
  std::uint32_t chosen = 0;
  /// The chosen option's probability when it was chosen.
  double probability = 1;
  /// The reward until the agent's next choice or the end, discounted from the choice on.
  double reward = 0;
  /// The weight here of rewards from the next choice on, 0 to 1.
  double discount = 1;
};

/// The choices of one agent in one test, in order. Nothing follows the last one.
using Episode = std::vector<Transition>;

/// The features and options of a choice.
struct PolicyShape {
  /// The labels of the plans, in the program's order.
  std::vector<std::string> options;
  /// How many numbers are observed.
  std::size_t features = 0;
};

class Learner {
 public:
  virtual ~Learner() = default;

  /// Whether to try options that are not well known, in order to learn.
  enum class Mode { explore, exploit };

  /// Sets how probable each of these options is. REQUIRES: numbers of the shape.
  virtual void weigh(std::span<const double> features, std::span<const std::uint32_t> options,
                     Mode mode, std::span<double> probabilities) const = 0;
  /// The discounted reward expected from a choice on; 0: not known.
  [[nodiscard]] virtual double value(std::span<const double> features) const = 0;
  /// Learns from the episodes of one generation, in their order.
  virtual void learn(std::span<const Episode> generation) = 0;
  /// All that it has learned, so that restore() makes it the same to the last bit.
  [[nodiscard]] virtual nlohmann::json state() const = 0;
  /// Throws std::exception, and must not be used afterwards, if that is not the state of such a
  /// learner.
  virtual void restore(const nlohmann::json& state) = 0;
};

using MakeLearner = std::unique_ptr<Learner>(const PolicyShape& shape,
                                             const LearnerSettings& settings, std::uint64_t seed);

struct LearnerKind {
  std::string_view name;
  std::string_view summary;
  MakeLearner* make = nullptr;
};

/// In the order of learners.def.
[[nodiscard]] std::span<const LearnerKind> learner_kinds();
/// Null: there is no such learner.
[[nodiscard]] const LearnerKind* find_learner(std::string_view name);

namespace learners {
#define JAYWALK_LEARNER(function, name, summary) MakeLearner function;
#include "experiment/policy/learners.def"
#undef JAYWALK_LEARNER
}  // namespace learners

}  // namespace jaywalk
