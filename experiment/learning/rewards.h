#pragma once

// The rewards that a test gives its agents, by the scenario's `learning.reward`. Read
// policy/learning_spec.h first.

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "env/ground.h"
#include "env/world/world.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/judge/recording.h"
#include "experiment/learning/episodes.h"
#include "experiment/policy/learning_spec.h"

namespace jaywalk {

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
