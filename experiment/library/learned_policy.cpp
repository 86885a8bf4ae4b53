// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "experiment/policy/policy.h"
#include <jaywalk/policy.h>

namespace jaywalk {

LearnedPolicy::LearnedPolicy(std::shared_ptr<const Policy> policy)
    : policy_(policy), choices_(std::make_shared<PolicyReader>(std::move(policy))) {}

Result<LearnedPolicy> LearnedPolicy::read(const std::string& path) {
  const auto source = read_source(path);
  if (!source) return source.diagnostics();
  auto policy = parse_policy(source.value());
  if (!policy) return std::move(policy.diagnostics());
  return LearnedPolicy(std::move(policy).value());
}

const std::string& LearnedPolicy::behaviour() const { return policy_->origin().behaviour; }
std::uint64_t LearnedPolicy::tests() const { return policy_->origin().tests; }

std::vector<LearnedPolicy::Part> LearnedPolicy::parts() const {
  std::vector<Part> parts;
  for (const LearnedPlans& plans : policy_->plans()) {
    parts.push_back({.name = plans.policy, .options = plans.options});
  }
  return parts;
}

}  // namespace jaywalk
