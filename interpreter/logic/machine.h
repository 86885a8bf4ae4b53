// SPDX-License-Identifier: Apache-2.0
#pragma once

// Solves logical formulas: depth first, left to right, with an explicit stack, so that no recursion
// of a program becomes a recursion of ours. A small machine in the manner of Warren's:
//
//   environment   the frame of a rule (its slots), the goal to go on with afterwards and whose
//                 frame that goal uses; frames lie on a stack and go with the last goal of a rule,
//                 unless a choice point may need them again
//   choice point  where to go on when a goal fails: another row or known answer, the other side of
//                 a disjunction, the next solution of an internal action; it remembers how long the
//                 trail, the frame stack and the heap were
//
// A row that is the last that can match leaves no choice point (head_code.h looks ahead), so loops
// run in constant space. What is bound is written on the trail only as far as some choice point, or
// who asked, may want it undone: neither slots of a frame that is newer than the latest choice
// point nor variables that are.
//
//   machine.cpp            the loop, choice points
//   machine_inline.h       what is in line there: queries, heads, frames
//   machine_queries.cpp    queries over facts and known answers
//   machine_rules.cpp      which rule, its head
//   machine_annotated.cpp  queries with annotations, and variables as queries
//   machine_tests.cpp      comparison and unification
//   machine_calls.cpp      internal actions and functions

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/logic/action.h"
#include "interpreter/logic/beliefs/belief_base.h"
#include "interpreter/logic/beliefs/folded_rules.h"
#include "interpreter/logic/code/code.h"
#include "interpreter/logic/code/known_numbers.h"
#include "interpreter/logic/frame_stack.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/texts_read.h"

namespace jaywalk {

/// Thrown when a query takes more inferences or nests deeper than allowed; caught where the agent
/// executes a step, which fails.
struct QueryLimit {
  std::string message;
  ReachedLimit limit = ReachedLimit::memory;
};

/// The services that queries need from the agent and its world.
class MachineSurroundings {
 public:
  virtual ~MachineSurroundings() = default;
  /// Warnings: arithmetic on an atom, an action that failed within a context.
  virtual void log(std::string_view text) = 0;
  /// `math.random` and its kin draw from here: uniform in [0, 1).
  virtual double draw() = 0;
  /// `system.time`: milliseconds since 1970.
  virtual double clock_ms() = 0;
  /// Whether the query that is under way is to end as if it had hit a limit. Asked now and then.
  [[nodiscard]] virtual bool interrupted() { return false; }
  /// Probes (ReasoningObserver): a condition is asked, with the values of its variables, and the
  /// result names this asking; the condition has an answer.
  [[nodiscard]] virtual std::size_t condition_asked(std::size_t /*number*/,
                                                    std::span<const Value> /*variables*/) {
    return 0;
  }
  virtual void condition_answered(std::size_t /*number*/, std::size_t /*asking*/) {}
};

/// The agent, or other owner, whose queries a machine answers.
struct MachineClient {
  Heap* heap = nullptr;
  BeliefBase* beliefs = nullptr;
  const ActionRegistry* actions = nullptr;
  Agent* agent = nullptr;                       // null in tests
  MachineSurroundings* surroundings = nullptr;  // null: there is neither chance nor time
  TextsRead* texts = nullptr;                   // null: as many as may be
  const std::vector<RuleFunction>* functions = nullptr;
  std::uint64_t max_inferences = 1'000'000'000;
};

/// Whether a head matches; open: it has been left undecided.
enum class HeadMatch : std::uint8_t { fails, holds, open };

class Machine : public FunctionCaller {
 public:
  /// A machine for one client after another; attach() comes before anything else.
  explicit Machine(SymbolTable& symbols);
  void attach(const MachineClient& client);
  Machine(Heap& heap, SymbolTable& symbols, BeliefBase& beliefs, const ActionRegistry& actions);
  ~Machine() override;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  /// The first solution of a formula, whose bindings stay (on the unifier's trail); or false, with
  /// none. A null entry is `true`.
  [[nodiscard]] bool solve(const Goal* entry, Value* slots) {
    return solve_over(entry, slots, Frame::restored);
  }
  /// Like solve(), but the frame's contents are unspecified if there is no solution.
  [[nodiscard]] bool solve_context(const Goal* entry, Value* slots) {
    return solve_over(entry, slots, Frame::given_up);
  }
  /// Whether a formula is none, or one comparison or unification that its operands decide: then
  /// `holds` says whether it holds. Nothing but a probe can meet a limit.
  [[nodiscard, gnu::always_inline]] bool solve_at_once(const Goal* entry, Value* slots,
                                                       bool& holds) {
    holds = true;
    if (entry == nullptr) return true;
    const bool is_decided =
        entry->next == nullptr
            ? decide(*entry, slots, holds)
            : entry->kind == Goal::Kind::probe && decide_between_probes(*entry, slots, holds);
    if (is_decided) ++inferences_;
    return is_decided;
  }
  /// Matches a head with arguments; the unifier has the names of its slots. What is bound is on the
  /// trail; slots that are set are not.
  bool match_head(const HeadCode& code, Value* slots, const Value* args);
  /// Like match_head(), where one look at each argument is enough. The caller must undo the
  /// bindings if the head does not match, or stays open.
  HeadMatch match_head_at_once(const HeadCode& code, Value* slots, const Value* args);
  /// Whether a constant of a head has been matched with one that has annotations since this was
  /// last call: then the head does not show which value it was matched with.
  [[nodiscard]] bool has_lost_annotations() {
    return head_loses_annotations_ && std::exchange(head_loses_annotations_, false);
  }
  /// Every solution in turn; `solution` returns false to stop. No binding stays.
  void solve_all(const Goal* entry, Value* slots, const std::function<bool()>& solution);
  /// REQUIRES: called by the `solution` of solve_all. The numbers that make up all later solutions,
  /// if the whole formula is an action that counts (Solutions::numbers); else null.
  [[nodiscard]] const CountedNumbers* numbers_left(const Goal& entry) const;
  /// The number of solutions; what facts alone answer is counted without a look at each of them.
  [[nodiscard]] std::size_t count_all(const Goal* entry, Value* slots);
  /// A formula that is a term at run time.
  [[nodiscard]] bool solve_term(Value formula);
  void solve_all_terms(Value formula, const std::function<bool()>& solution);

  /// An internal action in a plan body: the first solution's bindings stay. `error` is set with
  /// Outcome::error.
  Outcome call(const Goal& goal, Value* slots, Intention* intention,
               std::unique_ptr<ActionError>& error);

  /// Whether a binding on the trail is of a rule's frame, which is gone when the query is done.
  [[nodiscard]] bool is_in_frame(const Value* cell) const { return frames_.contains(cell); }
  /// Whether a query's caller knows the cell: it is no rule's slot and no variable made since the
  /// one that was to be made next (Heap::first_young) when the query began.
  [[nodiscard]] bool is_known_outside(const Value* cell, std::uint32_t first_young) const {
    static_assert(offsetof(Variable, value) == 0);
    return !is_in_frame(cell) && reinterpret_cast<const Variable*>(cell)->serial < first_young;
  }
  [[nodiscard]] Unifier& unifier() { return unifier_; }
  [[nodiscard]] const Unifier& unifier() const { return unifier_; }
  [[nodiscard]] Heap& heap() { return *heap_; }
  [[nodiscard]] SymbolTable& symbols() { return symbols_; }
  [[nodiscard]] BeliefBase& beliefs() { return *beliefs_; }
  [[nodiscard]] const ActionRegistry& actions() const { return *actions_; }
  /// Texts that become names.
  [[nodiscard]] TextsRead& texts() { return texts_ == nullptr ? own_texts_ : *texts_; }

  /// Other functions than those of the client until the next attach().
  void use_functions(const std::vector<RuleFunction>& functions) { functions_ = &functions; }
  void set_limits(std::uint64_t inferences) { max_inferences_ = inferences; }
  /// Sets the log for warnings, used if there are no surroundings.
  void set_log(std::function<void(std::string_view)> log) { log_ = std::move(log); }
  /// Inferences made so far, of all queries.
  [[nodiscard]] std::uint64_t inferences() const { return inferences_; }
  /// Its stacks have taken much memory, which they keep.
  [[nodiscard]] bool has_grown() const { return has_grown_; }
  /// Throws QueryLimit if an object of `bytes` bytes, beside the terms, exceeds the memory limit.
  void check_memory(std::size_t bytes);
  /// Call this between queries now and then: drops code of formulas made at run time.
  void forget_temporary_code() {
    if (!temporary_.empty()) temporary_.clear();
  }

  bool call_function(const Structure& function, Value& result) override;
  bool call_of_numbers(Predicate function, std::span<const Value> args, Value& result) override;
  void warn(std::string_view message) override;

 private:
  struct Environment {
    Environment* parent;
    const Goal* continuation;
    Value* slots;
    const Symbol* names;
    std::uint32_t slot_count;
    std::uint32_t choice_points;   // when the frame was made
    std::uint32_t slots_recorded;  // by the unifier, then
    std::size_t trail;             // then
  };
  /// Marks the caller's frame: its bindings are recorded even without choice points.
  static constexpr std::uint32_t kOutside = 0xFFFF'FFFFU;
  struct AnnotatedQuery {
    Relation* relation;
    Relation::Cursor cursor;
    std::int64_t seq;         // of the fact whose annotations are being tried
    std::size_t combination;  // the next of their subsets; kNextRow: go to the next row
    Value literal;
  };
  struct ChoicePoint {
    enum class Kind : std::uint8_t { rows, annotated, answers, alternative, negation, solutions };
    Kind kind;
    std::uint16_t answer;  // answers: the next
    std::uint32_t young;   // the first variable that is newer
    const Goal* goal;
    Environment* environment;
    std::size_t trail;
    FrameStack::Mark frames;
    Heap::Mark heap;
    union {
      const Relation* relation;  // rows
      const Answers* answers;    // answers
    };
    // Rows; null: the arguments are those of the goal, else they begin where the frames do without
    // them.
    Value* args;
    Relation::Cursor cursor;
    std::unique_ptr<AnnotatedQuery> annotated;
    std::unique_ptr<ActionCall> call;  // solutions
  };

  /// The state of a frame over which a formula has no solution.
  enum class Frame : std::uint8_t { restored, given_up };
  bool solve_goals(const Goal* entry, Value* slots, Frame frame);
  // A query that is one comparison or unification is mostly decided by its operands.
  [[gnu::always_inline]] bool solve_over(const Goal* entry, Value* slots, Frame frame) {
    bool holds = false;
    return solve_at_once(entry, slots, holds) ? holds : solve_goals(entry, slots, frame);
  }
  // Whether the operands of a comparison or unification are enough to say whether it holds: these
  // are numbers; a variable without a value takes a value that is known. False: nothing is bound.
  [[gnu::always_inline]] bool decide(const Goal& goal, Value* slots, bool& holds) {
    if (goal.kind == Goal::Kind::compare) return compare_numbers(goal, slots, holds);
    Value known;
    if (goal.kind != Goal::Kind::unify || goal.left.kind != Operand::Kind::slot ||
        !find_value(goal.right, slots, known) || Unifier::is_of_other_namespace(known)) {
      return false;
    }
    Value* const slot = slots + goal.left.left_slot;
    if (slot->is_unset()) {
      unifier_.set_slot(slot, known);
    } else {
      const Value held = deref(*slot);
      if (!held.is_variable()) return false;
      unifier_.bind(held.variable(), known);
    }
    return holds = true;
  }
  bool run(std::size_t base);
  bool fail(std::size_t base);
  bool step(const Goal& goal);
  bool retry();
  ChoicePoint& push(ChoicePoint::Kind kind, const Goal& goal);
  void pop();
  void cut(std::size_t kept);
  void restore(const ChoicePoint& choice);
  bool finish_negation(const Goal& done);
  void leave_frame();
  void give_up(const Environment& frame);
  void use_frame(const Environment& frame);
  std::uint64_t* allocate_frame(std::size_t words) {
    if (!frames_.has_room(words)) check_frames();
    return frames_.allocate(words);
  }
  void check_frames();
  // Its slots are still to be cleared.
  Environment* make_environment(Environment* parent, const Goal* continuation,
                                std::span<const Symbol> names) {
    static_assert(sizeof(Environment) % sizeof(std::uint64_t) == 0);
    constexpr std::size_t kWords = sizeof(Environment) / sizeof(std::uint64_t);
    std::uint64_t* const block = allocate_frame(kWords + names.size());
    return new (block) Environment{.parent = parent,
                                   .continuation = continuation,
                                   .slots = reinterpret_cast<Value*>(block + kWords),
                                   .names = names.data(),
                                   .slot_count = static_cast<std::uint32_t>(names.size()),
                                   .choice_points = choice_count_,
                                   .slots_recorded = unifier_.slots_recorded(),
                                   .trail = unifier_.mark()};
  }

  bool query(const Goal& goal);
  Value* registers_for(const Goal& goal);
  const Value* make_arguments(const Goal& goal);
  const Value* look_at_arguments(const Goal& goal);
  bool query_few(Relation& relation, const Goal& goal);
  [[nodiscard]] bool asks_for_all(const Goal& goal) const;
  bool query_answers(const Answers& answers, const Goal& goal);
  bool retry_answers();
  bool take_answer(std::span<const Value> answer, const Goal& goal);
  bool try_rows(Relation& relation, const Goal& goal, const Value* args);
  void push_rows(const Relation& relation, const Relation::Cursor& cursor, const Goal& goal,
                 const Value* args);
  bool retry_rows();
  bool leave_rows(const Row* row, const Goal& goal, const Value* saved);
  bool enter_row(const Row& row, const Goal& goal, const Value* args);
  bool match_argument(Value known, Value wanted, Value term);
  template <class Argument>
  bool match_each(Value fact, std::span<const Value> terms, Argument argument);
  bool match_fact(Value fact, const Value* args, std::span<const Value> terms);
  [[nodiscard]] std::optional<std::size_t> count_facts(const Goal& goal, const Value* slots);
  bool choose_rule(Relation& relation, const RuleTable& table, const Goal& goal, const Value* args);
  bool enter_rule(const RuleCode& rule, const Goal& goal, const Value* args);
  bool enter_framed(const RuleCode& rule, const Goal& goal, const Value* args);
  bool match_bodiless(const RuleCode& rule, const Goal& goal, const Value* args);
  static void clear(const RuleCode& rule, Value* slots);
  bool match_steps(const HeadCode& code, Value* slots, const Value* args);
  template <HeadStep::Kind kHead>
  bool match_usual_pair(const HeadCode& code, const HeadStep* step, Value* slots, Value value);
  bool match_pair(const HeadCode& code, const HeadStep* step, Value* slots, Value value);
  bool match_deep_pair(const HeadCode& code, const HeadStep* step, Value* slots, Value value);
  bool match_part(const HeadCode& code, const HeadStep& step, Value* slots, Value value);
  bool match_constant(const HeadCode& code, const HeadStep& step, Value* slots, Value value);
  bool match_term(const HeadCode& code, const HeadStep& step, Value* slots, Value value);
  bool match_again(const HeadCode& code, Value value, Value known);
  Value make_part(const HeadStep& step, Value* slots);

  static constexpr std::size_t kNextRow = static_cast<std::size_t>(-1);
  bool slow_query(const Goal& goal, Value literal);
  bool try_annotated(AnnotatedQuery query, const Goal& goal);
  bool unify_subset(Value literal, Value fact, std::size_t combination, bool& exhausted);
  bool variable_goal(const Goal& goal);
  [[nodiscard]] std::vector<Relation*> relations_for(Value pattern) const;
  bool any_belief(const Goal& goal, Value pattern);
  bool enter_term(Value formula, const Goal& goal);

  bool unify_sides(const Goal& goal, Value* slots);
  bool compare_sides(const Goal& goal, Value* slots);
  bool compare_values(const Goal& goal, Value left, Value right);
  bool enter_unfolded(const Goal& goal);
  bool univ(const Goal& goal);
  bool decide_between_probes(const Goal& asked, Value* slots, bool& holds);
  void probe(const Goal& goal, Value* slots);
  bool action(const Goal& goal);
  bool next_solution();
  void count_inference() {
    if (++inferences_ >= next_check_) check_limits();
  }
  // Counts inferences that known answers save, so that limits are reached in the same places.
  void count_inferences(std::uint64_t more) {
    inferences_ += more;
    if (inferences_ < next_check_) return;
    inferences_ = std::min(inferences_, query_start_ + max_inferences_ + 1);
    check_limits();
  }
  // How many inferences come between two looks at the limits.
  static constexpr std::uint64_t kChecked = 4096;
  void check_limits();
  void grow_choices();
  [[nodiscard]] bool has_memory(std::size_t bytes);
  [[nodiscard]] std::size_t stack_bytes() const;
  void start_query() {
    query_start_ = inferences_;
    next_check_ = inferences_ + std::min<std::uint64_t>(kChecked, max_inferences_ + 1);
  }

  // Saves the state that a run changes and restores it, also when a limit ends the run.
  class Run;
  void begin_nested();
  void end_nested();

  Heap* heap_ = nullptr;
  SymbolTable& symbols_;
  BeliefBase* beliefs_ = nullptr;
  const ActionRegistry* actions_ = nullptr;
  Unifier unifier_;
  Agent* agent_ = nullptr;
  MachineSurroundings* surroundings_ = nullptr;
  TextsRead* texts_ = nullptr;
  TextsRead own_texts_;
  const std::vector<RuleFunction>* functions_ = nullptr;
  std::function<void(std::string_view)> log_;

  const Goal* goal_ = nullptr;
  Environment* environment_ = nullptr;
  Environment* root_ = nullptr;
  std::vector<ChoicePoint> choices_;
  std::uint32_t choice_count_ = 0;
  FrameStack frames_;
  std::vector<Value> registers_;        // the arguments of a query
  std::vector<Value> spare_registers_;  // memory for those of one within it
  /// The state that a run keeps of the enclosing run.
  struct Outer {
    const Goal* goal;
    Environment* environment;
    Environment* root;
    std::uint32_t young;
    std::uint32_t run_young;
    std::vector<Value> registers;
  };
  std::vector<Outer> outer_;
  std::uint32_t run_young_ = Unifier::kNoneYoung;  // the first variable made since who asked asked
  std::vector<std::unique_ptr<FormulaCode>> temporary_;
  std::uint64_t inferences_ = 0;
  std::uint64_t query_start_ = 0;
  std::uint64_t next_check_ = 0;  // when to check the limits again
  std::uint64_t max_inferences_ = 1'000'000'000;
  int nesting_ = 0;
  bool has_grown_ = false;
  bool head_loses_annotations_ = false;

  const std::vector<RuleFunction> own_functions_;  // none
  // Functions that this client has called lately, by the last bits of their predicates.
  struct KnownFunction {
    Predicate predicate{};
    const FunctionDefinition* definition = nullptr;
  };
  std::array<KnownFunction, 4> known_functions_;
  std::uint32_t symbols_cleared_ = 0;  // when these were found
};

}  // namespace jaywalk
