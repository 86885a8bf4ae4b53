// SPDX-License-Identifier: Apache-2.0
#include "experiment/policy/policy.h"

#include <algorithm>
#include <array>
#include <cassert>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/networks/random.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

std::uint64_t seed_of(std::string_view name, std::uint64_t seed) {
  for (const char letter : name) seed = mix(seed, static_cast<unsigned char>(letter));
  return seed;
}

constexpr std::array kLearners = {
#define JAYWALK_LEARNER(function, name, summary) LearnerKind{name, summary, learners::function},
#include "experiment/policy/learners.def"
#undef JAYWALK_LEARNER
};

}  // namespace

std::vector<LearnedPlans> learned_plans(const Program& program, const SymbolTable& symbols) {
  std::vector<LearnedPlans> all;
  for (const auto& plan : program.library().plans()) {
    if (plan->policy.is_unset()) continue;
    const std::string policy(symbols.functor(plan->policy.atom_id()));
    auto found = std::ranges::find(all, policy, &LearnedPlans::policy);
    if (found == all.end()) found = all.insert(all.end(), {.policy = policy, .options = {}});
    found->options.emplace_back(symbols.functor(literal_parts(plan->label).predicate));
  }
  return all;
}

Policy::Policy(PolicyOrigin origin, std::span<const LearnedPlans> plans)
    : origin_(std::move(origin)) {
  for (const LearnedPlans& each : plans) {
    parts_.push_back({.name = each.policy, .shape = {.options = each.options}, .learner = nullptr});
  }
}

std::vector<LearnedPlans> Policy::plans() const {
  std::vector<LearnedPlans> plans;
  for (const Part& part : parts_) {
    plans.push_back({.policy = part.name, .options = part.shape.options});
  }
  return plans;
}

const Policy::Part* Policy::find(std::string_view name) const {
  const auto found = std::ranges::find(parts_, name, &Part::name);
  return found == parts_.end() ? nullptr : &*found;
}

void Policy::make_learner(Part& part, std::size_t features) const {
  const LearnerKind* const kind = find_learner(origin_.spec.learner);
  assert(kind != nullptr && "checked where it was read");
  part.shape.features = features;
  part.learner = kind->make(part.shape, origin_.spec.settings, seed_of(part.name, origin_.seed));
}

std::optional<std::vector<std::uint32_t>> Policy::numbers(
    std::string_view policy, std::span<const std::string> options) const {
  const Part* const part = find(policy);
  if (part == nullptr) return std::nullopt;
  std::vector<std::uint32_t> numbers;
  for (const std::string& option : options) {
    const auto found = std::ranges::find(part->shape.options, option);
    if (found == part->shape.options.end()) return std::nullopt;
    numbers.push_back(static_cast<std::uint32_t>(found - part->shape.options.begin()));
  }
  return numbers;
}

std::string Policy::weigh(const LearnedChoice& choice, Learner::Mode mode,
                          std::span<double> probabilities) const {
  const Part* const part = find(choice.policy);
  if (part == nullptr) return {};
  const auto known = numbers(choice.policy, choice.options);
  if (!known) {
    return fmt::format("the policy {} knows the options {}, not all of {}", choice.policy,
                       fmt::join(part->shape.options, ", "), fmt::join(choice.options, ", "));
  }
  if (part->learner == nullptr) return {};
  if (part->shape.features != choice.features.size()) {
    return fmt::format("the policy {} was learned from {} numbers, observed are {}", choice.policy,
                       part->shape.features, choice.features.size());
  }
  part->learner->weigh(choice.features, *known, mode, probabilities);
  return {};
}

double Policy::value(std::string_view policy, std::span<const double> features) const {
  const Part* const part = find(policy);
  return part == nullptr || part->learner == nullptr ? 0 : part->learner->value(features);
}

std::optional<std::size_t> Policy::features(std::string_view policy) const {
  const Part* const part = find(policy);
  if (part == nullptr || part->learner == nullptr) return std::nullopt;
  return part->shape.features;
}

void Policy::learn(std::string_view policy, std::span<const Episode> generation) {
  const auto part = std::ranges::find(parts_, policy, &Part::name);
  assert(part != parts_.end());
  if (generation.empty()) return;
  if (part->learner == nullptr) make_learner(*part, generation.front().front().features.size());
  part->learner->learn(generation);
}

std::string mismatch(const Policy& policy, std::span<const LearnedPlans> plans) {
  const std::vector<LearnedPlans> known = policy.plans();
  if (std::ranges::equal(known, plans)) return {};
  const auto text = [](std::span<const LearnedPlans> all) {
    std::vector<std::string> parts;
    for (const LearnedPlans& each : all) {
      parts.push_back(fmt::format("{} of {}", fmt::join(each.options, ", "), each.policy));
    }
    return parts.empty() ? std::string("none") : fmt::format("{}", fmt::join(parts, "; "));
  };
  return fmt::format("the program's options are {}, the policy's {}", text(plans), text(known));
}

std::span<const LearnerKind> learner_kinds() { return kLearners; }

const LearnerKind* find_learner(std::string_view name) {
  const auto found = std::ranges::find(kLearners, name, &LearnerKind::name);
  return found == kLearners.end() ? nullptr : &*found;
}

}  // namespace jaywalk
