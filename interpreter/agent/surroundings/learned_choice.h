// SPDX-License-Identifier: Apache-2.0
#pragma once

// Choices that are learned. Plans that are labelled `@go[learned(step)]` are options of the policy
// `step`: where the first plan that is applicable to an event is one of them, rule SelAppl draws
// among all that are applicable, by probabilities that depend on the agent's observation. Its rules
// for observation(step, Features) answer it: a list of numbers, always of the same length.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

class Agent;

/// A question to a policy. All of it is valid until the call returns.
struct LearnedChoice {
  const Agent& agent;
  /// P of learned(P).
  std::string_view policy;
  /// The numbers that the agent observes.
  std::span<const double> features;
  /// The labels of the applicable plans, in their order; with `all_unifs`, a label for each
  /// solution.
  std::span<const std::string> options;
};

/// The result of a choice.
struct DrawnOption {
  /// Each option's probability; they add up to 1.
  std::span<const double> probabilities;
  std::size_t chosen = 0;
};

/// Policies of agents. Called on the threads on which agents reason.
class OptionPolicies {
 public:
  virtual ~OptionPolicies() = default;

  /// Sets how probable each option is, as numbers from 0 that add up to 1; at first all are the
  /// same. Returns why the choice cannot be made, an unknown option, say; empty: it can.
  [[nodiscard]] virtual std::string weigh(const LearnedChoice& choice,
                                          std::span<double> probabilities) = 0;
  /// An option was drawn.
  virtual void drawn(const LearnedChoice& /*choice*/, const DrawnOption& /*drawn*/) {}
};

}  // namespace jaywalk
