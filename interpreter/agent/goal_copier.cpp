// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/goal_copier.h"

#include <algorithm>

#include "interpreter/agent/circumstance/freed_rounds.h"

namespace jaywalk {
namespace {

// The same step of a copied plan.
const Step* step_of_copy(const Plan& plan, const Plan& copy, const Step* step) {
  for (std::size_t i = 0; i < plan.code.bodies.size(); ++i) {
    const std::vector<Step>& steps = plan.code.bodies[i].steps;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      if (&steps[k] == step) return &copy.code.bodies[i].steps[k];
    }
  }
  return step;
}

bool share_a_fork(const Intention& a, const Intention& b) {
  for (const Fork* fork = a.fork.get(); fork != nullptr; fork = fork->outer.get()) {
    for (const Fork* other = b.fork.get(); other != nullptr; other = other->outer.get()) {
      if (fork == other) return true;
    }
  }
  return false;
}

}  // namespace

void Agent::GoalCopier::copy() {
  choose();
  for (const auto& [id, intention] : chosen_) copy_intention(*intention);
  for (const auto& [id, copy] : copies_) {
    copy->fork = copy_of(copy->fork);
    copy->origin = id_of_copy(copy->origin);
  }
  clone_.unusual_ |= original_.unusual_ & Agent::kSubplans;
  copy_events();
}

void Agent::GoalCopier::choose() {
  for (const auto& intention : original_.circumstance_.intentions) {
    if (is_copied(*intention)) chosen_.emplace(intention->id, intention.get());
  }
  // A fork without one of its branches would never be done. Forks within it go, too.
  const auto cannot_join = [&](const auto& each) { return waits_in_fork(*each.second); };
  while (std::erase_if(chosen_, cannot_join) > 0) {
  }
}

bool Agent::GoalCopier::is_copied(const Intention& intention) const {
  const bool is_ready =
      intention.state == Intention::State::in_event || intention.state == Intention::State::running;
  return is_ready && &intention != original_.executing_ && !intention.is_finished() &&
         std::all_of(intention.stack.begin(), intention.stack.end(),
                     [&](const IntendedMeans& means) { return has_copied_code(means); });
}

bool Agent::GoalCopier::has_copied_code(const IntendedMeans& means) const {
  const bool is_of_plan = means.is_finished() || means.plan->code.has(means.step());
  return is_of_plan && copy_of(*means.plan) != nullptr;
}

// Some branch of its fork, or of one around that, is not copied.
bool Agent::GoalCopier::waits_in_fork(const Intention& intention) const {
  if (intention.fork == nullptr) return false;
  return std::ranges::any_of(original_.circumstance_.intentions, [&](const auto& other) {
    return other->state != Intention::State::finished && !chosen_.contains(other->id) &&
           share_a_fork(intention, *other);
  });
}

void Agent::GoalCopier::copy_intention(Intention& intention) {
  Intention& copy = clone_.new_intention();
  copies_.emplace(intention.id, &copy);
  copy.stack = intention.stack;
  copy.atomic_means = intention.atomic_means;
  copy.fork = intention.fork;
  copy.origin = intention.origin;
  copy.shared = intention.shared;
  copy_terms(intention, copy);
  for (IntendedMeans& means : copy.stack) copy_code(means);
  if (intention.state == Intention::State::running) {
    clone_.make_ready(copy);
  } else {
    copy.state = Intention::State::in_event;
  }
}

// Bindings of loops are copied as places and values, so that the clone can undo them, too.
void Agent::GoalCopier::copy_terms(Intention& intention, Intention& copy) {
  const FreedRounds freed(intention);
  copy.values = intention.values;
  copy.visit_terms([&](Value& value) {
    if (!value.is_slot()) value = transfer_.copy(value);
  });
  for (const FreedRounds::Held& held : freed.held()) {
    const Value place = held.place.is_slot() ? held.place : transfer_.copy(held.place);
    FreedRounds::cell_of(copy, held.means, place) = transfer_.copy(held.value);
  }
}

void Agent::GoalCopier::copy_code(IntendedMeans& means) {
  const Plan& plan = *means.plan;
  const Plan& copy = *copy_of(plan);
  means.current = step_of_copy(plan, copy, means.current);
  means.plan = &copy;
  if (means.extras) {
    means.extras->codes.clear();
    for (Loop& loop : means.extras->loops) loop.step = step_of_copy(plan, copy, loop.step);
    means.extras->scope = copy_of(means.extras->scope);
  }
  if (copy.has_goal_condition) {
    ++clone_.goal_conditions_;
    clone_.attention_ = true;
    clone_.changed_ = true;
  }
}

void Agent::GoalCopier::copy_events() {
  for (Event event : original_.circumstance_.events) {
    if (event.intention != nullptr) {
      const auto copy = copies_.find(event.intention->id);
      if (copy == copies_.end()) continue;
      event.intention = copy->second;
    }
    event.literal = transfer_.copy(event.literal);
    clone_.add_event(event);
  }
}

std::shared_ptr<Fork> Agent::GoalCopier::copy_of(const std::shared_ptr<Fork>& fork) {
  if (fork == nullptr) return nullptr;
  std::shared_ptr<Fork>& copy = forks_[fork.get()];
  if (copy != nullptr) return copy;
  copy = std::make_shared<Fork>(*fork);
  for (std::uint32_t& id : copy->branches) id = id_of_copy(id);
  copy->outer = copy_of(fork->outer);
  return copy;
}

ScopePtr Agent::GoalCopier::copy_of(const ScopePtr& scope) {
  if (scope == nullptr) return nullptr;
  ScopePtr& copy = scopes_[scope.get()];
  if (copy != nullptr) return copy;
  copy = std::make_shared<Scope>(*scope);
  for (Value& value : copy->frame) value = transfer_.copy(value);
  copy->outer = copy_of(scope->outer);
  return copy;
}

// Null: it was removed from the plan library. Plans of programs are shared, and stay.
const Plan* Agent::GoalCopier::copy_of(const Plan& plan) const {
  const auto copy = plans_.find(&plan);
  if (copy != plans_.end()) return copy->second;
  return plan.source.is_static() ? &plan : nullptr;
}

// 0, which no intention has, if the intention does not exist any more.
std::uint32_t Agent::GoalCopier::id_of_copy(std::uint32_t id) const {
  const auto copy = copies_.find(id);
  return copy == copies_.end() ? 0 : copy->second->id;
}

}  // namespace jaywalk
