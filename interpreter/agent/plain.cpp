// The plain plans and means of strides (stride.cpp): from a formula to the literal of its event,
// and from there to the plan that is chosen and the means that carries it out.
//
// Of anything unusual (annotations, terms in variables, other namespaces) the functions here know
// no more than that it is, and leave it to execute.cpp and cycle.cpp.

#include "interpreter/agent/plain.h"

#include <algorithm>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/context.h"
#include "interpreter/agent/numbers.h"
#include "interpreter/agent/step_guard.h"

namespace jaywalk {
namespace {

// The goal of the event is the one that the caller serves, and nobody waits for values of it.
bool replaces(const Event& event, const IntendedMeans& caller) {
  return event.op == TriggerOperator::add && event.kind != TriggerKind::belief &&
         caller.op == event.op && caller.kind == event.kind && caller.returns == 0 &&
         predicate_of(caller.trigger) == predicate_of(event.literal) && is_plain(caller) &&
         is_plain(*caller.plan);
}

// A constant and a value that cannot be unified with it, as can be told without unifying them.
bool differ(Value constant, Value value) {
  if (constant.is_unset() || constant.same_as(value)) return false;
  if (constant.is_number() && value.is_number()) return constant.as_number() != value.as_number();
  return (constant.is_number() || constant.is_atom()) && (value.is_number() || value.is_atom());
}

}  // namespace

// The literal of a goal or belief, with source(self) and with its variables as they are, if its
// arguments are constants, variables, numbers and ground terms; else null, and nothing has changed.
// A variable without a value is, in a goal's literal, the slot itself.
Structure* Agent::literal_for_event(Intention& intention, Value term, bool& is_open) {
  if (term.is_atom()) return heap_.blank_literal(term.atom_id(), 0, source_self());
  if (!is_form(term, Form::literal) || term.structure()->is_annotated()) return nullptr;
  const Value* const frame = intention.frame(intention.top());
  const Structure& wanted = *term.structure();
  Structure* const made = heap_.blank_literal(wanted.predicate(), wanted.arity, source_self());
  const Value* const args = wanted.args();
  Value* const values = made->cells() + 1;
  for (std::size_t i = 0; i < wanted.arity; ++i) {
    Value arg = args[i];
    double number = 0;
    if (arg.is_slot()) {
      const Value value = frame[arg.slot_index()];
      if (!value.is_unset()) arg = deref(value);
    } else if (!arg.is_closed() && evaluate_known(arg, frame, number)) {
      arg = Value::number(number);
    }
    if (!arg.is_closed()) {
      if (!arg.is_variable() && !arg.is_slot()) return nullptr;
      is_open = true;
    }
    values[i] = arg;
  }
  return made;
}

// As in prepare_for_event, variables give way to copies, and the pairs are noted behind the frame.
// The variable of a slot without a value is not made: the slot itself stands in the pair, and gets
// the value that the copy has in the end. (It counts as made: variables show their numbers.)
void Agent::rename_in_call(Intention& intention, Structure& made) {
  IntendedMeans& means = intention.top();
  const Plan& plan = *means.plan;
  const std::size_t first = means.frame + plan.slot_count;
  intention.values.cut(first);
  const auto is_new = [&made](std::size_t index) {
    const Value* const args = made.args();
    const auto is_it = [&](Value arg) { return arg.same_as(args[index]); };
    return std::none_of(args, args + index, is_it);
  };
  for (std::size_t i = 0; i < made.arity; ++i) {
    if (made.arg(i).is_slot() && is_new(i)) heap_.skip_variable();
  }
  for (std::size_t i = 0; i < made.arity; ++i) {
    Value& arg = made.args()[i];
    if (!arg.is_variable() && !arg.is_slot()) continue;
    const Value* pair = intention.values.data() + first;
    const Value* const end = intention.values.end();
    while (pair != end && !pair->same_as(arg)) pair += 2;
    if (pair != end) {
      arg = pair[1];
      continue;
    }
    const Value copy =
        heap_.variable(arg.is_slot() ? plan.slot_names[arg.slot_index()] : arg.variable()->name());
    Value* const added = intention.values.extend(2);
    added[0] = arg;
    added[1] = copy;
    arg = copy;
  }
  means.returns = intention.values.size() - first;
}

// The same as Unifier::match with the trigger first, into an empty frame.
[[gnu::always_inline]] inline bool Agent::matches(const Plan& plan, Value literal, Value* frame) {
  const Value trigger = plan.trigger;
  if (trigger.is_atom() && is_literal(literal)) return predicate_of(literal) == trigger.atom_id();
  Unifier& unifier = machine().unifier();
  if (!is_form(trigger, Form::literal) || trigger.structure()->is_annotated() ||
      !is_form(literal, Form::literal)) {
    return unifier.match(trigger, frame, literal, Unifier::Direction::template_first);
  }
  const Structure& pattern = *trigger.structure();
  const Structure& event = *literal.structure();
  if (pattern.predicate_id != event.predicate_id) return false;
  const Value* const patterns = pattern.args();
  const Value* const args = event.args();
  for (std::size_t i = 0; i < pattern.arity; ++i) {
    const Value wanted = patterns[i];
    const Value value = deref(args[i]);
    if (wanted.is_slot() && frame[wanted.slot_index()].is_unset()) {
      if (Unifier::is_of_other_namespace(value)) return false;
      frame[wanted.slot_index()] = value;
    } else if (!wanted.same_as(value) &&
               !unifier.match(wanted, frame, value, Unifier::Direction::template_first)) {
      return false;
    }
  }
  return true;
}

[[gnu::always_inline]] inline bool Agent::try_plain_plan(const Plan& plan, Value literal) {
  std::vector<Value>& scratch = work().frame;
  if (scratch.size() < plan.slot_count) scratch.resize(plan.slot_count);
  Value* const frame = scratch.data();
  for (std::uint32_t i = 0; i < plan.slot_count; ++i) frame[i] = Value();
  Unifier& unifier = machine().unifier();
  unifier.set_slot_names(plan.slot_names);
  const std::size_t trail = unifier.mark();
  std::unique_ptr<ActionError> error;
  const bool applicable = guarded(error, [&] {
    return matches(plan, literal, frame) &&
           (plan.context == nullptr || Context(machine(), frame).solve(plan.context));
  });
  if (error != nullptr) log("in the context of " + plan_name(plan) + ": " + error->message);
  if (applicable) {
    unifier.commit(trail);
  } else {
    unifier.undo(trail);
  }
  return applicable;
}

// Rules RelPl, ApplPl, SelAppl: the first plan that is relevant and applicable; the values of its
// frame stand in the workspace then.
const Plan* Agent::choose_plain_plan(const Event& event, bool& had_candidates) {
  const Value literal = event.literal;
  const Predicate predicate = is_literal(literal) ? predicate_of(literal) : predicates::truth;
  const TriggerKey key =
      is_negated(predicate) ? key_of(event) : TriggerKey{event.op, event.kind, predicate};
  const PlanList& list = library_->list(key);
  had_candidates = !list.plans().empty();
  if (!had_candidates) return nullptr;
  deliberating_ = event.intention;
  const Value first = literal.is_structure() && literal.structure()->arity > 0
                          ? deref(literal.structure()->arg(0))
                          : Value();
  const Plan* chosen = nullptr;
  const auto is_chosen = [&](const Plan& plan) {
    if (differ(plan.first_argument, first) || !try_plain_plan(plan, literal)) return false;
    chosen = &plan;
    return true;
  };
  (void)list.find(list.is_short() ? 0 : argument_key(first), is_chosen);
  deliberating_ = nullptr;
  return chosen;
}

// Rule AddIM for a plan that needs no more than a frame.
void Agent::push_plain_means(Intention& intention, const Plan& plan, const Event& event) {
  const std::span<const Value> frame = std::span(work().frame).first(plan.slot_count);
  if (event.intention != nullptr) {
    IntendedMeans& caller = intention.top();
    const bool is_last = caller.cursor.index + 1 == caller.cursor.body->steps.size();
    if (is_last && replaces(event, caller)) {
      // Tail recursion in place: the means stays, with the values and the body of what follows.
      caller.plan = &plan;
      caller.trigger = event.literal;
      caller.cursor.body = plan.code.entry;
      caller.cursor.index = 0;
      caller.keeps = 0;
      intention.values.cut(caller.frame);
      std::copy(frame.begin(), frame.end(), intention.values.extend(frame.size()));
      return;
    }
    if (is_last) replace_finished_caller(intention, event);
  }
  IntendedMeans& means = intention.push(plan, frame);
  means.op = event.op;
  means.kind = event.kind;
  means.trigger = event.literal;
  means.keeps = event.keeps;
}

}  // namespace jaywalk
