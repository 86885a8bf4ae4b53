// SPDX-License-Identifier: Apache-2.0
#include "interpreter/program/plan.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace jaywalk {

void BodyCode::link(const Step* after) {
  // An outer body stands behind the inner ones. A branch of a fork is there twice, the first time
  // without its end, and nothing leads there.
  std::unordered_map<const Body*, const Step*> followers;
  for (auto body = bodies.rbegin(); body != bodies.rend(); ++body) {
    const auto follower = followers.find(&*body);
    const Step* next = follower == followers.end() ? after : follower->second;
    for (auto step = body->steps.rbegin(); step != body->steps.rend(); ++step) {
      step->next = next;
      next = &*step;
      const bool is_loop =
          step->kind == Step::Kind::while_loop || step->kind == Step::Kind::for_loop;
      const Step* const after_inner = is_loop ? &*step : step->next;
      followers.try_emplace(step->first, after_inner);
      followers.try_emplace(step->second, after_inner);
      for (const Body* const branch : step->branches) followers.try_emplace(branch, after_inner);
    }
  }
}

bool BodyCode::has(const Step& step) const {
  return std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) {
    return !body.steps.empty() && !std::less<>{}(&step, &body.steps.front()) &&
           !std::less<>{}(&body.steps.back(), &step);
  });
}

void PlanList::add(const Plan& plan) {
  plans_.push_back(&plan);
  is_short_ = plans_.size() <= kUnindexedPlans;
  has_learned_ = has_learned_ || !plan.policy.is_unset();
  if (plans_.size() <= kUnindexedPlans) return;
  const auto index = [this](std::size_t place) {
    const std::uint64_t key = plans_[place]->first_key;
    (key == 0 ? wild_ : by_first_key_[key]).push_back(static_cast<std::uint32_t>(place));
  };
  if (plans_.size() == kUnindexedPlans + 1) {
    for (std::size_t i = 0; i < kUnindexedPlans; ++i) index(i);
  }
  index(plans_.size() - 1);
}

void PlanLibrary::insert(const Plan& plan) {
  if (plan.key.op == TriggerOperator::goal_state) ++goal_state_plans_;
  if (plan.key.kind == TriggerKind::belief) ++belief_plans_;
  if (!plan.policy.is_unset()) ++learned_plans_;
  const TriggerKey message{TriggerOperator::add, TriggerKind::achieve, predicates::kqml_received};
  if (!plan.is_standard && !plan.any_predicate && plan.key == message) ++message_plans_;
  if (!plan.any_predicate) {
    std::uint32_t place = index_.find(packed(plan.key));
    if (place == FlatIndex<std::uint64_t>::kNone) {
      place = static_cast<std::uint32_t>(lists_.size());
      index_.insert(packed(plan.key), place);
      keys_.push_back(plan.key);
      // Variable triggers that came before stand before.
      lists_.push_back(any_[kind_index(plan.key)]);
    }
    lists_[place].add(plan);
    return;
  }
  any_[kind_index(plan.key)].add(plan);
  for (std::size_t i = 0; i < lists_.size(); ++i) {
    if (kind_index(keys_[i]) == kind_index(plan.key)) lists_[i].add(plan);
  }
}

void PlanLibrary::rebuild() {
  index_.clear();
  lists_.clear();
  keys_.clear();
  any_.fill({});
  goal_state_plans_ = 0;
  message_plans_ = 0;
  belief_plans_ = 0;
  learned_plans_ = 0;
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

void link(Plan& plan, const PlanLibrary& library) {
  for (const auto& made : plan.code.events) {
    if (!made->event) continue;
    made->library = &library;
    made->plans = &library.list(*made->event);
  }
}

}  // namespace jaywalk
