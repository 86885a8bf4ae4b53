// SPDX-License-Identifier: Apache-2.0
#pragma once

// A BDI agent: beliefs, plans and a circumstance, and the reasoning cycle that moves them. The
// cycle follows Jason's semantic rules; each is a function that bears its name, in cycle.cpp, in
// order.

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "interpreter/agent/agent_parts.h"
#include "interpreter/agent/known_to_all.h"
#include "interpreter/agent/surroundings/observer.h"

namespace jaywalk {

class Transfer;

class Agent final : public MachineSurroundings, private AgentParts {
 public:
  Agent(std::string name, std::shared_ptr<const Program> program, SymbolTable& symbols,
        AgentHost& host, std::uint64_t seed, const AgentLimits& limits);
  ~Agent() override;
  Agent(const Agent&) = delete;
  Agent& operator=(const Agent&) = delete;

  /// Functions of its own, to be set before it starts; null: none.
  void customise(std::shared_ptr<const Customisation> functions);
  [[nodiscard]] const std::shared_ptr<const Customisation>& customisation() const {
    return customisation_;
  }
  [[nodiscard]] const ReasoningSettings& settings() const { return settings_; }
  void set_settings(const ReasoningSettings& settings);

  /// Adds the initial beliefs and goals; those of the predicates in `replaced` are left out and
  /// `given`, ground literals, come instead.
  void start(std::span<const Predicate> replaced, std::span<const Value> given);
  /// Like start(), but deferred until the agent first reasons or is inspected. REQUIRES:
  /// Program::can_start_later, and the agent is neither observed nor customised.
  void start_later() { starts_later_ = true; }
  void start_if_due();
  /// Starts as a copy of another agent of the same program, in the midst of its work (clone.cpp).
  void copy_from(const Agent& original);

  /// Belief update (Jason's buf): adds new percepts and removes those that are no longer perceived
  /// (perception.cpp). With `nrcbp` it waits for the next cycle with an update.
  void update_percepts(const Percepts& percepts, const KnownToAll& known = {});
  /// Updates beliefs now from the latest percepts, whatever `nrcbp` says (`.perceive`).
  void perceive_now();
  /// Reasons for at least one cycle and `most` at most, as long as it has something to do and has
  /// not asked anything of its host. The result is how many cycles that were.
  std::uint64_t reason(std::uint64_t most);
  /// Does something with the agent from outside, between two cycles. False: a limit stopped it, and
  /// `problem` says which.
  [[nodiscard]] bool intervene(const std::function<void()>& work, std::string& problem);
  /// A cycle would do something.
  [[nodiscard]] bool is_active() const;
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }

  // Messages and actions, to and from the system.
  void receive(const Message& message);
  /// The action to execute next, taken from the queue under that number; null if none is chosen.
  [[nodiscard]] const PendingAction* take_action(std::uint64_t number);
  /// False: no such action is pending, or its intention has been dropped.
  bool give_feedback(std::uint64_t number, bool succeeded, std::string reason);
  void timer_fired(std::uint64_t token);
  /// Whether timer_fired would still do something.
  [[nodiscard]] bool expects_timer(std::uint64_t token);

  // For internal actions and observers.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Its number in the system that it lives in, which gives it.
  [[nodiscard]] std::uint32_t number() const { return number_; }
  void set_number(std::uint32_t number) { number_ = number; }
  [[nodiscard]] AgentHost& host() { return host_; }
  /// The turn in which it reasons; another one may be set while it is at rest.
  [[nodiscard]] AgentTurn& turn() { return *turn_; }
  void set_turn(AgentTurn& turn) { turn_ = &turn; }
  /// The machine that answers its queries, borrowed from the system until the end of its cycle.
  [[nodiscard]] Machine& machine() { return work().machine; }
  /// Call this after making the agent act outside of its cycles.
  void rest();
  [[nodiscard]] BeliefBase& beliefs() { return beliefs_; }
  [[nodiscard]] const BeliefBase& beliefs() const { return beliefs_; }
  [[nodiscard]] Heap& heap() { return heap_; }
  /// Collects garbage and recounts the agent's memory, if its heap needs that. REQUIRES: the agent
  /// is between two cycles.
  void clean_up();
  [[nodiscard]] SymbolTable& symbols() { return symbols_; }
  [[nodiscard]] const SymbolTable& symbols() const { return symbols_; }
  [[nodiscard]] Circumstance& circumstance() { return circumstance_; }
  [[nodiscard]] const Circumstance& circumstance() const { return circumstance_; }
  [[nodiscard]] const PlanLibrary& library() const { return *library_; }
  [[nodiscard]] JavaRandom& random() { return random_; }
  [[nodiscard]] const Program& program() const { return *program_; }
  /// Null: unobserved.
  [[nodiscard]] ReasoningObserver* observer() const { return observer_; }
  /// Why it has dropped intentions, in the order of the first times.
  [[nodiscard]] const LazyContainer<std::vector<DropCause>>& drops() const { return drops_; }

  /// Believes a literal (source(self) if it has no source) and makes the event; `focus` is the
  /// intention that waits for it, or null. True: something changed.
  bool add_belief(Value literal, Place place, Intention* focus);
  bool remove_belief(Value literal, Intention* focus);
  /// Puts an event into the queue, if some plan may be for it or an intention waits for it.
  void add_event(const Event& event);
  /// Posts a goal as an external event.
  void add_goal(Value literal);

  /// Null: no intention has this number, or none any more.
  [[nodiscard]] Intention* find_intention(std::uint32_t id);
  /// Announces that a goal changed its state, to plans `^!g[state(S)[reason(R)]]`.
  void signal_goal_state(TriggerKind kind, Value goal, std::string_view state,
                         std::string_view reason = {}) {
    if ((unusual_ & kGoalStates) != 0) add_goal_state(kind, goal, state, reason);
  }
  void signal_goal_state(TriggerKind kind, Value goal, std::string_view state, Value reason);
  /// Signals a state of the goal on top of an intention, if there is one.
  void signal_top_state(const Intention& intention, std::string_view state, Value reason);
  /// The intention whose formula is executed, or for whose event a plan is looked for; null: none.
  [[nodiscard]] Intention* executing() const;
  /// The event for which a plan is being looked for, or null.
  [[nodiscard]] const Event* selected_event();
  /// The literal of the event for which a means was added.
  [[nodiscard]] Value goal_of(const Intention& intention, const IntendedMeans& means);

  /// Makes an intention wait for answers to a question that it has sent, for ever if `timeout_ms`
  /// is negative.
  void wait_for_answers(Intention& intention, PendingAsk ask, double timeout_ms);
  /// Ends the wait for a question that was not sent to an agent: with its answer, or because it
  /// failed. Nothing if no intention waits for it any more.
  void answer_question(MessageId question, Value answer);
  void fail_question(MessageId question, const ActionError& error);
  /// A name for a message. Names come again after very many messages.
  [[nodiscard]] MessageId new_message_id(MessageId::Kind kind);

  /// Makes an intention wait; resume() goes on with it behind the current formula.
  void suspend(Intention& intention, Intention::State state, std::string reason);
  void resume(Intention& intention);
  /// Goes on with a waiting intention whose current formula failed.
  void fail_waiting(Intention& intention, const ActionError& error);
  void drop(Intention& intention);

  /// A number for a timer of its own.
  [[nodiscard]] std::uint64_t new_token() { return next_token_++; }

  /// Adds a plan made at run time, last or first.
  void add_plan(std::shared_ptr<Plan> plan, Place place);
  void remove_plan(const Plan& plan);
  /// The plan's label with the sources that this agent has it from; a template of the plan's slots.
  [[nodiscard]] Value label_of(const Plan& plan) const;
  /// The label as a term whose variables are fresh.
  [[nodiscard]] Value label_term(const Plan& plan);
  /// Takes a source away, and the plan too when no other is left; nothing if it is none of them.
  void remove_plan_source(const Plan& plan, Value source);
  /// The plan as a term whose variables are fresh.
  [[nodiscard]] Value plan_term(const Plan& plan);
  /// Adds a term of form plan, or its source to an equal plan; `problem`: why that is impossible.
  [[nodiscard]] bool add_plan_term(Value term, Value source, Place place, std::string& problem);
  [[nodiscard]] const Plan* plan_with_label(Value label) const;
  /// The plans whose trigger unifies, whatever their context.
  [[nodiscard]] std::vector<const Plan*> relevant_plans(TriggerOperator op, TriggerKind kind,
                                                        Value literal);
  /// Takes over the beliefs, goals, plans and functions of a program loaded at run time; false,
  /// and nothing of it, if one of its labels is taken: `problem` says so.
  [[nodiscard]] bool include(std::shared_ptr<const Program> program, std::string& problem);
  [[nodiscard]] std::span<const std::shared_ptr<const Program>> included() const;
  /// Adds a term of form rule.
  void add_rule(Value rule, Place place);

  // MachineSurroundings
  void log(std::string_view text) override { host_.log(*this, text); }
  double draw() override { return random_.next_double(); }
  bool interrupted() override;
  double clock_ms() override { return kEpochMs + std::floor(host_.now_ms()); }
  std::size_t condition_asked(std::size_t number, std::span<const Value> variables) override;
  void condition_answered(std::size_t number, std::size_t asking) override;

  /// The literal as told by `sender`: its own sources become annotations of the new one.
  [[nodiscard]] Value add_source(Value literal, Value sender);
  /// "+!g(1)", without annotations.
  [[nodiscard]] std::string trigger_text(const Event& event) const;
  /// The label, or the trigger and the place of a plan without one.
  [[nodiscard]] std::string plan_name(const Plan& plan) const;

 private:
  friend class BeliefRevision;
  friend class Goals;  // goals.h
  friend class Waits;  // waits.h

  // The agent's own functions (customisation.cpp).
  bool revise(BeliefRevision::Kind kind, Value literal, Place place, Intention* focus);
  bool take_selected_event(Event& event);
  Intention* take_selected_intention();
  [[nodiscard]] bool select_option(const std::vector<const Plan*>& plans, const Event& event,
                                   const ScopePtr& scope);
  void find_options(const Plan& plan, const Event& event, const ScopePtr& scope,
                    std::vector<Option>& options);
  void intend(Option& option, const Event& event);
  [[nodiscard]] bool try_learned(const PlanList& plans, const Event& event, const ScopePtr& scope);
  [[nodiscard]] bool choose_learned(std::vector<Option>& options, const Event& event);
  [[nodiscard]] bool observe_for(const Plan& plan, std::vector<double>& features,
                                 ActionError& error);

  void believe_percepts(const Percepts& percepts);
  void believe_changes(const Percepts& percepts);
  void believe_percept(const Percepts& percepts, std::size_t index);
  void announce_percepts();
  [[nodiscard]] bool hears_of_percepts() const;
  void believe_quietly(const Percepts& percepts);

  // Changes of belief as they are without belief revision.
  bool believe(Value literal, Place place, Intention* focus);
  bool believe_as_it_is(Value literal, Place place, Intention* focus);
  bool disbelieve_as_it_is(Value literal, Intention* focus);
  [[nodiscard]] std::optional<Value> add_fact(Value literal, Place place = Place::front);
  bool disbelieve(Value literal, Intention* focus);
  [[nodiscard]] Value with_own_source(Value literal);

  // The reasoning cycle (cycle.cpp).
  /// After a formula of the intention that runs: its next one, rule SelInt, or the cycle's end.
  enum class Next : std::uint8_t { formula, selection, nothing };
  void cycle();
  void end_cycle();
  void abandon_cycle(const ActionError& error);
  Next run(Intention& intention);
  Next go_on_alone(Intention& intention);
  void note_unusual();
  [[nodiscard]] bool has_unusual_business();
  [[nodiscard]] bool is_alone();
  [[nodiscard]] bool comes_next(const Intention& intention) const;
  void announce_next_event();
  void tell_of_next_event();
  void queue_event(const Event& event);
  void queue_next_event(Intention& intention);
  void release_held();
  void hold_back(const Intention& intention);
  void sense();
  void process_message();
  [[nodiscard]] bool answer_arrived(const Message& message);
  [[nodiscard]] std::optional<PendingAsk> take_ask(MessageId question);
  [[nodiscard]] bool ask_timed_out(std::uint64_t token);
  void end_ask(const PendingAsk& ask, Value answer);
  void handle_message(const Message& message);
  [[nodiscard]] bool handle_at_once(Symbol performative, Value content, Value sender);
  void deliberate();
  void act();
  [[nodiscard]] bool no_plan(const Event& event);
  void process_feedback();
  void signal_action_executed(const Intention& intention, Value action);
  Intention* select_intention();
  void add_goal_state(TriggerKind kind, Value goal, std::string_view state,
                      std::string_view reason);

  // Rules RelPl, ApplPl and SelAppl (choose_plan.cpp, options.cpp).
  [[nodiscard]] TriggerKey key_of(const Event& event);
  [[nodiscard]] Value literal_of(const Event& event);
  [[nodiscard]] const PlanList& plans_for(const Event& event, const EventCode* code);
  void keep_literal(const Event& event);
  [[nodiscard]] bool find_option(const Event& event);
  void note_no_option(const Event& event);
  [[nodiscard]] bool were_relevant(const Event& event);
  [[nodiscard]] bool selects_by_rules();
  [[nodiscard]] bool select_by_rules(const Event& event);
  [[nodiscard]] bool is_selected(const Option& option, const Event& event);
  [[nodiscard]] bool try_plans(const PlanList& plans, const Event& event, const ScopePtr& scope);
  [[nodiscard]] const Plan* first_applicable(const PlanList& plans, const Event& event,
                                             std::span<const Value> enclosing);
  [[nodiscard]] const Plan* first_indexed(const PlanList& plans, const Event& event,
                                          std::span<const Value> enclosing);
  [[nodiscard]] bool find_unusual_option(const Event& event);
  [[nodiscard]] bool is_applicable(const Plan& plan, const Event& event,
                                   std::span<const Value> enclosing);
  [[nodiscard]] bool applies(const Plan& plan, const Event& event, const EventArguments& given,
                             std::span<const Value> enclosing);
  [[nodiscard]] bool applies_in_general(const Plan& plan, const Event& event,
                                        const EventArguments& given,
                                        std::span<const Value> enclosing, Value* frame,
                                        std::size_t& matched);
  [[nodiscard]] bool is_relevant(const Plan& plan, const Event& event, const EventArguments& given,
                                 Value* frame);
  [[nodiscard]] bool observed_context_holds(const Plan& plan, const Event& event, Value* frame);
  void leave_plan_at_limit(const Plan& plan, std::size_t trail, Heap::Mark unused);
  void leave_context_at_limit(const Plan& plan, const ActionError& error, Heap::Mark unused);
  Value* empty_frame(const Plan& plan, std::uint32_t first_to_clear);
  Value* prepare_scratch(const Plan& plan, std::span<const Value> enclosing);
  [[nodiscard]] std::vector<Value> closed_off(std::span<const Value> values);

  // Rule AddIM (add_means.cpp).
  [[nodiscard]] std::span<const Value> frame_for(const Plan& plan) const;
  void add_intended_means(const Plan& plan, const Event& event, const ScopePtr& scope);
  void add_means(const Plan& plan, const Event& event, const ScopePtr& scope);
  void push_means(Intention& intention, const Plan& plan, const Event& event,
                  const ScopePtr& scope);
  [[nodiscard]] bool replaces_caller(const Intention& intention, const Event& event);
  [[nodiscard]] bool is_last_call(const Intention& intention, const Event& event);
  void hand_over(const Intention& intention, const IntendedMeans& caller);
  void fill_means(Intention& intention, const Plan& plan, const Event& event,
                  const ScopePtr& scope);
  void fill_rare(IntendedMeans& means, const ScopePtr& scope);
  void announce_means(const Plan& plan, const Event& event, Intention& intention, bool replaces);
  [[nodiscard]] Value settled_literal(const Event& event);

  // Branches for sub-plans (branches.cpp).
  void start_branches(const Event& event);
  void start_branch(Intention& intention, const Plan& plan, const Event& event,
                    const ScopePtr& scope);
  void take_over(Intention& branch);

  // Rule ClrInt (clear.cpp).
  void clear_intention(Intention& intention);
  void signal_end(const Intention& intention, const IntendedMeans& done);
  void finish_means(Intention& intention);
  void pop_means(Intention& intention);
  [[nodiscard]] bool return_closed_values(Intention& intention);
  void return_values(Intention& intention);

  // Execution of one formula (execute.cpp).
  void execute(Intention& intention);
  void execute_formula(Intention& intention);
  void execute_at_limit(Intention& intention, const Step& step);
  void tell_of_formula(const Intention& intention, const Step& step);
  void execute_step(Intention& intention, const Step& step);
  void execute_action(Intention& intention, Value literal);
  void execute_internal_action(Intention& intention, const Goal& goal);
  void execute_constraint(Intention& intention, const Step& step);
  void fail_constraint(Intention& intention);
  void execute_achieve(Intention& intention, const Step& step);
  void achieve(Intention& intention, Value term, Step::Kind kind);
  void execute_test(Intention& intention, const Step& step);
  void fail_test(Intention& intention, const Step& step);
  void execute_belief(Intention& intention, const Step& step);
  void change_belief_by_term(Intention& intention, Value term, Step::Kind kind);
  void change_belief(Intention& intention, Value literal, Step::Kind kind);
  void change_own_belief(Intention& intention, Value literal, Step::Kind kind);
  void execute_replace(Intention& intention, Value literal);
  void forget_for(Value literal);
  [[nodiscard]] bool forget_one(Predicate predicate);
  void execute_variable(Intention& intention, const Step& step);
  void execute_if(Intention& intention, const Step& step);
  void execute_while(Intention& intention, const Step& step);
  void execute_for(Intention& intention, const Step& step);
  void execute_fork(Intention& intention, const Step& step);
  void execute_join(Intention& intention);
  bool leave_failed_branch(Intention& intention);
  Intention& copy_for_branch(Intention& intention);
  // Rounds of `for` (for_loops.cpp).
  [[nodiscard]] Loop::Level collect_solutions(Intention& intention, const Goal* condition,
                                              std::span<const Value> before, std::size_t most);
  void bind_solution(Intention& intention, Loop& loop, std::span<const Value> pairs);
  void open_level(Intention& intention, Loop& loop);
  void extend_level(Intention& intention, Loop& loop);
  [[nodiscard]] bool begin_round(Intention& intention, Loop& loop);
  // The formula is done: the intention goes to the end of I.
  void go_on(Intention& intention) {
    intention.advance();
    stay_ready(intention);
  }
  [[gnu::always_inline]] void stay_ready(Intention& intention) {
    if (&intention != held_ || intention.is_atomic()) return make_ready(intention);
    intention.state = Intention::State::running;
    goes_on_ = true;
  }
  // The literals of goals and beliefs (goal_arguments.cpp).
  [[nodiscard]] bool put_goal(Intention& intention, const EventCode& code);
  void rename_in_goal(Intention& intention);
  void rename_slot(Intention& intention, Value& slot);
  [[nodiscard]] Value ground_belief(Intention& intention, const EventCode& code);
  void note_returns(Intention& intention);
  Value prepare_for_event(Intention& intention, Value term, bool returns);
  [[gnu::always_inline]] void record_bindings(Intention& intention, std::size_t trail) {
    Unifier& unifier = work().machine.unifier();
    if (unifier.mark() == trail) return;
    if (intention.top().has_loops()) note_for_round(intention, trail);
    unifier.commit(trail);
  }
  void note_for_round(Intention& intention, std::size_t trail);
  void undo_round(Intention& intention, Loop& loop);
  bool execute_plan_or_rule(Intention& intention, Value term, Step::Kind kind);
  void change_rules(Value rule, Step::Kind kind);
  void remove_like(Value head);
  [[nodiscard]] Value any_like(Value literal);
  void bind_recorded(Intention& intention, Loop& loop, Value place, Value value);

  // Failure (failure.cpp).
  void fail(Intention& intention, const ActionError& error);
  void fail_at_limit(Intention& intention, const ActionError& error);
  void report_limit(const ActionError& error, std::string where);
  void fail_event(const Event& event, const ActionError& error);
  struct OpenGoal {
    TriggerKind kind = TriggerKind::achieve;
    Value goal;
  };
  [[nodiscard]] std::vector<OpenGoal> open_goals(const Intention& intention);
  void signal_failure(const std::vector<OpenGoal>& goals, const ActionError& error,
                      bool is_handled);
  bool fail_stack(Intention& intention, const ActionError& error, Value code, std::uint32_t line);
  [[nodiscard]] bool post_failure(Intention& intention, std::size_t floor, const ActionError& error,
                                  Value code, std::uint32_t line);
  static void free_goal(Intention& intention, std::size_t depth);
  [[nodiscard]] bool has_failure_plan(TriggerKind kind, Predicate goal, const Scope* scope);
  [[nodiscard]] ActionError applied(ActionError error);
  Value failure_literal(Value literal, const ActionError& error, Value code, std::uint32_t line,
                        const Intention* intention);
  void lose(Intention& intention, const ActionError& error, Value code);
  // Notes the drop of an intention, or of an event that had none (null); drops.cpp.
  const DropCause& note_drop(const Intention* intention, const ActionError& error, Value code);
  [[nodiscard]] std::string drop_details(const Intention& intention, const DropCause& cause) const;
  [[nodiscard]] SourcePtr find_source(const std::string& file) const;

  [[nodiscard]] const Plan* equal_plan(const Plan& plan) const;
  void add_plan_source(const Plan& plan, Value source);
  [[nodiscard]] Value as_template(Value term, std::vector<Symbol>& slot_names);
  void begin(const Program& program, std::span<const Predicate> replaced,
             std::span<const Value> given);
  void begin_with(const Program::Belief& belief, std::span<const Predicate> replaced);
  void begin_with_shared(const Program& program, std::span<const Predicate> replaced);
  // Cloning (clone.cpp).
  using PlanMap = std::unordered_map<const Plan*, const Plan*>;
  void copy_beliefs(const Agent& original, Transfer& transfer);
  PlanMap copy_plans(const Agent& original, Transfer& transfer);
  class GoalCopier;

  [[nodiscard]] OwnParts& own();
  [[nodiscard]] PlanLibrary& own_library();

  // Memory (memory.cpp).
  [[nodiscard]] std::size_t other_bytes();
  void let_go_of_memory();
  [[nodiscard]] bool tells_of_memory();
  [[nodiscard]] static bool handles_failure(const Intention& intention);

  void tidy_up();
  [[nodiscard]] Workspace& work() {
    if (workspace_ == nullptr) borrow_workspace();
    return *workspace_;
  }
  void borrow_workspace();
  void give_back_workspace();
  void make_ready(Intention& intention);
  Intention& new_intention();
  void collect_garbage();
  void visit_roots(Heap::Relocator& relocate);
  [[nodiscard]] bool begin_first_cycles();
  void end_first_cycles();
  void forget_removed_plans();
  void forget_finished();
  void remove_from_running(const Intention& intention);
};

}  // namespace jaywalk
