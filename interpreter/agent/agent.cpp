// SPDX-License-Identifier: Apache-2.0
#include "interpreter/agent/agent.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "interpreter/agent/own_parts.h"
#include "interpreter/agent/step_guard.h"
#include "interpreter/program/plan_compiler.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {

AgentParts::AgentParts(std::string name, std::shared_ptr<const Program> program,
                       SymbolTable& symbols, AgentHost& host, std::uint64_t seed,
                       const AgentLimits& limits)
    : name_(std::move(name)),
      program_(std::move(program)),
      symbols_(symbols),
      host_(host),
      turn_(&host.common_turn()),
      observer_(host.observer()),
      beliefs_(heap_, symbols),
      max_inferences_(limits.inferences),
      random_(static_cast<std::int64_t>(seed)),
      library_(&program_->library()) {
  heap_.set_limit(limits.bytes);
}

AgentParts::~AgentParts() = default;

Agent::Agent(std::string name, std::shared_ptr<const Program> program, SymbolTable& symbols,
             AgentHost& host, std::uint64_t seed, const AgentLimits& limits)
    : AgentParts(std::move(name), std::move(program), symbols, host, seed, limits) {
  if (auto remains = turn_->workspaces->take_remains(program_.get())) {
    heap_.use(std::move(remains->heap));
    beliefs_.use(std::move(remains->beliefs));
    remains->queues.give(circumstance_);
  }
  note_unusual();
}

void Agent::customise(std::shared_ptr<const Customisation> functions) {
  customisation_ = std::move(functions);
  note_unusual();
}

void Agent::set_settings(const ReasoningSettings& settings) {
  settings_ = settings;
  note_unusual();
}

void Agent::receive(const Message& message) {
  circumstance_.mailbox.push_back(message);
  attention_ = true;
}

// Call this when one of these has changed.
void Agent::note_unusual() {
  const auto bit = [](Unusual what, bool is_so) { return is_so ? std::uint32_t{what} : 0U; };
  unusual_ = (unusual_ & (kSelectsByRules | kSubplans)) | bit(kObserved, observer_ != nullptr) |
             bit(kShowsEvents, observer_ != nullptr && observer_->wants_events()) |
             bit(kCustomised, customisation_ != nullptr) |
             bit(kLearned, library_->has_learned_plans()) |
             bit(kGoalStates, library_->has_goal_state_plans()) |
             bit(kSeldomLooks, settings_.cycles_per_look > 1) |
             bit(kKeepsCallers, !settings_.tail_recursion);
}

Agent::~Agent() {
  WorkspacePool& pool = *turn_->workspaces;
  if (!pool.wants_remains()) return;
  pool.keep(circumstance_.intentions);
  QueueRemains queues;
  queues.use(circumstance_);
  pool.keep({program_, heap_.leave_remains(), beliefs_.leave_remains(), std::move(queues)});
}

void Agent::borrow_workspace() {
  WorkspacePool& pool = *turn_->workspaces;
  workspace_ = pool.lend();
  workspace_->machine.attach({.heap = &heap_,
                              .beliefs = &beliefs_,
                              .actions = &program_->actions(),
                              .agent = this,
                              .surroundings = this,
                              .texts = &turn_->texts,
                              .functions = own_ == nullptr || own_->functions.empty()
                                               ? &program_->functions()
                                               : &own_->functions,
                              .max_inferences = std::min(max_inferences_, pool.inferences_left())});
  workspace_->lend_queues(circumstance_);
}

void Agent::rest() {
  if (workspace_ != nullptr) give_back_workspace();
}

void Agent::give_back_workspace() {
  workspace_->take_back_queues(circumstance_);
  workspace_->machine.unifier().commit(0);
  turn_->workspaces->take_back(std::move(workspace_));
}

void Agent::start(std::span<const Predicate> replaced, std::span<const Value> given) {
  // A program that can start later needs so little memory that it is granted whatever the limit:
  // no plan could handle a failure.
  std::optional<UnlimitedMemory> unlimited;
  if (program_->can_start_later()) unlimited.emplace(heap_);
  begin(*program_, replaced, given);
}

// True: in the nursery.
bool Agent::begin_first_cycles() {
  if (!starts_later_) return false;
  constexpr std::size_t kLeastLimit = 64 * 1024;  // below, the nursery is too large
  const bool enters = heap_.is_unused() && heap_.limit() >= kLeastLimit;
  if (enters) heap_.enter(work().nursery);
  starts_later_ = false;
  start({}, {});
  return enters;
}

void Agent::end_first_cycles() {
  heap_.leave(work().nursery, work().aside,
              [this](Heap::Relocator& relocate) { visit_roots(relocate); });
}

void Agent::begin_with(const Program::Belief& belief, std::span<const Predicate> replaced) {
  if (belief.rule != nullptr) {
    if (belief.predicate == predicates::select_option) unusual_ |= kSelectsByRules;
    const RuleCode& rule = observer_ == nullptr ? *belief.rule : observer_->rule_for(*belief.rule);
    beliefs_.add_rule(rule, Place::front);
  } else if (std::ranges::find(replaced, belief.predicate) == replaced.end()) {
    (void)add_belief(belief.fact, Place::front, nullptr);
  }
}

// Shares initial beliefs for which there is no plan with the program's other agents.
void Agent::begin_with_shared(const Program& program, std::span<const Predicate> replaced) {
  constexpr std::size_t kMore = 1;  // what it comes to believe
  beliefs_.expect(program.beginnings().size() + kMore);
  for (const Program::Beginning& each : program.beginnings()) {
    const bool is_replaced = std::ranges::find(replaced, each.predicate) != replaced.end();
    if (each.rows != nullptr && !is_replaced && beliefs_.share(each.predicate, *each.rows)) {
      if (each.predicate == predicates::select_option && each.rows->rules() > 0) {
        unusual_ |= kSelectsByRules;
      }
      continue;
    }
    for (const std::uint32_t belief : each.beliefs) begin_with(program.beliefs()[belief], replaced);
  }
}

void Agent::begin(const Program& program, std::span<const Predicate> replaced,
                  std::span<const Value> given) {
  for (const Value fact : given) (void)add_belief(fact, Place::front, nullptr);
  // An observer may give other rules, and hears of facts in their order; functions of the agent's
  // own may believe something else.
  const bool may_share = &program == program_.get() && observer_ == nullptr &&
                         customisation_ == nullptr &&
                         settings_.unwanted == ReasoningSettings::Unwanted::discard;
  if (may_share) {
    begin_with_shared(program, replaced);
  } else {
    // From the last to the first: queries find them in source order, events come in reverse.
    const auto& initial = program.beliefs();
    for (std::size_t i = initial.size(); i > 0; --i) begin_with(initial[i - 1], replaced);
  }
  for (const auto& [predicate, table] : program.rule_tables()) {
    beliefs_.share_rule_table(predicate, table);
  }
  for (const Program::Goal& goal : program.goals()) {
    ScratchSlots slots(machine().unifier(), goal.slot_count);
    machine().unifier().set_slot_names(goal.slot_names);
    add_goal(machine().unifier().instantiate(goal.literal, slots.data()));
    machine().unifier().commit(0);
  }
}

void Agent::start_if_due() {
  if (!starts_later_) return;
  starts_later_ = false;
  start({}, {});
  rest();
}

bool Agent::is_active() const {
  const Circumstance& c = circumstance_;
  if (starts_later_) return true;
  if (!c.mailbox.empty() || !c.feedback.empty() || unseen_ != nullptr) return true;
  if (c.atomic != nullptr || c.atomic_event || !c.tasks.empty()) return true;
  if (changed_ && (formula_waits_ > 0 || goal_conditions_ > 0)) return true;
  if (c.atomic_suspended) return false;
  return !c.events.empty() || !c.running.empty();
}

std::size_t Agent::condition_asked(std::size_t number, std::span<const Value> variables) {
  return observer_->condition_asked(*this, number, variables);
}

void Agent::condition_answered(std::size_t number, std::size_t asking) {
  observer_->condition_answered(*this, number, asking);
}

bool Agent::interrupted() {
  return (observer_ != nullptr && observer_->interrupted()) || host_.interrupted();
}

Intention* Agent::executing() const {
  if (executing_ != nullptr || selected_event_ == nullptr) return executing_;
  return selected_event_->intention;
}

// Its literal outlives the query that asks for it.
const Event* Agent::selected_event() {
  if (selected_event_ != nullptr && selected_event_->literal.is_unset()) {
    keep_literal(*selected_event_);
  }
  return selected_event_;
}

const PendingAction* Agent::take_action(std::uint64_t number) {
  if (circumstance_.actions.empty()) return nullptr;
  circumstance_.acting.push_back(circumstance_.actions.front());
  circumstance_.acting.back().number = number;
  circumstance_.actions.pop_front();
  return &circumstance_.acting.back();
}

bool Agent::give_feedback(std::uint64_t number, bool succeeded, std::string reason) {
  auto& acting = circumstance_.acting;
  const auto action = std::find_if(acting.begin(), acting.end(), [&](const PendingAction& each) {
    return each.number == number;
  });
  if (action == acting.end()) return false;
  circumstance_.feedback.push_back(
      {action->intention, succeeded, std::move(reason), action->literal});
  acting.erase(action);
  attention_ = true;
  return true;
}

Value Agent::with_own_source(Value literal) {
  const LiteralParts parts = literal_parts(literal);
  if (parts.annots.same_as(source_self()) || has_source(parts.annots)) return literal;
  if (parts.annots.is_empty_list()) return with_annotations(heap_, literal, source_self());
  return with_annotations(heap_, literal, union_of(heap_, parts.annots, source_self(), symbols_));
}

bool Agent::add_belief(Value literal, Place place, Intention* focus) {
  if (customisation_ != nullptr && customisation_->revise_beliefs) {
    return revise(BeliefRevision::Kind::add, literal, place, focus);
  }
  return believe(literal, place, focus);
}

bool Agent::remove_belief(Value literal, Intention* focus) {
  if (customisation_ != nullptr && customisation_->revise_beliefs) {
    return revise(BeliefRevision::Kind::remove, literal, Place::front, focus);
  }
  return disbelieve(literal, focus);
}

std::optional<Value> Agent::add_fact(Value literal, Place place) {
  heap_.require_room();
  std::optional<Value> added = beliefs_.add(literal, place);
  if (added) heap_.note_other_bytes(Relation::kRowBytes);
  return added;
}

bool Agent::believe(Value literal, Place place, Intention* focus) {
  return believe_as_it_is(with_own_source(literal), place, focus);
}

bool Agent::disbelieve(Value literal, Intention* focus) {
  return disbelieve_as_it_is(with_own_source(literal), focus);
}

// Adds a literal that has a source.
bool Agent::believe_as_it_is(Value literal, Place place, Intention* focus) {
  const std::optional<Value> added = add_fact(literal, place);
  if (!added) return false;
  add_event({TriggerOperator::add, TriggerKind::belief, *added, focus});
  return true;
}

bool Agent::disbelieve_as_it_is(Value literal, Intention* focus) {
  if (!beliefs_.remove(literal, machine().unifier())) return false;
  const Value removed = literal.is_closed() ? literal : machine().unifier().apply(literal);
  add_event({TriggerOperator::remove, TriggerKind::belief, removed, focus});
  return true;
}

Intention& Agent::new_intention() {
  std::unique_ptr<Intention> made;
  if (work().spare_intentions.empty()) {
    made = std::make_unique<Intention>(next_intention_);
  } else {
    made = std::move(work().spare_intentions.back());
    work().spare_intentions.pop_back();
    made->start_again(next_intention_);
  }
  ++next_intention_;
  heap_.note_other_bytes(sizeof(Intention) + sizeof(IntendedMeans));
  circumstance_.intentions.push_back(std::move(made));
  return *circumstance_.intentions.back();
}

// Jason's addRunningIntention: to the end of I, or into the atomic slot.
void Agent::make_ready(Intention& intention) {
  intention.state = Intention::State::running;
  if (intention.is_atomic()) {
    circumstance_.atomic = &intention;
    circumstance_.atomic_suspended = false;
    attention_ = true;
  } else if (&intention == held_) {
    goes_on_ = true;
  } else {
    if (goes_on_) release_held();
    circumstance_.running.push_back(&intention);
  }
}

void Agent::suspend(Intention& intention, Intention::State state, std::string reason) {
  intention.state = state;
  intention.reason = std::move(reason);
  if (!intention.is_atomic()) return;
  circumstance_.atomic_suspended = true;
  attention_ = true;
}

void Agent::resume(Intention& intention) {
  if (intention.also_suspended) {
    // It was suspended by name meanwhile: it is past its formula, but waits for .resume.
    intention.advance();
    intention.also_suspended = false;
    intention.state = Intention::State::suspended;
    intention.reason = "suspend_ia";
    return;
  }
  go_on(intention);
  clear_intention(intention);
}

// It is mostly the one that was put there last, or the one that is held, which is not there: among
// 100,000 intentions it is not searched for.
void Agent::remove_from_running(const Intention& intention) {
  auto& running = circumstance_.running;
  if (running.empty() || (&intention == held_ && !released_)) return;
  if (running.back() == &intention) {
    running.pop_back();
  } else if (intention.state == Intention::State::running) {
    erase_if(running, [&](const Intention* other) { return other == &intention; });
  }
}

void Agent::drop(Intention& intention) {
  Circumstance& c = circumstance_;
  hold_back(intention);
  remove_from_running(intention);
  if (c.atomic == &intention) c.atomic = nullptr;
  if (intention.is_atomic()) c.atomic_suspended = false;
  if (c.atomic_event && c.atomic_event->intention == &intention) c.atomic_event.reset();
  const auto is_its = [&](const auto& item) { return item.intention == &intention; };
  if (intention.has_event) erase_if(c.events, is_its);
  if (!c.actions.empty()) erase_if(c.actions, is_its);
  if (!c.acting.empty()) erase_if(c.acting, is_its);
  if (!c.feedback.empty()) erase_if(c.feedback, is_its);
  for (const IntendedMeans& means : intention.stack) {
    if (means.plan->has_goal_condition) --goal_conditions_;
  }
  if (!c.pending_events.empty()) erase_if(c.pending_events, is_its);
  if (!c.asks.empty()) erase_if(c.asks, is_its);
  if (!c.waits.empty())
    erase_if(c.waits, [&](const Wait& wait) {
      if (wait.intention != intention.id) return false;
      if (wait.has_formula) --formula_waits_;
      return true;
    });
  intention.finish();
  ++finished_;
}

OwnParts& Agent::own() {
  if (own_ == nullptr) own_ = std::make_unique<OwnParts>();
  return *own_;
}

std::span<const std::shared_ptr<const Program>> Agent::included() const {
  if (own_ == nullptr) return {};
  return own_->included;
}

PlanLibrary& Agent::own_library() {
  if (own().library == nullptr) {
    own().library = std::make_unique<PlanLibrary>(program_->library());
    library_ = own().library.get();
  }
  return *own().library;
}

void Agent::add_plan(std::shared_ptr<Plan> plan, Place place) {
  own().plans.push_back(plan);
  place == Place::back ? own_library().add(std::move(plan))
                       : own_library().add_first(std::move(plan));
  note_unusual();
}

void Agent::remove_plan(const Plan& plan) {
  own().labels.erase(&plan);
  own_library().remove(plan);
  note_unusual();
}

// Not before half of them are finished, so that the cost of one does not grow with their number.
// Some are kept, with the memory that they own, for intentions to come.
void Agent::forget_finished() {
  constexpr std::size_t kSpares = 4;
  auto& intentions = circumstance_.intentions;
  if (2 * finished_ < intentions.size()) return;
  std::size_t kept = 0;
  for (auto& intention : intentions) {
    if (intention->state != Intention::State::finished) {
      if (&intentions[kept] != &intention) intentions[kept] = std::move(intention);
      ++kept;
    } else if (work().spare_intentions.size() < kSpares) {
      work().spare_intentions.push_back(std::move(intention));
    }
  }
  intentions.resize(kept);
  finished_ = 0;
}

// Plans that were removed stay while some intention uses them.
void Agent::forget_removed_plans() {
  const auto& intentions = circumstance_.intentions;
  std::erase_if(own_->plans, [&](const std::shared_ptr<Plan>& plan) {
    if (plan.use_count() > 1) return false;
    return std::none_of(intentions.begin(), intentions.end(), [&](const auto& intention) {
      return std::any_of(intention->stack.begin(), intention->stack.end(),
                         [&](const IntendedMeans& means) { return means.plan == plan.get(); });
    });
  });
}

}  // namespace jaywalk
