// SPDX-License-Identifier: Apache-2.0
#pragma once

// What agents have learned: a policy file of `jaywalk learn` says how probable the plans labelled
// learned(P) are, given what an agent observes. A scenario takes policies by name
// (ScenarioChoice::policies); other programs give one to an interpreter: `Interpreter
// interpreter({.policies = policy.choices()})`.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <jaywalk/diagnostics.h>

namespace jaywalk {

class OptionPolicies;
class Policy;

class LearnedPolicy {
 public:
  /// Errors have their place in the file.
  [[nodiscard]] static Result<LearnedPolicy> read(const std::string& path);

  /// The behaviour, and how many tests it was learned from.
  [[nodiscard]] const std::string& behaviour() const;
  [[nodiscard]] std::uint64_t tests() const;
  /// Its parts: P of each learned(P), and the labels of the plans that it knows.
  struct Part {
    std::string name;
    std::vector<std::string> options;
  };
  [[nodiscard]] std::vector<Part> parts() const;

  /// For MasOptions::policies: exploits what was learned. Lives as long as this and its copies.
  [[nodiscard]] OptionPolicies* choices() const { return choices_.get(); }

 private:
  explicit LearnedPolicy(std::shared_ptr<const Policy> policy);
  std::shared_ptr<const Policy> policy_;
  std::shared_ptr<OptionPolicies> choices_;
};

}  // namespace jaywalk
