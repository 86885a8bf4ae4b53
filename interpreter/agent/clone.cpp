// `.clone`: an agent that begins as a copy of another.

#include <algorithm>
#include <map>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/own_parts.h"
#include "interpreter/logic/formula_compiler.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {
namespace {

// Where a body stands among the bodies of its plan; the number of them if it is not the plan's own.
std::size_t body_index(const Plan& plan, const Body* body) {
  const auto found = std::find_if(plan.code.bodies.begin(), plan.code.bodies.end(),
                                  [&](const Body& each) { return &each == body; });
  return static_cast<std::size_t>(found - plan.code.bodies.begin());
}

// Loops refer to steps by address, scopes and bodies made at run time to the agent they belong to.
bool can_be_copied(const Intention& intention) {
  if (intention.fork != nullptr || intention.is_finished()) return false;
  return std::all_of(intention.stack.begin(), intention.stack.end(), [](const auto& means) {
    const auto is_own = [&](const Cursor& cursor) {
      return cursor.code == nullptr &&
             body_index(*means.plan, cursor.body) < means.plan->code.bodies.size();
    };
    return means.scope == nullptr && means.loops.empty() && is_own(means.cursor) &&
           std::all_of(means.outer.begin(), means.outer.end(), is_own);
  });
}

}  // namespace

void Agent::copy_from(const Agent& original) {
  customisation_ = original.customisation_;
  settings_ = original.settings_;
  Transfer transfer(heap_);
  copy_beliefs(original, transfer);
  copy_goals(original, transfer, copy_plans(original, transfer));
  heap_.protect();
}

void Agent::copy_beliefs(const Agent& original, Transfer& transfer) {
  for (const auto& relation : original.beliefs_.relations()) {
    // From what is asked last to what is asked first.
    for (std::int64_t seq = relation->first_seq(); seq < relation->end_seq(); ++seq) {
      const Row& row = relation->row(seq);
      if (row.rule == nullptr) {
        if (!row.fact.is_unset()) (void)beliefs_.add(transfer.copy(row.fact));
      } else if (row.rule->source.is_static()) {
        beliefs_.add_rule(*row.rule, Place::front);
      } else {
        const Value rule = transfer.copy(row.rule->source);
        beliefs_.add_rule(make_rule(rule.structure()->arg(0), rule.structure()->arg(1),
                                    row.rule->slot_names, heap_, machine().actions(), symbols_),
                          Place::front);
      }
    }
  }
}

// The original's plans and what each has become.
Agent::PlanMap Agent::copy_plans(const Agent& original, Transfer& transfer) {
  PlanMap copies;
  const auto add = [&](const Plan& plan, const Plan& copy) {
    copies.emplace(&plan, &copy);
    if (original.own_ == nullptr) return;
    const auto label = original.own_->labels.find(&plan);
    if (label == original.own_->labels.end()) return;
    own().labels.emplace(&copy, transfer.copy(label->second));
  };
  if (original.own_ == nullptr || original.own_->library == nullptr) {
    for (const auto& plan : library_->plans()) add(*plan, *plan);
    return copies;
  }
  own().included = original.own_->included;
  own().library = std::make_unique<PlanLibrary>();
  library_ = own().library.get();
  for (const auto& plan : original.library_->plans()) {
    std::shared_ptr<const Plan> copy = plan;
    if (!plan->source.is_static()) {
      const auto made = compile_plan(transfer.copy(plan->source), plan->slot_names,
                                     machine().actions(), symbols_);
      made->label = transfer.copy(plan->label);
      made->file = plan->file;
      made->line = plan->line;
      own().plans.push_back(made);
      copy = made;
    }
    add(*plan, *copy);
    own().library->add(copy);
  }
  return copies;
}

// Goals that are still events, and intentions that are running. What waits for time, an answer or
// an action does not wait a second time.
void Agent::copy_goals(const Agent& original, Transfer& transfer, const PlanMap& plans) {
  std::map<const Intention*, Intention*> copies;
  for (const auto& intention : original.circumstance_.intentions) {
    const bool in_event = intention->state == Intention::State::in_event;
    const bool running = intention->state == Intention::State::running;
    if (intention.get() == original.executing_ || (!in_event && !running) ||
        !can_be_copied(*intention) ||
        !std::all_of(intention->stack.begin(), intention->stack.end(),
                     [&](const IntendedMeans& means) { return plans.contains(means.plan); })) {
      continue;  // (a plan that is in use may have been removed)
    }
    Intention& copy = new_intention();
    copies.emplace(intention.get(), &copy);
    copy.stack = intention->stack;
    copy.values = intention->values;
    copy.atomic_means = intention->atomic_means;
    copy.visit_terms([&](Value& value) { value = transfer.copy(value); });
    for (IntendedMeans& means : copy.stack) {
      const Plan& plan = *plans.at(means.plan);
      const auto move_to_copy = [&](Cursor& cursor) {
        cursor.body = &plan.code.bodies[body_index(*means.plan, cursor.body)];
      };
      move_to_copy(means.cursor);
      for (Cursor& cursor : means.outer) move_to_copy(cursor);
      means.plan = &plan;
    }
    if (running) make_ready(copy);
  }
  for (Event event : original.circumstance_.events) {
    if (event.intention != nullptr) {
      const auto copy = copies.find(event.intention);
      if (copy == copies.end()) continue;
      event.intention = copy->second;
    }
    event.literal = transfer.copy(event.literal);
    add_event(event);
  }
}

}  // namespace jaywalk
