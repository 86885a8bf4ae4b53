// Several reasoning cycles in one go: the same rules as in cycle.cpp, for the usual case.
//
// Most cycles of most agents are of one kind: nothing waits, nothing is atomic, the selection
// functions are Jason's own, no observer looks. Whether that is so (reasons_plainly) is asked once
// a cycle; then each rule of cycle.cpp has a counterpart here that leaves out what cannot matter,
// and hands anything unusual to the rule itself. So this file never has the last word on what a
// rule means.
//
// One shortcut goes further. When an intention is alone (no other is ready, E is empty, there is no
// mail), and its formula is a goal `!g(...)`, then all of the next cycle up to SelInt is settled:
// SelEv takes this event and SelInt this intention. So the goal goes straight from the formula to
// the plans (call), in the cycle that follows, without passing through E and I:
//
//   cycle n      SelInt   ExecInt  !g(X)           → E
//   cycle n + 1                             SelEv ←┘  RelPl ApplPl SelAppl AddIM, SelInt, ExecInt …
//                                  └──────────── call ─────────────────────────┘
//
// Programs see the same cycles, since they are counted, and nobody can look at the agent between
// them: what an observer sees follows from the end of a cycle, and the host gets no cycle more than
// it asked for. Limits interrupt here where they interrupt there, so each throwing part is guarded
// by the same rule's guard.

#include <algorithm>

#include "interpreter/agent/agent.h"
#include "interpreter/agent/context.h"
#include "interpreter/agent/numbers.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"

namespace jaywalk {
namespace {

// Of such a plan the means needs more than a frame.
bool is_plain(const Plan& plan) {
  return !plan.atomic && !plan.has_goal_condition && plan.subplans == nullptr;
}

bool is_plain(const IntendedMeans& means) {
  return means.loops.empty() && means.outer.empty() && means.scope == nullptr &&
         means.cursor.code == nullptr;
}

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

std::uint64_t Agent::reason(std::uint64_t most) {
  const std::uint64_t first = cycles_;
  const std::uint64_t last = first + most;
  do {
    reasons_plainly() ? stride(last) : cycle();
  } while (cycles_ < last && !host_.has_business() && is_active());
  rest();
  return cycles_ - first;
}

bool Agent::reasons_plainly() const {
  const Circumstance& c = circumstance_;
  if (c.atomic != nullptr || c.atomic_suspended || c.atomic_event || !c.feedback.empty() ||
      !c.tasks.empty() || !c.waits.empty() || unseen_ != nullptr || uses_subplans_ ||
      goal_conditions_ > 0 || customisation_ != nullptr || observer_ != nullptr ||
      !settings_.is_plain() || library_->has_goal_state_plans()) {
    return false;
  }
  const Relation* const selecting = beliefs_.find(predicates::select_option);
  return selecting == nullptr || !selecting->has_rules();
}

// The next cycle may begin, and only the intention that runs can be meant by it.
inline bool Agent::is_alone(std::uint64_t last) const {
  const Circumstance& c = circumstance_;
  return c.events.empty() && c.running.empty() && c.mailbox.empty() && cycles_ < last &&
         !heap_.wants_collection() && !host_.has_business();
}

void Agent::stride(std::uint64_t last) {
  (void)work();
  do {
    ++cycles_;
    std::unique_ptr<ActionError> error;
    const bool completed = guarded(error, [&] {
      plain_cycle(last);
      return true;
    });
    if (!completed) abandon_cycle(*error);
    changed_ = true;
    machine().unifier().commit(0);
    machine().forget_temporary_code();
    if (finished_ > 0) forget_finished();
    beliefs_.compact();
    if (heap_.wants_collection()) collect_garbage();
  } while (cycles_ < last && !host_.has_business() && is_active() && reasons_plainly());
}

// Rules ProcMsg, SelEv1, RelPl to AddIM; then the rest of the cycle.
void Agent::plain_cycle(std::uint64_t last) {
  Circumstance& c = circumstance_;
  if (!c.mailbox.empty()) {
    process_message();
    if (!c.tasks.empty() || c.atomic != nullptr || c.atomic_suspended || c.atomic_event) {
      deliberate();
      act();
      return;
    }
  }
  while (!c.events.empty()) {
    const Event event = c.events.front();
    c.events.pop_front();
    if (event.intention != nullptr) event.intention->has_event = false;
    bool had_candidates = false;
    const Plan* const plan = choose_plain_plan(event, had_candidates);
    if (plan == nullptr) {
      if (no_plan(event, had_candidates)) break;
      continue;
    }
    if (is_plain(*plan)) {
      Intention& intention = event.intention == nullptr ? new_intention() : *event.intention;
      push_plain_means(intention, *plan, event);
      make_ready(intention);
    } else {
      work().frame.resize(plan->slot_count);
      add_intended_means(*plan, event, nullptr);
    }
    break;
  }
  // Rule SelInt
  if (c.atomic != nullptr || c.atomic_suspended || goal_conditions_ > 0) {  // that is news
    act();
  } else if (!c.running.empty()) {
    Intention& intention = *c.running.front();
    c.running.pop_front();
    executing_ = &intention;
    plain_steps(intention, last);
    executing_ = nullptr;
  }
}

// Rules ExecInt and ClrInt: one formula of an intention; more, a cycle for each, while it is alone.
void Agent::plain_steps(Intention& intention, std::uint64_t last) {
  using State = Intention::State;
  Ring<Intention*>& running = circumstance_.running;
  for (;; ++cycles_) {
    Executed executed = Executed::called;
    while (executed == Executed::called) executed = execute_plainly(intention, last);
    if (executed == Executed::elsewhere) return;
    if (executed == Executed::ready) {
      intention.state = State::in_event;  // it is not in the queue
      clear_intention(intention);
      if (intention.state != State::in_event) return;
      intention.state = State::running;
      if (!is_alone(last)) {
        make_ready(intention);
        return;
      }
    } else {
      execute(intention);
      if (intention.state == State::finished || intention.state == State::suspended) return;
      clear_intention(intention);
      if (running.size() != 1 || running.front() != &intention || !reasons_plainly()) return;
      running.pop_front();
      if (!is_alone(last)) {
        running.push_back(&intention);
        return;
      }
    }
    machine().forget_temporary_code();
    beliefs_.compact();
    if (finished_ > 0) forget_finished();
  }
}

Agent::Executed Agent::execute_plainly(Intention& intention, std::uint64_t last) {
  const IntendedMeans& means = intention.top();
  if (means.cursor.at_end()) {  // an empty body takes a step, too
    return means.cursor.is_loop ? Executed::not_yet : Executed::ready;
  }
  if (!means.loops.empty() || means.cursor.code != nullptr) return Executed::not_yet;
  const Step& step = means.step();
  switch (step.kind) {
    case Step::Kind::achieve:
      return is_alone(last) ? call(intention, step) : Executed::not_yet;
    case Step::Kind::add:
    case Step::Kind::remove:
    case Step::Kind::replace:
      return is_alone(last) ? change_belief(intention, step) : Executed::not_yet;
    case Step::Kind::constraint:
    case Step::Kind::test:
    case Step::Kind::if_statement:
      return ask(intention, step);
    default:
      return Executed::not_yet;
  }
}

// `X > 1`, `?b(X)`, and the condition of an `if`.
Agent::Executed Agent::ask(Intention& intention, const Step& step) {
  std::unique_ptr<ActionError> error;
  bool holds = false;
  const bool completed = guarded(error, [&] {
    machine().unifier().set_slot_names(intention.top().plan->slot_names);
    holds = Context(machine(), intention.frame(intention.top())).solve(step.goal);
    if (!holds && step.kind == Step::Kind::test) fail_test(intention, step);
    return true;
  });
  if (!completed) {
    fail_at_limit(intention, *error);
    return Executed::elsewhere;
  }
  machine().unifier().commit(0);
  const Body* const branch = holds ? step.first : step.second;
  if (branch != nullptr) {
    enter_body(intention, *branch, nullptr);
  } else if (holds || step.kind == Step::Kind::if_statement) {
    intention.advance();
  } else {
    if (step.kind == Step::Kind::constraint) {
      fail(intention, ActionError{.id = "constraint_failed", .message = "", .annots = {}});
    }
    return Executed::elsewhere;
  }
  return Executed::ready;
}

// A goal as a formula.
Agent::Executed Agent::call(Intention& intention, const Step& step) {
  Value goal;
  std::unique_ptr<ActionError> error;
  const bool completed = guarded(error, [&] {
    bool is_open = false;
    Structure* const made = literal_for_event(intention, step.term, is_open);
    if (made == nullptr) return true;
    if (is_open) rename_in_call(intention, *made);
    goal = heap_.literal_of(made, !is_open);
    return true;
  });
  if (!completed) {
    fail_at_limit(intention, *error);
    return Executed::elsewhere;
  }
  if (goal.is_unset()) return Executed::not_yet;
  return take_up(intention, {TriggerOperator::add, TriggerKind::achieve, goal, &intention, 0});
}

// `+b`, `-b` and `-+b` with a ground b that has no other source than the agent itself.
Agent::Executed Agent::change_belief(Intention& intention, const Step& step) {
  Value literal;
  bool changed = false;
  std::unique_ptr<ActionError> error;
  const bool removes = step.kind == Step::Kind::remove;
  const bool completed = guarded(error, [&] {
    bool is_open = false;
    const Structure* const made = literal_for_event(intention, step.term, is_open);
    if (made == nullptr || is_open) return true;
    literal = heap_.literal_of(made, true);
    if (step.kind == Step::Kind::replace && !forget_one(made->predicate())) {
      literal = Value();
      return true;
    }
    if (removes) {
      changed = beliefs_.remove(literal, machine().unifier());
    } else if (const std::optional<Value> added = beliefs_.add(literal)) {
      literal = *added;
      changed = true;
    }
    return true;
  });
  if (!completed) {
    fail_at_limit(intention, *error);
    return Executed::elsewhere;
  }
  if (literal.is_unset()) return Executed::not_yet;
  if (!changed) {
    intention.advance();
    return Executed::ready;
  }
  const Event event{removes ? TriggerOperator::remove : TriggerOperator::add, TriggerKind::belief,
                    literal, &intention, 0};
  if (circumstance_.events.empty()) return take_up(intention, event);
  add_event(event);  // behind that of a belief that -+b has removed
  return Executed::elsewhere;
}

// The first half of -+b: the belief that was added last goes. False: nothing has been done, since
// that is no fact of the agent's own.
bool Agent::forget_one(Predicate predicate) {
  Relation* const relation = beliefs_.find(predicate);
  if (relation == nullptr) return true;
  for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
    const Row& row = relation->row(seq);
    if (row.is_hole()) continue;
    if (!row.fact.is_structure() || !row.fact.is_closed()) return false;
    const Structure& fact = *row.fact.structure();
    if (fact.arity == 0 || !fact.annots().same_as(source_self())) return false;
    const Value forgotten = row.fact;
    // Elsewhere the pattern of what goes has variables.
    for (std::size_t i = 0; i < fact.arity; ++i) heap_.skip_variable();
    beliefs_.erase(*relation, seq);
    add_event({TriggerOperator::remove, TriggerKind::belief, forgotten, nullptr, 0});
    return true;
  }
  return true;
}

// From the event of a formula, at the end of ExecInt, to SelInt of the next cycle.
Agent::Executed Agent::take_up(Intention& intention, const Event& event) {
  intention.state = Intention::State::in_event;
  executing_ = nullptr;
  ++cycles_;
  beliefs_.compact();
  bool had_candidates = false;
  const Plan* const plan = choose_plain_plan(event, had_candidates);
  if (plan != nullptr && is_plain(*plan)) {
    push_plain_means(intention, *plan, event);
  } else if (plan == nullptr && event.kind == TriggerKind::belief) {
    intention.advance();  // the change was all that was wanted
    if (intention.top().is_finished()) clear_intention(intention);
    if (intention.state != Intention::State::in_event) return Executed::elsewhere;
  } else {
    if (plan != nullptr) {
      work().frame.resize(plan->slot_count);
      add_intended_means(*plan, event, nullptr);
    } else {
      (void)no_plan(event, had_candidates);
    }
    act();
    return Executed::elsewhere;
  }
  intention.state = Intention::State::running;
  executing_ = &intention;
  return Executed::called;
}

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
