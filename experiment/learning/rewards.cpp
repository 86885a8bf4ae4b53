// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "experiment/judge/metrics/metrics.h"
#include "experiment/judge/situations/situations.h"
#include "experiment/learning/episodes.h"

namespace jaywalk {
namespace {

/// A robustness counts so far and no farther, in its own unit.
constexpr double kMostRobust = 10;

/// In a team that shares, each agent gets the mean.
void share(std::vector<double>& rewards) {
  const double mean = std::accumulate(rewards.begin(), rewards.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(rewards.size(), 1));
  std::ranges::fill(rewards, mean);
}

double of_verdicts(const RewardTerms& reward, const FinishedTest& test, const TestView& view) {
  double sum = 0;
  const auto judged = [&](const std::string& id) {
    const auto found = std::ranges::find(test.assertions, id, &Assertion::id);
    return found == test.assertions.end() ? Judgement{} : judge(*found, view);
  };
  for (const auto& [id, weight] : reward.violation) {
    if (judged(id).verdict == Verdict::fail) sum += weight;
  }
  for (const auto& [id, weight] : reward.robustness) {
    const double robustness = judged(id).robustness.value_or(kMostRobust);
    sum -= weight * std::clamp(robustness, -kMostRobust, kMostRobust);
  }
  return sum;
}

double of_new_bins(const FinishedTest& test, std::set<std::string>& covered) {
  const SituationBins bins = covered_bins(test.recording, test.ground);
  double fresh = 0;
  for (std::size_t item = 0; item < bins.size(); ++item) {
    if (!bins[item]) continue;
    const SituationItem& of = situation_items()[item];
    if (covered.insert(fmt::format("{} {}", of.name, of.bins[*bins[item]])).second) fresh += 1;
  }
  return fresh;
}

}  // namespace

void TickRewards::tick(const World& world) {
  const std::vector<AgentOutcome>& all = world.result().agents;
  scored_.resize(all.size());
  std::vector<double> rewards(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double now = all[i].reward - all[i].cost;
    rewards[i] = spec_.reward.score * (now - scored_[i]);
    scored_[i] = now;
  }
  if (!begun_) {
    begun_ = true;
    return;
  }
  if (spec_.is_shared) share(rewards);
  for (std::size_t i = 0; i < rewards.size(); ++i) {
    episodes_.add_reward(static_cast<std::uint32_t>(i), rewards[i]);
  }
  episodes_.tick();
}

bool needs_recording(const RewardTerms& reward) {
  return !reward.violation.empty() || !reward.robustness.empty() || reward.new_bins != 0 ||
         reward.natural_steps != 0;
}

void add_end_rewards(const LearningSpec& spec, const FinishedTest& test,
                     std::set<std::string>& covered, EpisodeRecorder& episodes) {
  const RewardTerms& reward = spec.reward;
  double of_all = 0;
  if (needs_recording(reward)) {
    const TestView view(test.recording, test.ground);
    of_all += of_verdicts(reward, test, view);
    if (reward.new_bins != 0) of_all += reward.new_bins * of_new_bins(test, covered);
    if (reward.natural_steps != 0) {
      const auto natural = measured(*find_metric("natural_steps"), view);
      of_all += reward.natural_steps * (natural ? natural->value : 1);
    }
  }
  std::vector<double> rewards(test.outcome.agents.size(), of_all);
  for (const std::size_t agent : test.outcome.met_by) {
    if (agent < rewards.size()) rewards[agent] += reward.precondition;
  }
  if (spec.is_shared) share(rewards);
  for (std::size_t i = 0; i < rewards.size(); ++i) {
    episodes.add_last_reward(static_cast<std::uint32_t>(i), rewards[i]);
  }
}

}  // namespace jaywalk
