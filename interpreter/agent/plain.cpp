// The plain plans and means of strides (stride.cpp): from a formula to the literal of its event,
// and from there to the plan that is chosen and the means that carries it out.
//
// Of anything unusual (annotations, terms in variables, other namespaces) the functions here know
// no more than that it is, and leave it to execute.cpp and cycle.cpp.

#include "interpreter/agent/plain.h"

#include <algorithm>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/logic/known_numbers.h"

namespace jaywalk {
namespace {

// The goal of the event is the one that the caller serves, and nobody waits for values of it.
bool replaces(const Event& event, const IntendedMeans& caller) {
  return event.op == TriggerOperator::add && event.kind != TriggerKind::belief &&
         caller.op == event.op && caller.kind == event.kind && caller.returns == 0 &&
         predicate_of(caller.trigger) == predicate_of(event.literal) && is_plain(caller) &&
         is_plain(*caller.plan);
}

// A constant and a value that evidently cannot be unified with it.
bool differ(Value constant, Value value) {
  if (constant.is_unset() || constant.same_as(value)) return false;
  if (constant.is_number() && value.is_number()) return constant.as_number() != value.as_number();
  return (constant.is_number() || constant.is_atom()) && (value.is_number() || value.is_atom());
}

}  // namespace

// The literal of a goal or belief, with source(self) and with its variables as they are, if its
// arguments are constants, variables, numbers and ground terms; else null, and nothing has changed.
// A variable without a value is, in a goal's literal, the slot itself. Used by stride.cpp as well,
// which in builds that compile each file alone links to the copy that is emitted here.
[[gnu::always_inline, gnu::used]] inline Structure* Agent::literal_for_event(Intention& intention,
                                                                             const Step& step,
                                                                             bool& is_open) {
  if (step.plain == nullptr || step.plain->args.empty()) {
    return literal_of_terms(intention, step.term, is_open);
  }
  const Value* const frame = intention.frame(intention.top());
  const std::vector<Operand>& args = step.plain->args;
  Structure* const made =
      heap_.blank_literal(step.term.structure()->predicate(), args.size(), source_self());
  Value* value = made->cells() + 1;
  for (const Operand& arg : args) {
    if (!find_value(arg, frame, *value)) {
      if (arg.kind != Operand::Kind::slot) return nullptr;
      if (value->is_unset()) {
        *value = Value::slot(arg.left_slot);
      } else if (!value->is_variable()) {
        return nullptr;
      }
      is_open = true;
    }
    ++value;
  }
  return made;
}

Structure* Agent::literal_of_terms(Intention& intention, Value term, bool& is_open) {
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
    } else if (!arg.is_closed() && Unifier::is_number(arg, frame, number)) {
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

namespace {

// The same as rename_in_call below if one argument is open, and a slot: the usual case.
[[gnu::always_inline]] inline bool rename_only_slot(Intention& intention, Structure& made,
                                                    Heap& heap) {
  Value* open = nullptr;
  Value* const end = made.args() + made.arity;
  for (Value* arg = made.args(); arg != end; ++arg) {
    if (arg->is_closed()) continue;
    if (open != nullptr || !arg->is_slot()) return false;
    open = arg;
  }
  IntendedMeans& means = intention.top();
  heap.skip_variable();
  const Value copy = heap.variable(means.plan->slot_names[open->slot_index()]);
  Value* const pair = intention.values.extend(2);
  pair[0] = *open;
  pair[1] = copy;
  *open = copy;
  means.returns = 2;
  return true;
}

}  // namespace

// As in prepare_for_event, variables give way to copies, and the pairs are noted behind the frame.
// The variable of a slot without a value is not made: the slot itself stands in the pair, and gets
// the value that the copy has in the end. (It counts as made: variables show their numbers.)
void Agent::rename_in_call(Intention& intention, Structure& made) {
  IntendedMeans& means = intention.top();
  const Plan& plan = *means.plan;
  const std::size_t first = means.frame + plan.slot_count;
  intention.values.cut(first);
  if (rename_only_slot(intention, made, heap_)) return;
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

namespace {

// Whether a head matches. `open`: it is not decided here.
enum class Match : std::uint8_t { fails, holds, open };

// The arguments of an event's literal and the head of a plan.
[[gnu::always_inline]] inline Match match_head(const PlainPlan& plan, const Value* args,
                                               Value* frame, Unifier& unifier) {
  for (const HeadArgument& wanted : plan.head) {
    const Value value = deref(*args++);
    if (wanted.slot != Operand::kNoSlot) {
      if (Unifier::is_of_other_namespace(value)) return Match::fails;
      frame[wanted.slot] = value;
    } else if (value.is_number() || value.is_atom()) {
      if (differ(wanted.constant, value)) return Match::fails;
    } else if (value.is_variable() && !Unifier::is_of_other_namespace(wanted.constant)) {
      unifier.bind(value.variable(), wanted.constant);
    } else {
      return Match::open;
    }
  }
  return Match::holds;
}

const Value* args_of(Value literal) {
  return literal.is_atom() ? nullptr : literal.structure()->args();
}

}  // namespace

// Whether a plan is relevant and applicable.
bool Agent::try_plain_plan(const Plan& plan, Value literal) {
  std::vector<Value>& scratch = work().frame;
  if (scratch.size() < plan.slot_count) scratch.resize(plan.slot_count);
  Value* const frame = scratch.data();
  for (std::uint32_t i = 0; i < plan.slot_count; ++i) frame[i] = Value();
  Unifier& unifier = machine().unifier();
  const std::size_t trail = unifier.mark();
  Match relevant = Match::open;
  if (plan.plain.has_plain_head && is_literal(literal)) {
    relevant = predicate_of(literal) == plan.plain.predicate
                   ? match_head(plan.plain, args_of(literal), frame, unifier)
                   : Match::fails;
    if (relevant == Match::open) {
      unifier.undo(trail);
      std::fill_n(frame, plan.slot_count, Value());
    }
  }
  bool applicable = relevant == Match::holds;
  const bool is_compared =
      applicable && plan.context != nullptr && plan.context->kind == Goal::Kind::compare &&
      plan.context->next == nullptr && compare_numbers(*plan.context, frame, applicable);
  if (relevant == Match::open || (applicable && !is_compared && plan.context != nullptr)) {
    applicable = is_plain_plan_applicable(plan, literal, relevant == Match::open);
  }
  work().binds_event = !literal.is_closed() && unifier.mark() != trail;
  if (unifier.mark() != trail) applicable ? unifier.commit(trail) : unifier.undo(trail);
  return applicable;
}

// The rest of it: the trigger, unless it is known to match, and the context.
bool Agent::is_plain_plan_applicable(const Plan& plan, Value literal, bool is_to_match) {
  machine().unifier().set_slot_names(plan.slot_names);
  Value* const frame = work().frame.data();
  const Heap::Mark unused = heap_.mark();
  std::unique_ptr<ActionError> error;
  const bool applicable = guarded(error, [&] {
    return (!is_to_match || matches(plan, literal, frame)) && machine().solve(plan.context, frame);
  });
  if (error != nullptr) leave_context_at_limit(plan, *error, unused);
  return applicable;
}

// The plans that an event may be for: known from the formula that makes it, as long as the agent
// has no plans of its own. stride.cpp links to the copy that is emitted here.
[[gnu::used]] inline const PlanList& Agent::plans_for(const Step& step, const Event& event) {
  const PlainStep* const plain = step.plain;
  return plain != nullptr && plain->library == library_ ? *plain->plans : plans_for(event);
}

const PlanList& Agent::plans_for(const Event& event) {
  const Predicate predicate =
      is_literal(event.literal) ? predicate_of(event.literal) : predicates::truth;
  return library_->list(is_negated(predicate) ? key_of(event)
                                              : TriggerKey{event.op, event.kind, predicate});
}

// Rules RelPl, ApplPl, SelAppl: the first plan of a list that is relevant and applicable; the
// values of its frame stand in the workspace then.
const Plan* Agent::choose_plain_plan(const PlanList& list, const Event& event) {
  const Value literal = event.literal;
  selected_event_ = &event;
  const Value first = literal.is_structure() && literal.structure()->arity > 0
                          ? deref(literal.structure()->arg(0))
                          : Value();
  const auto is_it = [&](const Plan& plan) {
    return !differ(plan.first_argument, first) && try_plain_plan(plan, literal);
  };
  const Plan* chosen = nullptr;
  if (list.is_short()) {
    for (const Plan* const plan : list.plans()) {
      if (!is_it(*plan)) continue;
      chosen = plan;
      break;
    }
  } else {
    (void)list.find(argument_key(first), [&](const Plan& plan) {
      if (!is_it(plan)) return false;
      chosen = &plan;
      return true;
    });
  }
  selected_event_ = nullptr;
  return chosen;
}

// What return_values does if all that comes back is closed and goes into slots without a value.
// False: something is of another kind, and all of it is still to be returned.
bool Agent::return_closed_values(Intention& intention) {
  const IntendedMeans& caller = intention.top();
  if (!caller.loops.empty()) return false;
  Value* const frame = intention.frame(caller);
  const Value* const pairs = frame + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    if (!pairs[i].is_slot() || !frame[pairs[i].slot_index()].is_unset()) return false;
    const Value returned = deref(pairs[i + 1]);
    if (!returned.is_closed() || Unifier::is_of_other_namespace(returned)) return false;
    frame[pairs[i].slot_index()] = returned;
  }
  return true;
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
      caller.trigger = trigger_of_means(event);
      caller.cursor.body = plan.code.entry;
      caller.cursor.index = 0;
      caller.keeps = 0;
      intention.values.cut(caller.frame);
      std::copy(frame.begin(), frame.end(), intention.values.extend(frame.size()));
      return;
    }
    if (is_last) replace_finished_caller(intention, event);
  }
  heap_.note_beside(sizeof(IntendedMeans));
  if (heap_.wants_count()) {
    // So that the intention is not alone (is_alone), and what it asks for next is refused at the
    // limit.
    heap_.look_again();
    if (heap_.bytes() == 0) (void)heap_.variable();
  }
  IntendedMeans& means = intention.push(plan, frame);
  means.op = event.op;
  means.kind = event.kind;
  means.trigger = trigger_of_means(event);
  means.keeps = event.keeps;
}

}  // namespace jaywalk
