// SPDX-License-Identifier: Apache-2.0
#pragma once

// Agents that learn: tests in generations, between which a policy learns from its agents' choices
// and rewards. Within a generation the policy does not change, and it learns in the tests' order,
// so the result does not depend on threads. Read policy/policy.h first.

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "experiment/learning/episodes.h"
#include "experiment/policy/policy.h"
#include "experiment/test_run/controller_notes.h"
#include "experiment/test_run/prepared_scenario.h"
#include "experiment/test_run/test_run.h"

namespace jaywalk {

/// The policies to train, and the tests to train them in.
struct TrainingPlan {
  std::shared_ptr<const PreparedScenario> prepared;
  /// Index into its behaviours.
  std::size_t behaviour = 0;
  std::uint32_t agents = 1;
  std::uint64_t seed = 0;
  /// REQUIRES: at least 1.
  unsigned threads = 1;
  /// The command line's changes to the scenario, as given by --set.
  std::vector<std::string> sets;
  /// Asked in the middle of tests; true gives the generation up, of which nothing is learned then.
  std::function<bool()> interrupted;
};

/// A policy that has learned nothing, for the plan; or what keeps its behaviour from learning.
[[nodiscard]] Result<std::shared_ptr<Policy>> new_policy(const TrainingPlan& plan);

/// Why the policy was not learned as the plan says, so that it cannot go on; empty if it was.
[[nodiscard]] std::string why_not_the_same(const TrainingPlan& plan, const Policy& policy);

class Training {
 public:
  /// Goes on with the test after those that the policy has learned from. REQUIRES:
  /// why_not_the_same() is empty.
  Training(TrainingPlan plan, std::shared_ptr<Policy> policy);

  enum class End { learned, interrupted, failed };
  /// Runs a generation of at most `most` tests and learns from it. `problem` says why it failed.
  [[nodiscard]] End run_generation(std::uint64_t most, std::string& problem);

  [[nodiscard]] const Policy& policy() const { return *policy_; }
  /// Remarks on its tests for the author of the AV's controller.
  [[nodiscard]] const ControllerNotes& notes() const { return notes_; }

 private:
  struct Lesson;
  [[nodiscard]] std::vector<Lesson> run_tests(std::uint64_t count, std::string& problem);
  void run_test(std::uint64_t number, Lesson& lesson);
  [[nodiscard]] std::string learn(std::vector<Lesson>& lessons);
  void note_point(const std::vector<Lesson>& lessons);

  TrainingPlan plan_;
  std::shared_ptr<Policy> policy_;
  TestRunners runners_;
  ControllerNotes notes_;
  Ground ground_;
  double discount_;  // of a tick
  std::set<std::string> covered_;
};

}  // namespace jaywalk
