// Goals and intentions: asked about, ended, suspended; time.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/compile/term_reader.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk::actions {
namespace {

// One answer for each event, and each intended means of an intention, the topmost first, that has
// the goal.
class GoalSolutions : public Solutions {
 public:
  GoalSolutions(std::vector<Value> events, std::vector<Intention*> intentions)
      : events_(std::move(events)), intentions_(std::move(intentions)) {}

  bool next(ActionCall& call) override {
    while (event_ < events_.size()) {
      if (call.unify(0, events_[event_++])) return true;
    }
    for (; intention_ < intentions_.size(); ++intention_, means_ = 0) {
      const Intention& intention = *intentions_[intention_];
      while (means_ < intention.stack.size()) {
        const IntendedMeans& means = intention.stack[intention.stack.size() - ++means_];
        const std::size_t trail = call.unifier().mark();
        if (means.kind == TriggerKind::achieve && means.op == TriggerOperator::add &&
            call.unify(0, means.trigger) &&
            (call.count() < 2 || call.unify(1, Value::number(intention.id)))) {
          return true;
        }
        call.unifier().undo(trail);
      }
    }
    return false;
  }

 private:
  std::vector<Value> events_;
  std::vector<Intention*> intentions_;
  std::size_t event_ = 0;
  std::size_t intention_ = 0;
  std::size_t means_ = 0;  // of the current intention, that have been looked at
};

bool is_suspended(const Intention& intention) {
  return intention.also_suspended || intention.state == Intention::State::suspended;
}

bool is_goal(const Event& event) {
  return event.kind == TriggerKind::achieve && event.op == TriggerOperator::add;
}

// What is left of a body, from the current formula of each level on.
Value remaining_body(Agent& agent, Intention& intention, const IntendedMeans& means) {
  std::vector<Value> steps;
  agent.machine().unifier().set_slot_names(means.plan->slot_names);
  const auto add = [&](const Cursor& cursor, std::size_t from) {
    for (std::size_t i = from; i < cursor.body->steps.size(); ++i) {
      const Value source = cursor.body->steps[i].source;
      if (!source.is_unset()) {
        steps.push_back(agent.machine().unifier().instantiate(source, intention.frame(means)));
      }
    }
  };
  add(means.cursor, means.cursor.index);
  for (std::size_t i = means.outer.size(); i > 0; --i) {
    add(means.outer[i - 1], means.outer[i - 1].index);
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
  for (std::uint32_t i = 0; i < means.plan->slot_count; ++i) {
    const Value value = deref(intention.frame(means)[i]);
    if (value.is_unset() || value.is_variable()) continue;
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
    Value label = agent.label_of(*means.plan);
    if (is_literal(label)) {
      const std::uint32_t line = means.cursor.at_end() ? means.plan->line : means.step().line;
      const Value number = Value::number(line);
      const Value file = heap.text("file:" + means.plan->file);
      const std::array<Value, 2> place{
          heap.structure(agent.symbols().predicate("code_line", 1), std::span(&number, 1)),
          heap.structure(agent.symbols().predicate("code_src", 1), std::span(&file, 1))};
      label = with_annotations(
          heap, label,
          union_of(heap, literal_parts(label).annots, heap.list(place), agent.symbols()));
    }
    const std::array<Value, 4> parts{
        label, trigger_term(agent, means.op, means.kind, means.trigger),
        remaining_body(agent, intention, means), bindings_term(agent, intention, means)};
    stack.push_back(heap.structure(agent.symbols().predicate("im", 4), parts));
  }
  // A copy: the open variables are those of the stack's own frames, perhaps of this very action.
  return agent.machine().unifier().fresh_copy(heap.list(stack));
}

std::string state_name(const Agent& agent, const Intention& intention) {
  if (is_suspended(intention)) return "suspended";
  const bool waits =
      intention.state == Intention::State::waiting || intention.state == Intention::State::acting;
  (void)agent;
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
      Value state = Value::atom(agent.symbols().predicate(state_name(agent, intention), 0));
      const bool waits = state_name(agent, intention) == "waiting";
      if (waits) {
        const Value action = agent.pending_action(intention);
        const Value why = action.is_unset() ? agent.wait_reason(intention) : action;
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

bool has_future_goal(Agent& agent, Intention& intention, Value goal) {
  Unifier& unifier = agent.machine().unifier();
  for (std::size_t i = 0; i < intention.stack.size(); ++i) {
    const IntendedMeans& means = intention.stack[i];
    unifier.set_slot_names(means.plan->slot_names);
    const bool is_top = i + 1 == intention.stack.size();
    const auto found_in = [&](const Cursor& cursor, std::size_t from) {
      for (std::size_t k = from; k < cursor.body->steps.size(); ++k) {
        const Step& step = cursor.body->steps[k];
        if (step.kind != Step::Kind::achieve && step.kind != Step::Kind::achieve_new_focus)
          continue;
        const std::size_t trail = unifier.mark();
        const bool found =
            unifier.unify(goal, unifier.instantiate(step.term, intention.frame(means)));
        unifier.undo(trail);
        if (found) return true;
      }
      return false;
    };
    if (found_in(means.cursor, means.cursor.index + (is_top ? 0 : 1))) return true;
    for (const Cursor& cursor : means.outer) {
      if (found_in(cursor, cursor.index)) return true;
    }
  }
  return false;
}

// Drops what is not the intention that executes the action; that one afterwards.
Outcome drop_all(ActionCall& call, const std::vector<Intention*>& intentions) {
  bool own = false;
  for (Intention* const intention : intentions) {
    // Within a query of the executing intention, that one has to stay.
    if (call.intention() == nullptr && intention == call.agent()->executing()) continue;
    for (std::size_t i = intention->stack.size(); i > 0; --i) {
      const IntendedMeans& means = intention->stack[i - 1];
      if (!means.is_goal_addition()) continue;
      call.agent()->signal_goal_state(means.kind, means.trigger, "dropped");
      call.agent()->signal_goal_state(means.kind, means.trigger, "finished");
    }
    if (intention == call.intention()) {
      own = true;
    } else {
      call.agent()->drop(*intention);
    }
  }
  if (!own) return Outcome::succeeded;
  call.agent()->drop(*call.intention());
  return Outcome::suspended;
}

void end_goal(ActionCall& call, Agent::GoalEnd end) {
  Intention* const kept = call.intention() == nullptr ? call.agent()->executing() : nullptr;
  call.agent()->end_goal(call.arg(0), end, kept);
}

bool is_plan_part(Value value, Form form) {
  return value.is_structure() && value.structure()->form() == form;
}

// "now +3 s": milliseconds from now; -1: there is no amount; nothing: it is no whole number. As in
// Jason a unit that is none of its own counts milliseconds, and a blank stands before it.
std::optional<double> parse_delay(std::string_view text) {
  const auto trimmed = [](std::string_view part) {
    const std::size_t first = part.find_first_not_of(' ');
    return first == part.npos ? std::string_view() : part.substr(first);
  };
  text = trimmed(text.substr(3));
  if (!text.starts_with("+")) return -1;
  text = trimmed(text.substr(1));
  std::string_view amount = text.substr(0, text.find(' '));
  const std::string_view unit = trimmed(text.substr(amount.size()));
  if (amount.starts_with('+') && !amount.starts_with("+-")) amount.remove_prefix(1);
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(amount.data(), amount.data() + amount.size(), number);
  if (error != std::errc() || end != amount.data() + amount.size()) return std::nullopt;
  const double ms = number;
  if (unit == "s" || unit.starts_with("second")) return ms * 1000;
  if (unit == "m" || unit.starts_with("minute")) return ms * 60'000;
  if (unit == "h" || unit.starts_with("hour")) return ms * 3'600'000;
  if (unit == "d" || unit.starts_with("day")) return ms * 86'400'000;
  return ms;
}

enum class Variables : std::uint8_t { allowed, refused };

// Whether the first argument can be a goal, as Jason checks it.
bool names_goal(ActionCall& call, Variables variables) {
  const Value goal = call.arg(0);
  if (goal.is_variable()) return variables == Variables::allowed;
  return !goal.is_number() && !goal.is_text() && !goal.is_list();
}

Outcome no_literal(ActionCall& call) { return call.wrong_argument(0, "a literal"); }

Outcome no_pattern(ActionCall& call) {
  return call.wrong_arguments(fmt::format("first argument '{}' must be a literal or variable",
                                          term_text(call.arg(0), call.symbols())));
}

}  // namespace

Outcome fail(ActionCall& call) {
  if (call.count() == 0) return Outcome::failed;
  for (const Value arg : call.args()) call.error.annots.push_back(deref(arg));
  return call.fail("internal_action", "fail");
}

Outcome wait(ActionCall& call) {
  Agent& agent = *call.agent();
  Wait wait;
  double ms = -1;
  const Value what = call.arg(0);
  TriggerParts trigger;
  if (what.is_number()) {
    ms = std::max(0.0, what.as_number());
  } else if (read_trigger(what, call, trigger)) {
    wait.has_trigger = true;
    wait.op = trigger.op;
    wait.kind = trigger.kind;
    wait.trigger = trigger.literal;
  } else if (is_literal(what) || is_plan_part(what, Form::logical) ||
             is_plan_part(what, Form::relation)) {
    const std::size_t trail = call.unifier().mark();
    if (call.machine().solve_term(what)) return Outcome::succeeded;
    call.unifier().undo(trail);
    wait.has_formula = true;
    wait.formula = what;
  } else {
    return call.wrong_argument(0, "a time, a trigger or a formula");
  }
  if (!what.is_number() && call.count() > 1) {
    if (!call.arg(1).is_number()) return call.wrong_argument(1, "a number of milliseconds");
    ms = std::max(0.0, call.arg(1).as_number());
    if (call.count() > 2) wait.elapsed = call.arg(2);
  }
  agent.start_wait(*call.intention(), wait, ms);
  return Outcome::suspended;
}

Outcome at(ActionCall& call) {
  if (!call.arg(0).is_text()) return call.wrong_argument(0, "a string like \"now +3 s\"");
  const std::string_view time = call.arg(0).text()->view();
  if (!time.starts_with("now")) {
    return call.fail("internal_action",
                     fmt::format("The time parameter ('{}') of the internal action 'at' is not "
                                 "implemented!",
                                 time));
  }
  const std::optional<double> delay = parse_delay(time);
  if (!delay) return java_exception(call, "the time of .at is no whole number");
  if (*delay == -1) {
    return call.fail("internal_action",
                     fmt::format("The time parameter ('{}') of the internal action 'at' did not "
                                 "parse correctly!",
                                 term_text(call.arg(0), call.symbols())));
  }
  TriggerParts trigger;
  if (!read_trigger(call.arg(1), call, trigger) || !is_literal(trigger.literal)) {
    return call.wrong_argument(1, "a trigger like {+!g}");
  }
  call.agent()->schedule(
      {trigger.op, trigger.kind, call.unifier().fresh_copy(trigger.literal), nullptr, 0},
      std::max(0.0, *delay));
  return Outcome::succeeded;
}

Outcome signal(ActionCall& call) {
  TriggerParts trigger;
  if (!read_trigger(call.arg(0), call, trigger) || !is_literal(trigger.literal)) {
    return call.wrong_argument(0, "a trigger like {+b}");
  }
  Value literal = call.unifier().fresh_copy(trigger.literal);
  const Value annots = literal_parts(literal).annots;
  if (!has_source(annots)) {
    literal = with_annotations(call.heap(), literal,
                               union_of(call.heap(), annots, source_self(), call.symbols()));
  }
  call.agent()->add_event({trigger.op, trigger.kind, literal, nullptr, 0});
  return Outcome::succeeded;
}

Outcome intend(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) {
    return call.wrong_argument(0, "a literal or variable");
  }
  std::vector<Intention*> active;
  for (Intention* const intention : call.agent()->all_intentions()) {
    if (!is_suspended(*intention)) active.push_back(intention);
  }
  return call.many(std::make_unique<GoalSolutions>(std::vector<Value>{}, std::move(active)));
}

Outcome desire(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) {
    return call.wrong_argument(0, "a literal or variable");
  }
  Agent& agent = *call.agent();
  std::vector<Value> events;
  const Circumstance& c = agent.circumstance();
  for (const Event& event : c.events) {
    if (is_goal(event)) events.push_back(event.literal);
  }
  if (c.atomic_event && is_goal(*c.atomic_event)) events.push_back(c.atomic_event->literal);
  for (const Event& event : c.pending_events) {
    if (is_goal(event)) events.push_back(event.literal);
  }
  return call.many(std::make_unique<GoalSolutions>(std::move(events), agent.all_intentions()));
}

Outcome intention(ActionCall& call) {
  Agent& agent = *call.agent();
  std::vector<Intention*> all = agent.all_intentions();
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

Outcome drop_intention(ActionCall& call) {
  if (call.count() == 0) {
    return call.intention() == nullptr ? Outcome::failed : drop_all(call, {call.intention()});
  }
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  return drop_all(call, call.agent()->intentions_with(call.arg(0)));
}

Outcome drop_desire(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  call.agent()->drop_goal_events(call.arg(0));
  return drop_all(call, call.agent()->intentions_with(call.arg(0)));
}

Outcome drop_event(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  call.agent()->drop_goal_events(call.arg(0));
  return Outcome::succeeded;
}

Outcome drop_all_intentions(ActionCall& call) {
  std::vector<Intention*> others = call.agent()->all_intentions();
  std::erase(others, call.intention());
  call.agent()->cancel_schedule();
  return drop_all(call, others);
}

Outcome drop_all_desires(ActionCall& call) {
  const Outcome outcome = drop_all_intentions(call);
  Circumstance& c = call.agent()->circumstance();
  erase_if(c.events, [](const Event& event) { return event.kind == TriggerKind::achieve; });
  c.pending_events.clear();
  return outcome;
}

Outcome drop_all_events(ActionCall& call) {
  Circumstance& c = call.agent()->circumstance();
  c.events.clear();
  c.pending_events.clear();
  return Outcome::succeeded;
}

Outcome drop_future_intention(ActionCall& call) {
  if (!names_goal(call, Variables::allowed)) return no_pattern(call);
  if (call.arg(0).is_variable()) {
    return call.wrong_arguments(fmt::format("first argument '{}' must be a literal",
                                            term_text(call.arg(0), call.symbols())));
  }
  std::vector<Intention*> found;
  for (Intention* const intention : call.agent()->all_intentions()) {
    if (has_future_goal(*call.agent(), *intention, call.arg(0))) found.push_back(intention);
  }
  return drop_all(call, found);
}

Outcome succeed_goal(ActionCall& call) {
  if (!names_goal(call, Variables::refused)) return no_literal(call);
  end_goal(call, Agent::GoalEnd::succeed);
  return Outcome::succeeded;
}

Outcome fail_goal(ActionCall& call) {
  if (!names_goal(call, Variables::refused)) return no_literal(call);
  end_goal(call, Agent::GoalEnd::fail);
  return Outcome::succeeded;
}

Outcome done(ActionCall& call) {
  Agent& agent = *call.agent();
  if (call.count() == 1) return succeed_goal(call);
  Intention* const own = call.intention();
  if (own == nullptr || own->is_finished()) return Outcome::failed;
  // Within a sub-plan: the enclosing goal; else the current one.
  const std::shared_ptr<Scope> scope = own->top().scope;
  if (scope != nullptr && own->top().plan != scope->owner) {
    Intention* const enclosing = agent.intention_with_id(scope->intention);
    if (enclosing != nullptr && scope->depth < enclosing->stack.size()) {
      agent.end_means(*enclosing, scope->depth, Agent::GoalEnd::succeed);
    }
    return Outcome::succeeded;
  }
  agent.end_means(*own, own->stack.size() - 1, Agent::GoalEnd::succeed);
  return Outcome::suspended;
}

Outcome suspend(ActionCall& call) {
  Agent& agent = *call.agent();
  Intention* const own = call.intention();
  if (call.count() == 1) {
    if (!names_goal(call, Variables::refused)) return no_literal(call);
    agent.suspend_goal(call.arg(0));
  }
  if (own == nullptr) return call.count() == 1 ? Outcome::succeeded : Outcome::failed;
  if (call.count() == 1 && !own->also_suspended) return Outcome::succeeded;
  own->also_suspended = false;
  agent.suspend(*own, Intention::State::suspended, "suspend_ia");
  own->suspended_itself = true;
  agent.signal_top_state(*own, "suspended", agent.wait_reason(*own));
  return Outcome::suspended;
}

Outcome resume(ActionCall& call) {
  if (!names_goal(call, Variables::refused)) return no_literal(call);
  call.agent()->resume_goal(call.arg(0));
  return Outcome::succeeded;
}

Outcome suspended(ActionCall& call) {
  for (Intention* const intention : call.agent()->all_intentions()) {
    const std::size_t trail = call.unifier().mark();
    const bool waits = is_suspended(*intention) || intention->state == Intention::State::waiting ||
                       intention->state == Intention::State::acting;
    if (waits && call.agent()->has_goal(*intention, call.arg(0)) &&
        call.unify(1, call.agent()->wait_reason(*intention))) {
      return Outcome::succeeded;
    }
    call.unifier().undo(trail);
  }
  return Outcome::failed;
}

}  // namespace jaywalk::actions
