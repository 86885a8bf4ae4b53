// SPDX-License-Identifier: Apache-2.0
#include "experiment/policy/clipped_objective.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jaywalk {
namespace {

/// How much more probable the chosen option is than when it was chosen.
double ratio_of(const Transition& decision, std::span<const double> probabilities) {
  return probabilities[decision.chosen] / std::max(decision.probability, 1e-9);
}

double entropy_of(std::span<const double> probabilities) {
  double entropy = 0;
  for (const double p : probabilities) entropy -= p > 0 ? p * std::log(p) : 0;
  return entropy;
}

}  // namespace

void softmax(std::span<const float> scores, std::span<const std::uint32_t> options,
             std::span<double> probabilities) {
  double most = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t option : options) {
    most = std::max(most, static_cast<double>(scores[option]));
  }
  double sum = 0;
  for (std::size_t i = 0; i < options.size(); ++i) {
    sum += probabilities[i] = std::exp(static_cast<double>(scores[options[i]]) - most);
  }
  for (double& probability : probabilities) probability /= sum;
}

double clipped_loss(const Transition& decision, double advantage,
                    std::span<const double> probabilities, const ObjectiveSettings& settings) {
  const double ratio = ratio_of(decision, probabilities);
  const double clipped = std::clamp(ratio, 1 - settings.clip, 1 + settings.clip);
  return -std::min(ratio * advantage, clipped * advantage) -
         settings.entropy * entropy_of(probabilities);
}

void add_clipped_gradient(const Transition& decision, double advantage,
                          std::span<const double> probabilities, const ObjectiveSettings& settings,
                          std::span<float> gradient) {
  const double ratio = ratio_of(decision, probabilities);
  const bool is_clipped = advantage > 0 ? ratio > 1 + settings.clip : ratio < 1 - settings.clip;
  const double by_log = is_clipped ? 0 : -ratio * advantage;
  const double entropy = entropy_of(probabilities);
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double p = probabilities[i];
    const double chosen = i == decision.chosen ? 1 : 0;
    const double by_entropy = p > 0 ? -p * (std::log(p) + entropy) : 0;
    gradient[decision.options[i]] +=
        static_cast<float>(by_log * (chosen - p) - settings.entropy * by_entropy);
  }
}

}  // namespace jaywalk
