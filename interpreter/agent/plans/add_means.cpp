// Rule AddIM: the plan that was chosen becomes an intended means, a new intention for an external
// event, else on top of the intention that waits for the event.

#include "interpreter/agent/agent.h"
#include "interpreter/agent/step_guard.h"

namespace jaywalk {

// The event's literal with what the head and the context have given its variables. What is still
// open in it, the body may bind, and a failure frees again (free_goal).
Value Agent::settled_literal(const Event& event) {
  work().binds_event = false;
  Value settled;
  try {
    settled = machine().unifier().apply(literal_of(event));
  } catch (const HeapExhausted&) {
    const MemoryReserve reserve(heap_);
    settled = machine().unifier().apply(literal_of(event));
  }
  for (GoalDeadline& deadline : circumstance_.deadlines) {
    if (deadline.goal.same_as(event.literal)) deadline.goal = settled;
  }
  return settled;
}

// Tail recursion: a means whose last formula calls the same goal again gives way to the new one.
bool Agent::is_last_call(const Intention& intention, const Event& event) {
  const IntendedMeans& caller = intention.top();
  if (caller.is_finished() || caller.step().next != nullptr) return false;
  // The literal is not made here: the means would have what the head has bound as if it were open.
  const Predicate predicate =
      event.literal.is_unset() ? work().next.predicate : predicate_of(event.literal);
  return event.op == TriggerOperator::add && event.kind != TriggerKind::belief &&
         caller.kind == event.kind && caller.op == event.op && !caller.plan->has_goal_condition &&
         caller.predicate() == predicate;
}

inline bool Agent::replaces_caller(const Intention& intention, const Event& event) {
  if (!settings_.tail_recursion) return false;
  const NextEvent& next = workspace_->next;
  const bool is_known = &event == &next.event && next.code != nullptr &&
                        next.code->last_call != EventCode::LastCall::unknown;
  return is_known ? next.code->last_call == EventCode::LastCall::yes
                  : is_last_call(intention, event);
}

// The open variables of its own caller live on in the variables that the new means was given.
void Agent::hand_over(const Intention& intention, const IntendedMeans& caller) {
  signal_end(intention, caller);
  const Value* const pairs = intention.values.data() + caller.frame + caller.plan->slot_count;
  for (std::size_t i = 0; i + 1 < caller.returns; i += 2) {
    const Value own = deref(pairs[i]);
    if (own.is_variable()) own.variable()->value = pairs[i + 1];
  }
}

inline std::span<const Value> Agent::frame_for(const Plan& plan) const {
  return std::span(workspace_->frame).first(plan.slot_count);
}

// What means of few plans need.
void Agent::fill_rare(IntendedMeans& means, const std::shared_ptr<Scope>& scope) {
  const Plan& plan = *means.plan;
  if (scope != nullptr) means.extras.make().scope = scope;
  if (plan.subplans != nullptr) {
    uses_subplans_ = true;
    means.extras.make().scope =
        std::make_shared<Scope>(Scope{plan.subplans.get(), closed_off(frame_for(plan)), scope});
  }
  if (plan.has_goal_condition) {
    ++goal_conditions_;
    changed_ = true;  // it may hold already: then no formula is executed
  }
  if (plan.atomic) circumstance_.atomic_suspended = false;
}

inline void Agent::fill_means(Intention& intention, const Plan& plan, const Event& event,
                              const std::shared_ptr<Scope>& scope) {
  IntendedMeans& means = intention.top();
  means.op = event.op;
  means.kind = event.kind;
  means.trigger = workspace_->binds_event ? settled_literal(event) : event.literal;
  means.keeps = event.keeps;
  if (scope != nullptr || !plan.is_simple) fill_rare(means, scope);
}

// The values of the plan's slots are in the workspace's frame.
void Agent::push_means(Intention& intention, const Plan& plan, const Event& event,
                       const std::shared_ptr<Scope>& scope) {
  heap_.note_beside(sizeof(IntendedMeans));
  intention.push(plan, frame_for(plan));
  fill_means(intention, plan, event, scope);
}

void Agent::add_intended_means(const Plan& plan, const Event& event,
                               const std::shared_ptr<Scope>& scope) {
  Intention& intention = event.intention == nullptr ? new_intention() : *event.intention;
  const bool replaces = event.intention != nullptr && replaces_caller(intention, event);
  if (replaces && (intention.top().returns > 0 || library_->has_goal_state_plans())) {
    hand_over(intention, intention.top());
  }
  if (observer_ != nullptr) observer_->plan_chosen(*this, plan, event, intention);
  if (replaces) {
    intention.replace(plan, frame_for(plan));
  } else {
    heap_.note_beside(sizeof(IntendedMeans));
    intention.push(plan, frame_for(plan));
  }
  fill_means(intention, plan, event, scope);
  if (library_->has_goal_state_plans() && event.op == TriggerOperator::add &&
      event.kind == TriggerKind::achieve) {
    signal_goal_state(event.kind, literal_of(event), "executing");
  }
  make_ready(intention);
}

// The literal of the event for which a means was added.
Value Agent::goal_of(const Intention& intention, const IntendedMeans& means) {
  if (!means.trigger.is_unset()) return means.trigger;
  const PlanHead& head = means.plan->head;
  Structure* const made = heap_.blank_literal(head.predicate, head.args.size(), source_self());
  bool is_closed = true;
  for (std::size_t i = 0; i < head.args.size(); ++i) {
    made->args()[i] = intention.head_value(means, i);
    is_closed = is_closed && made->arg(i).is_closed();
  }
  return heap_.literal_of(made, is_closed);
}

// An event whose literal has not been made is the next one, whose arguments are known.
Value Agent::literal_of(const Event& event) {
  if (!event.literal.is_unset()) return event.literal;
  NextEvent& next = work().next;
  Structure* const made = heap_.blank_literal(next.predicate, next.arity, source_self());
  std::copy_n(next.args.data(), next.arity, made->args());
  return next.event.literal = heap_.literal_of(made, !next.is_open);
}

}  // namespace jaywalk
