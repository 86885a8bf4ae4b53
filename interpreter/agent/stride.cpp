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

#include "interpreter/agent/agent.h"
#include "interpreter/agent/plain.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/agent/step_texts.h"

namespace jaywalk {

std::uint64_t Agent::reason(std::uint64_t most) {
  const std::uint64_t first = cycles_;
  const std::uint64_t last = first + most;
  const bool is_in_nursery = begin_first_cycles();
  do {
    reasons_plainly() ? stride(last) : cycle();
  } while (cycles_ < last && !host_.has_business() && is_active());
  if (is_in_nursery) end_first_cycles();
  rest();
  return cycles_ - first;
}

bool Agent::reasons_plainly() const {
  const Circumstance& c = circumstance_;
  if (c.atomic != nullptr || c.atomic_suspended || c.atomic_event || !c.feedback.empty() ||
      !c.tasks.empty() || !c.waits.empty() || unseen_ != nullptr || uses_subplans_ ||
      goal_conditions_ > 0 || customisation_ != nullptr || observer_ != nullptr ||
      heap_.is_short() || !settings_.is_plain() || library_->has_goal_state_plans() ||
      library_->has_learned_plans()) {
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
    machine().unifier().commit(0);
    machine().forget_temporary_code();
    if (finished_ > 0) forget_finished();
    beliefs_.compact();
    if (heap_.wants_collection() || heap_.wants_count()) clean_up();
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
    const PlanList& plans = plans_for(event);
    const Plan* const plan = choose_plain_plan(plans, event);
    if (plan == nullptr) {
      if (no_plan(event, !plans.plans().empty())) break;
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
  const bool is_news = c.atomic != nullptr || c.atomic_suspended || goal_conditions_ > 0;
  if (is_news || uses_subplans_) {
    act();
    return;
  }
  changed_ = false;
  if (c.running.empty()) return;
  Intention& intention = *c.running.front();
  c.running.pop_front();
  executing_ = &intention;
  plain_steps(intention, last);
  executing_ = nullptr;
  changed_ = true;
}

// Rule ClrInt, for means that need no more than a frame.
void Agent::clear_plainly(Intention& intention) {
  while (intention.top().is_finished()) {
    const IntendedMeans& done = intention.top();
    const bool is_failure = done.is_goal() && done.op == TriggerOperator::remove;
    if (intention.stack.size() == 1 || is_failure || !is_plain(*done.plan)) {
      clear_intention(intention);
      return;
    }
    intention.pop();
    if (intention.top().is_finished()) continue;
    if (!return_closed_values(intention)) return_values(intention);
    intention.advance();
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
      clear_plainly(intention);
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
  bool holds = false;
  std::unique_ptr<ActionError> error;
  const bool completed = guarded(error, [&] {
    machine().unifier().set_slot_names(intention.top().plan->slot_names);
    holds = machine().solve(step.goal, intention.frame(intention.top()));
    if (!holds && step.kind == Step::Kind::test) fail_test(intention, step);
    // Its text shows what follows it, too, where a division may be by zero.
    if (!holds && step.kind == Step::Kind::constraint) {
      fail(intention, constraint_failure(machine().unifier(), intention));
    }
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
    Structure* const made = literal_for_event(intention, step, is_open);
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
  const Event event{TriggerOperator::add, TriggerKind::achieve, goal, &intention, 0};
  return take_up(intention, event, plans_for(step, event));
}

// `+b`, `-b` and `-+b` with a ground b that has no other source than the agent itself.
Agent::Executed Agent::change_belief(Intention& intention, const Step& step) {
  Value literal;
  bool changed = false;
  std::unique_ptr<ActionError> error;
  const bool removes = step.kind == Step::Kind::remove;
  const bool completed = guarded(error, [&] {
    bool is_open = false;
    const Structure* const made = literal_for_event(intention, step, is_open);
    if (made == nullptr || is_open) return true;
    literal = heap_.literal_of(made, true);
    if (step.kind == Step::Kind::replace && !forget_one(made->predicate())) {
      literal = Value();
      return true;
    }
    if (removes) {
      changed = beliefs_.remove(literal, machine().unifier());
    } else if (const std::optional<Value> added = add_fact(literal)) {
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
  if (circumstance_.events.empty()) return take_up(intention, event, plans_for(step, event));
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
    beliefs_.erase(*relation, seq);
    add_event({TriggerOperator::remove, TriggerKind::belief, forgotten, nullptr, 0});
    return true;
  }
  return true;
}

// From the event of a formula, at the end of ExecInt, to SelInt of the next cycle.
Agent::Executed Agent::take_up(Intention& intention, const Event& event, const PlanList& plans) {
  intention.state = Intention::State::in_event;
  executing_ = nullptr;
  ++cycles_;
  beliefs_.compact();
  const Plan* const plan = choose_plain_plan(plans, event);
  if (plan != nullptr && is_plain(*plan)) {
    push_plain_means(intention, *plan, event);
  } else if (plan == nullptr && event.kind == TriggerKind::belief) {
    intention.advance();  // the change was all that was wanted
    clear_plainly(intention);
    if (intention.state != Intention::State::in_event) return Executed::elsewhere;
  } else {
    if (plan != nullptr) {
      work().frame.resize(plan->slot_count);
      add_intended_means(*plan, event, nullptr);
    } else {
      (void)no_plan(event, !plans.plans().empty());
    }
    act();
    return Executed::elsewhere;
  }
  intention.state = Intention::State::running;
  executing_ = &intention;
  return Executed::called;
}

}  // namespace jaywalk
