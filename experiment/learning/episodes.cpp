// SPDX-License-Identifier: Apache-2.0
#include "experiment/learning/episodes.h"

#include <cmath>

#include <fmt/format.h>

#include "interpreter/agent/agent.h"

namespace jaywalk {

std::string EpisodeRecorder::weigh(const LearnedChoice& choice, std::span<double> probabilities) {
  const auto before = taken_.find({choice.agent.number(), std::string(choice.policy)});
  if (before != taken_.end()) {
    const std::size_t expected = before->second.front().transition.features.size();
    if (expected != choice.features.size()) {
      return fmt::format("observation({}, Features) has had {} numbers, now {}", choice.policy,
                         expected, choice.features.size());
    }
  }
  return policy_.weigh(choice, Learner::Mode::explore, probabilities);
}

void EpisodeRecorder::drawn(const LearnedChoice& choice, const DrawnOption& drawn) {
  auto numbers = policy_.numbers(choice.policy, choice.options);
  if (!numbers) return;  // of another program than the one that learns
  std::vector<Taken>& taken = taken_[{choice.agent.number(), std::string(choice.policy)}];
  if (!taken.empty()) {
    Taken& last = taken.back();
    last.transition.discount =
        std::pow(discount_, static_cast<double>(tick_) - static_cast<double>(last.tick));
  }
  Transition transition{.features = {choice.features.begin(), choice.features.end()},
                        .options = std::move(*numbers),
                        .chosen = static_cast<std::uint32_t>(drawn.chosen),
                        .probability = drawn.probabilities[drawn.chosen]};
  taken.push_back({.tick = tick_, .transition = std::move(transition)});
}

void EpisodeRecorder::reward(std::uint32_t agent, double reward, std::uint64_t tick) {
  if (reward == 0) return;
  for (auto part = taken_.lower_bound({agent, {}});
       part != taken_.end() && part->first.first == agent; ++part) {
    Taken& last = part->second.back();
    last.transition.reward +=
        reward * std::pow(discount_, static_cast<double>(tick) - static_cast<double>(last.tick));
  }
}

void EpisodeRecorder::add_reward(std::uint32_t agent, double reward) {
  this->reward(agent, reward, tick_);
}

void EpisodeRecorder::add_last_reward(std::uint32_t agent, double reward) {
  this->reward(agent, reward, tick_ > 0 ? tick_ - 1 : 0);
}

std::vector<Episode> EpisodeRecorder::episodes(const std::string& part) const {
  std::vector<Episode> episodes;
  for (const auto& [key, taken] : taken_) {
    if (key.second != part) continue;
    Episode& episode = episodes.emplace_back();
    for (const Taken& each : taken) episode.push_back(each.transition);
  }
  return episodes;
}

double EpisodeRecorder::mean_return() const {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& [key, taken] : taken_) {
    double follows = 0;
    for (std::size_t i = taken.size(); i-- > 0;) {
      follows = taken[i].transition.reward + taken[i].transition.discount * follows;
    }
    sum += follows;
    ++count;
  }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace jaywalk
