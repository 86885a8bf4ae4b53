// SPDX-License-Identifier: Apache-2.0
// Saves, restores and copies frames and variables: the bindings of a loop's round are undone before
// the next, and a fork gives each branch a copy of the whole stack.

#include <algorithm>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/circumstance/freed_rounds.h"

namespace jaywalk {
namespace {

Value variable_of(Value* cell) { return Value::reference(Value::Kind::variable, cell, 0); }

}  // namespace

// Bindings made by a step are for good, unless the step is in a loop: then the round remembers
// them.
void Agent::note_for_round(Intention& intention, std::size_t trail) {
  const IntendedMeans& means = intention.top();
  std::vector<Value>& bound = means.extras->loops.back().bound;
  Value* const first = intention.frame(means);
  Value* const last = first + means.plan->slot_count;
  for (Value* const cell : machine().unifier().bindings_since(trail)) {
    if (cell >= first && cell < last) {
      bound.push_back(Value::slot(static_cast<std::uint32_t>(cell - first)));
    } else if (!machine().is_in_frame(cell)) {
      bound.push_back(variable_of(cell));
    }
  }
}

void Agent::undo_round(Intention& intention, Loop& loop) {
  Value* const frame = intention.frame(intention.top());
  for (const Value bound : loop.bound) {
    if (bound.is_slot()) {
      frame[bound.slot_index()] = Value();
    } else {
      bound.variable()->value = Value();
    }
  }
  loop.bound.clear();
}

void Agent::bind_recorded(Intention& intention, Loop& loop, Value place, Value value) {
  if (place.is_slot()) {
    intention.frame(intention.top())[place.slot_index()] = value;
  } else {
    place.variable()->value = value;
  }
  loop.bound.push_back(place);
}

Intention* Agent::find_intention(std::uint32_t id) {
  // They stand in the order of their numbers.
  const auto& all = circumstance_.intentions;
  const auto found = std::lower_bound(
      all.begin(), all.end(), id, [](const std::unique_ptr<Intention>& each, std::uint32_t number) {
        return each->id < number;
      });
  const bool exists = found != all.end() && (*found)->id == id;
  return exists && (*found)->state != Intention::State::finished ? found->get() : nullptr;
}

// The same stack with variables of its own.
Intention& Agent::copy_for_branch(Intention& intention) {
  const FreedRounds freed(intention);
  Intention& copy = new_intention();
  copy.stack = intention.stack;
  copy.atomic_means = intention.atomic_means;
  for (const IntendedMeans& means : copy.stack) {
    if (!means.plan->has_goal_condition) continue;
    ++goal_conditions_;
    attention_ = true;
  }
  copy.fork = intention.fork;
  copy.values = intention.values;
  heap_.note_other_bytes(intention.bytes());
  // All terms are renamed together, so that shared variables stay shared.
  std::vector<Value> terms;
  const auto note = [&](Value value) { terms.push_back(value.is_slot() ? Value() : value); };
  copy.visit_terms(note);
  for (const FreedRounds::Held& held : freed.held()) {
    note(held.place);
    note(held.value);
  }
  Value renamed = machine().unifier().fresh_copy(heap_.list(terms));
  const auto next = [&] {
    const Value value = renamed.pair()->head;
    renamed = renamed.pair()->tail;
    return value;
  };
  copy.visit_terms([&](Value& value) {
    const Value now = next();
    if (!value.is_slot()) value = now;
  });
  for (const FreedRounds::Held& held : freed.held()) {
    const Value variable = next();
    const Value place = held.place.is_slot() ? held.place : variable;
    FreedRounds::cell_of(copy, held.means, place) = next();
  }
  return copy;
}

void Agent::execute_fork(Intention& intention, const Step& step) {
  heap_.require_bytes(step.branches.size() * intention.bytes());
  auto fork = std::make_shared<Fork>();
  fork->is_or = step.kind == Step::Kind::fork_or;
  fork->depth = intention.stack.size();
  fork->open = step.branches.size();
  fork->outer = intention.fork;
  for (const Body* const branch : step.branches) {
    Intention& copy = copy_for_branch(intention);
    copy.fork = fork;
    fork->branches.push_back(copy.id);
    copy.go_on_at(branch->begin(step.next));
    make_ready(copy);
  }
  drop(intention);
}

// The end of a branch: the last of an `|&|`, the first of an `|||` goes on behind the fork.
void Agent::execute_join(Intention& intention) {
  const std::shared_ptr<Fork> fork = intention.fork;
  if (fork == nullptr) {
    go_on(intention);
    return;
  }
  --fork->open;
  if (!fork->is_or && fork->open > 0) {
    drop(intention);
    return;
  }
  for (const std::uint32_t id : fork->branches) {
    Intention* const other = id == intention.id ? nullptr : find_intention(id);
    if (other != nullptr) drop(*other);
  }
  intention.fork = fork->outer;
  go_on(intention);
}

// A branch has failed and no plan above the fork handles it. True: the failure is settled.
bool Agent::leave_failed_branch(Intention& intention) {
  const std::shared_ptr<Fork> fork = intention.fork;
  --fork->open;
  if (fork->is_or && fork->open > 0) {
    drop(intention);
    return true;
  }
  for (const std::uint32_t id : fork->branches) {
    Intention* const other = id == intention.id ? nullptr : find_intention(id);
    if (other != nullptr) drop(*other);
  }
  intention.fork = fork->outer;
  return false;
}

}  // namespace jaywalk
