// SPDX-License-Identifier: Apache-2.0
#pragma once

// The actor's loss: the clipped objective of Schulman et al. ("Proximal policy optimization
// algorithms", 2017, equation 7) with a bonus for entropy, as a function of the options' scores.
// Read learner.h first.

#include <span>

#include "experiment/policy/learner.h"

namespace jaywalk {

struct ObjectiveSettings {
  /// How far the probability of an option may change, as a share of its former value.
  double clip = 0.2;
  /// The bonus for an entropy of 1.
  double entropy = 0.01;
};

/// The probabilities of the given options, by their scores.
/// REQUIRES: as many probabilities as options, a score for each option of the policy.
void softmax(std::span<const float> scores, std::span<const std::uint32_t> options,
             std::span<double> probabilities);

/// -min(r A, clip(r) A) - c H for one decision that was better than expected by `advantage`, where
/// its options have these probabilities now.
[[nodiscard]] double clipped_loss(const Transition& decision, double advantage,
                                  std::span<const double> probabilities,
                                  const ObjectiveSettings& settings);

/// Adds the gradient of clipped_loss() by the scores of all options of the policy.
void add_clipped_gradient(const Transition& decision, double advantage,
                          std::span<const double> probabilities, const ObjectiveSettings& settings,
                          std::span<float> gradient);

}  // namespace jaywalk
