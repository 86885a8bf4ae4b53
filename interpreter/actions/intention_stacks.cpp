// SPDX-License-Identifier: Apache-2.0
// Intentions as terms: their state, and their stack of plans with the remaining formulas of each.

#include <array>
#include <memory>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/agent/goals/goals.h"
#include "interpreter/agent/goals/waits.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

// The rest of a body, from the current formula of each level on. As in Jason it is the text as
// written, with unbound variables; the map of bindings has their values.
Value remaining_body(Agent& agent, const IntendedMeans& means) {
  Unifier& unifier = agent.machine().unifier();
  unifier.set_slot_names({});
  ScratchSlots slots(unifier, means.plan->slot_count);
  std::vector<Value> steps;
  for (const Step* step = means.current; step != nullptr; step = step->next) {
    if (!step->source.is_unset()) steps.push_back(unifier.instantiate(step->source, slots.data()));
  }
  const auto arity = static_cast<std::uint16_t>(steps.size());
  return agent.heap().structure(
      agent.symbols().predicate(Signature{.functor = names::body_text, .arity = arity}), steps,
      Value::empty_list(), Form::body);
}

Value trigger_term(Agent& agent, TriggerOperator op, TriggerKind kind, Value literal) {
  const std::string functor = trigger_operator(op, kind);
  literal = agent.machine().unifier().apply(literal);
  return agent.heap().structure(agent.symbols().predicate(functor, 1), std::span(&literal, 1),
                                Value::empty_list(), Form::trigger);
}

// [map(X,1), ...]: the slots that have values.
Value bindings_term(Agent& agent, Intention& intention, const IntendedMeans& means) {
  std::vector<Value> maps;
  for (std::uint32_t i = 0; i < means.plan->own_slots; ++i) {
    const Value value = deref(intention.frame(means)[i]);
    const bool is_named = means.plan->slot_names[i] != names::unnamed;
    if (!is_named || value.is_unset() || value.is_variable()) continue;
    const std::array<Value, 2> args{agent.heap().variable(means.plan->slot_names[i]),
                                    agent.machine().unifier().apply(value)};
    maps.push_back(agent.heap().structure(agent.symbols().predicate("map", 2), args));
  }
  return agent.heap().list(maps);
}

// [im(Label, {+!g}, {body}, [map(X,1)]), ...], the top first.
Value stack_term(Agent& agent, Intention& intention) {
  std::vector<Value> stack;
  Heap& heap = agent.heap();
  for (std::size_t i = intention.stack.size(); i > 0; --i) {
    const IntendedMeans& means = intention.stack[i - 1];
    Value label = agent.label_term(*means.plan);
    if (is_literal(label)) {
      const std::uint32_t line = means.is_finished() ? means.plan->line : means.step().place.line;
      const Value number = Value::number(line);
      const Value file = heap.text("file:" + means.plan->file);
      const std::array<Value, 2> place{heap.structure(predicates::code_line, std::span(&number, 1)),
                                       heap.structure(predicates::code_src, std::span(&file, 1))};
      label = with_annotations(
          heap, label,
          union_of(heap, literal_parts(label).annots, heap.list(place), agent.symbols()));
    }
    const std::array<Value, 4> parts{
        label, trigger_term(agent, means.op, means.kind, agent.goal_of(intention, means)),
        remaining_body(agent, means), bindings_term(agent, intention, means)};
    stack.push_back(heap.structure(agent.symbols().predicate("im", 4), parts));
  }
  // A copy: the open variables are those of the stack's own frames, perhaps of this very action.
  return agent.machine().unifier().fresh_copy(heap.list(stack));
}

std::string state_name(const Intention& intention) {
  if (intention.is_suspended()) return "suspended";
  const bool waits =
      intention.state == Intention::State::waiting || intention.state == Intention::State::acting;
  return waits ? "waiting" : "running";
}

class IntentionSolutions : public Solutions {
 public:
  explicit IntentionSolutions(std::vector<Intention*> all) : all_(std::move(all)) {}

  bool next(ActionCall& call) override {
    while (next_ < all_.size()) {
      Intention& intention = *all_[next_++];
      Agent& agent = *call.agent();
      const std::size_t trail = call.unifier().mark();
      Value state = Value::atom(agent.symbols().predicate(state_name(intention), 0));
      const bool waits = state_name(intention) == "waiting";
      if (waits) {
        const Value action = Waits(agent).pending_action(intention);
        const Value why = action.is_unset() ? Waits(agent).reason(intention) : action;
        const std::string_view name = action.is_unset() ? "reason" : "action";
        const Value reason =
            agent.heap().structure(agent.symbols().predicate(name, 1), std::span(&why, 1));
        state =
            with_annotations(agent.heap(), state, agent.heap().pair(reason, Value::empty_list()));
      }
      if (call.unify(0, Value::number(intention.id)) &&
          (call.count() < 2 || call.unify(1, state)) &&
          (call.count() < 3 || call.unify(2, stack_term(agent, intention)))) {
        return true;
      }
      call.unifier().undo(trail);
    }
    return false;
  }

 private:
  std::vector<Intention*> all_;
  std::size_t next_ = 0;
};

}  // namespace

Outcome intention(ActionCall& call) {
  Agent& agent = *call.agent();
  std::vector<Intention*> all = Goals(agent).all_intentions();
  if (call.count() == 4) {
    Intention* const current = call.intention() != nullptr ? call.intention() : agent.executing();
    all.clear();
    if (current != nullptr) all.push_back(current);
  }
  return call.many(std::make_unique<IntentionSolutions>(std::move(all)));
}

Outcome current_intention(ActionCall& call) {
  Agent& agent = *call.agent();
  Intention* const current = call.intention() != nullptr ? call.intention() : agent.executing();
  if (current == nullptr) return Outcome::failed;
  const std::array<Value, 2> parts{Value::number(current->id), stack_term(agent, *current)};
  return call.result(0, call.heap().structure(call.symbols().predicate("intention", 2), parts));
}

}  // namespace jaywalk::actions
