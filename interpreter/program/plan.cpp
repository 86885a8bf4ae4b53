#include "interpreter/program/plan.h"

#include <algorithm>

namespace jaywalk {

void PlanLibrary::insert(const Plan& plan) {
  if (plan.key.op == TriggerOperator::goal_state) ++goal_state_plans_;
  if (!plan.any_predicate) {
    auto [entry, is_new] = by_key_.try_emplace(plan.key);
    // Variable triggers that came before stand before.
    if (is_new) entry->second = any_[kind_index(plan.key)];
    entry->second.push_back(&plan);
    return;
  }
  any_[kind_index(plan.key)].push_back(&plan);
  for (auto& [key, plans] : by_key_) {
    if (kind_index(key) == kind_index(plan.key)) plans.push_back(&plan);
  }
}

void PlanLibrary::rebuild() {
  by_key_.clear();
  for (auto& any : any_) any.clear();
  goal_state_plans_ = 0;
  for (const auto& plan : plans_) insert(*plan);
}

void PlanLibrary::add(std::shared_ptr<const Plan> plan) {
  insert(*plan);
  plans_.push_back(std::move(plan));
}

void PlanLibrary::add_first(std::shared_ptr<const Plan> plan) {
  plans_.insert(plans_.begin(), std::move(plan));
  rebuild();
}

void PlanLibrary::remove(const Plan& plan) {
  std::erase_if(plans_, [&](const auto& known) { return known.get() == &plan; });
  rebuild();
}

const std::vector<const Plan*>& PlanLibrary::candidates(const TriggerKey& key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? any_[kind_index(key)] : found->second;
}

}  // namespace jaywalk
