// SPDX-License-Identifier: Apache-2.0
// Perception: belief update (logic/beliefs/belief_update.cpp) and its events, first those of
// percepts that are gone, then those of new ones. Where no plan could handle such an event, none is
// made, and a percept that has only changed its arguments is overwritten.

#include "interpreter/agent/agent.h"

namespace jaywalk {

void Agent::update_percepts(const Percepts& percepts, const KnownToAll& known) {
  start_if_due();
  if (known.percepts != nullptr) beliefs_.share_constants(*known.percepts);
  const bool by_changes = percepts.looks() == seen_looks_ + 1 && beliefs_.knows_percepts();
  seen_looks_ = percepts.looks();
  if (settings_.cycles_per_look > 1) {
    if (unseen_ == nullptr) unseen_ = std::make_unique<Percepts>();
    attention_ = true;
    *unseen_ = percepts;
    return;
  }
  if (by_changes && !hears_of_percepts()) {
    believe_quietly(percepts);
  } else if (by_changes) {
    believe_changes(percepts);
  } else {
    believe_percepts(percepts);
  }
  for (const auto& rules : known.rules) beliefs_.fold(*rules);
}

void Agent::perceive_now() {
  if (unseen_ == nullptr) return;
  believe_percepts(*unseen_);
  unseen_.reset();
}

void Agent::believe_percepts(const Percepts& percepts) {
  beliefs_.begin_percepts();
  for (std::size_t i = 0; i < percepts.size(); ++i) believe_percept(percepts, i);
  beliefs_.end_percepts(work().percept_changes.gone);
  announce_percepts();
}

void Agent::believe_changes(const Percepts& percepts) {
  if (percepts.news().empty() && percepts.gone_size() == 0) return;
  beliefs_.begin_percepts();
  for (const std::uint32_t index : percepts.news()) believe_percept(percepts, index);
  for (std::size_t i = 0; i < percepts.gone_size(); ++i) {
    beliefs_.miss(percepts.gone_predicate(i), percepts.gone_args(i));
  }
  beliefs_.end_missed(work().percept_changes.gone);
  announce_percepts();
}

// Whether an event about a changed percept could have any effect.
bool Agent::hears_of_percepts() const {
  return library_->has_belief_plans() || (unusual_ & kShowsEvents) != 0 ||
         !circumstance_.waits.empty() || (unusual_ & kSubplans) != 0 ||
         settings_.unwanted != ReasoningSettings::Unwanted::discard;
}

// Like believe_changes, without events.
void Agent::believe_quietly(const Percepts& percepts) {
  const std::span<const std::uint32_t> news = percepts.news();
  const std::size_t gone = percepts.gone_size();
  if (news.empty() && gone == 0) return;
  beliefs_.begin_percepts();
  const bool only_changed = percepts.changed_size() == news.size() && gone == news.size();
  bool is_some_left = !only_changed;
  for (std::size_t i = 0; i < news.size(); ++i) {
    const Predicate predicate = percepts.predicate(news[i]);
    const std::span<const Value> args = percepts.args(news[i]);
    BeliefBase::PerceptChange change;
    const Value annotations = percepts.annotations(news[i]);
    if (only_changed && annotations.is_empty_list() &&
        beliefs_.change_percept(predicate, percepts.gone_args(i), args)) {
      changed_ = true;
    } else {
      is_some_left = true;
      if (beliefs_.perceive(predicate, args, change, annotations)) changed_ = true;
    }
  }
  if (!is_some_left) return;
  for (std::size_t i = 0; i < gone; ++i) {
    beliefs_.miss(percepts.gone_predicate(i), percepts.gone_args(i));
  }
  auto& changes = work().percept_changes.gone;
  beliefs_.end_missed(changes);
  if (!changes.empty()) changed_ = true;
  changes.clear();
}

void Agent::believe_percept(const Percepts& percepts, std::size_t index) {
  BeliefBase::PerceptChange change;
  if (beliefs_.perceive(percepts.predicate(index), percepts.args(index), change,
                        percepts.annotations(index))) {
    work().percept_changes.news.push_back(change);
  }
}

void Agent::announce_percepts() {
  auto& [gone, news] = work().percept_changes;
  for (auto* const changes : {&gone, &news}) {
    for (const BeliefBase::PerceptChange& change : *changes) {
      add_event({change.added ? TriggerOperator::add : TriggerOperator::remove, TriggerKind::belief,
                 change.literal, nullptr});
    }
    changes->clear();
  }
}

}  // namespace jaywalk
