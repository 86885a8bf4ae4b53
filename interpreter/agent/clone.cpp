// SPDX-License-Identifier: Apache-2.0
// `.clone`: an agent that begins as a copy of another.

#include "interpreter/agent/agent.h"
#include "interpreter/agent/goal_copier.h"
#include "interpreter/agent/own_parts.h"
#include "interpreter/logic/formula_compiler.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/transfer.h"

namespace jaywalk {
void Agent::copy_from(const Agent& original) {
  customisation_ = original.customisation_;
  settings_ = original.settings_;
  unusual_ |= original.unusual_ & kSelectsByRules;
  Transfer transfer(heap_);
  copy_beliefs(original, transfer);
  const PlanMap plans = copy_plans(original, transfer);
  note_unusual();
  GoalCopier(original, *this, transfer, plans).copy();
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

// Maps the original's plans to their copies.
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

}  // namespace jaywalk
