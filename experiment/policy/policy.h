// SPDX-License-Identifier: Apache-2.0
#pragma once

// A policy file: what agents have learned, where and how (`jaywalk learn`). A behaviour's plans
// that are labelled learned(P) are the options of its part P. Read learner.h first.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/policy/learner.h"
#include "interpreter/agent/surroundings/learned_choice.h"
#include "interpreter/program/program.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/term/symbol.h"

namespace jaywalk {

/// The options of one policy of a program: P of learned(P), and the plans' labels in their order.
struct LearnedPlans {
  std::string policy;
  std::vector<std::string> options;

  friend bool operator==(const LearnedPlans&, const LearnedPlans&) = default;
};

[[nodiscard]] std::vector<LearnedPlans> learned_plans(const Program& program,
                                                      const SymbolTable& symbols);

/// How learning went: the tests of one generation or several.
struct LearningPoint {
  /// Tests that had been learned from, these included.
  std::uint64_t tests = 0;
  /// Means over these tests: the agents' discounted reward, and the share of those that met the
  /// precondition.
  double reward = 0;
  double success_pct = 0;

  friend bool operator==(const LearningPoint&, const LearningPoint&) = default;
};

/// The program, scenario and tests from which a policy was learned.
struct PolicyOrigin {
  std::string behaviour;
  /// The hash of all texts of the behaviour's program.
  std::string program_sha256;
  /// The scenario's file, and its hash with the values set on top of it.
  std::string scenario;
  std::string scenario_sha256;
  std::uint32_t agents = 1;
  std::uint64_t seed = 0;
  std::uint64_t tests = 0;
  /// Tests that ended errored, of which nothing was learned.
  std::uint64_t errored = 0;
  LearningSpec spec;
  std::vector<LearningPoint> curve;
  /// The bins of situations that were covered, as item and bin, if that was rewarded.
  std::vector<std::string> covered;
};

class Policy {
 public:
  /// Has learned nothing.
  Policy(PolicyOrigin origin, std::span<const LearnedPlans> plans);

  [[nodiscard]] const PolicyOrigin& origin() const { return origin_; }
  [[nodiscard]] PolicyOrigin& origin() { return origin_; }
  /// The learned plans: policies and their options.
  [[nodiscard]] std::vector<LearnedPlans> plans() const;

  /// As OptionPolicies; other policies than its own leave the options as probable as they are.
  [[nodiscard]] std::string weigh(const LearnedChoice& choice, Learner::Mode mode,
                                  std::span<double> probabilities) const;
  /// The numbers of options in a part; nothing if it does not know the part, or one of them.
  [[nodiscard]] std::optional<std::vector<std::uint32_t>> numbers(
      std::string_view policy, std::span<const std::string> options) const;
  /// The reward expected where these features are observed; 0: not known.
  [[nodiscard]] double value(std::string_view policy, std::span<const double> features) const;
  /// How many features a part observes; nothing if it has learned nothing.
  [[nodiscard]] std::optional<std::size_t> features(std::string_view policy) const;

  /// Episodes of one part, of a generation. REQUIRES: its own options, and always as many features.
  void learn(std::string_view policy, std::span<const Episode> generation);

  /// As a file has it.
  [[nodiscard]] std::string text() const;

 private:
  friend Result<std::shared_ptr<Policy>> parse_policy(const SourcePtr& source);
  struct Part {
    std::string name;
    PolicyShape shape;
    std::unique_ptr<Learner> learner;  // null: nothing has been learned
  };
  [[nodiscard]] const Part* find(std::string_view name) const;
  void make_learner(Part& part, std::size_t features) const;

  PolicyOrigin origin_;
  std::vector<Part> parts_;
};

/// Errors have their place in the file where that is known.
[[nodiscard]] Result<std::shared_ptr<Policy>> parse_policy(const SourcePtr& source);

/// Why the policy is not for a program with these plans; empty if it is.
[[nodiscard]] std::string mismatch(const Policy& policy, std::span<const LearnedPlans> plans);

/// The policy for agents, which exploits what was learned and does not explore.
class PolicyReader final : public OptionPolicies {
 public:
  explicit PolicyReader(std::shared_ptr<const Policy> policy) : policy_(std::move(policy)) {}
  [[nodiscard]] std::string weigh(const LearnedChoice& choice,
                                  std::span<double> probabilities) override {
    return policy_->weigh(choice, Learner::Mode::exploit, probabilities);
  }

 private:
  std::shared_ptr<const Policy> policy_;
};

}  // namespace jaywalk
