#pragma once

// Solves logical formulas: depth first, left to right, with an explicit stack, so that no recursion
// of a program becomes a recursion of ours. A small machine in the manner of Warren's:
//
//   environment   the frame of a rule (its slots), the goal to go on with afterwards and whose
//   frame
//                 that goal uses; frames lie on a stack and are reused by the last call of a rule
//   choice point  where to go on when a goal fails: another row, the other side of a disjunction,
//                 the next solution of an internal action; it remembers how long the trail, the
//                 frame stack and the heap were
//
// A row that is the last that can match leaves no choice point, so loops run in constant space.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/logic/action.h"
#include "interpreter/logic/belief_base.h"
#include "interpreter/logic/code.h"
#include "interpreter/logic/unifier.h"

namespace jaywalk {

/// Thrown when a query takes more inferences or nests deeper than allowed; caught where the agent
/// executes a step, which fails.
struct QueryLimit {
  std::string message;
};

/// Memory for frames: chunks that never move, cut back as a stack.
class FrameStack {
 public:
  struct Mark {
    std::uint32_t chunk = 0;
    std::uint32_t used = 0;
  };
  [[nodiscard]] std::uint64_t* allocate(std::size_t words) {
    if (chunk_ >= chunks_.size() || used_ + words > sizes_[chunk_]) next_chunk(words);
    std::uint64_t* const block = chunks_[chunk_].get() + used_;
    used_ += static_cast<std::uint32_t>(words);
    return block;
  }
  [[nodiscard]] Mark mark() const { return {chunk_, used_}; }
  void release(Mark mark) {
    chunk_ = mark.chunk;
    used_ = mark.used;
  }
  /// Roughly how much is in use.
  [[nodiscard]] std::size_t words() const { return std::size_t{chunk_} * kChunkWords + used_; }
  [[nodiscard]] bool contains(const void* address) const;

 private:
  static constexpr std::size_t kChunkWords = 4096;
  void next_chunk(std::size_t words);

  std::vector<std::unique_ptr<std::uint64_t[]>> chunks_;
  std::vector<std::size_t> sizes_;
  std::uint32_t chunk_ = 0;
  std::uint32_t used_ = 0;
};

/// What a machine's queries know of the world around their agent.
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
};

/// A function that is a query, `register_function("my.f", Arity, "pred")`.
struct RuleFunction {
  Symbol name;
  std::uint16_t arity;
  Predicate predicate;
};

/// Whose queries a machine answers.
struct MachineClient {
  Heap* heap = nullptr;
  BeliefBase* beliefs = nullptr;
  const ActionRegistry* actions = nullptr;
  Agent* agent = nullptr;                       // null in tests
  MachineSurroundings* surroundings = nullptr;  // null: there is neither chance nor time
  const std::vector<RuleFunction>* functions = nullptr;
  std::uint64_t max_inferences = 1'000'000'000;
};

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
  [[nodiscard]] bool solve(const Goal* entry, Value* slots);
  /// Every solution in turn; `solution` returns false to stop. No binding stays.
  void solve_all(const Goal* entry, Value* slots, const std::function<bool()>& solution);
  /// A formula that is a term at run time.
  [[nodiscard]] bool solve_term(Value formula);
  void solve_all_terms(Value formula, const std::function<bool()>& solution);

  /// An internal action in a plan body: the first solution's bindings stay.
  Outcome call(const Goal& goal, Value* slots, Intention* intention, ActionError& error);

  /// Whether a binding on the trail is of a rule's frame, which is gone when the query is done.
  [[nodiscard]] bool is_in_frame(const Value* cell) const { return frames_.contains(cell); }
  [[nodiscard]] Unifier& unifier() { return unifier_; }
  [[nodiscard]] Heap& heap() { return *heap_; }
  [[nodiscard]] SymbolTable& symbols() { return symbols_; }
  [[nodiscard]] BeliefBase& beliefs() { return *beliefs_; }
  [[nodiscard]] const ActionRegistry& actions() const { return *actions_; }

  void set_limits(std::uint64_t inferences) { max_inferences_ = inferences; }
  /// Where warnings go if there are no surroundings.
  void set_log(std::function<void(std::string_view)> log) { log_ = std::move(log); }
  /// Inferences made so far, of all queries.
  [[nodiscard]] std::uint64_t inferences() const { return inferences_; }
  /// To be called between queries now and then: drops code of formulas made at run time.
  void forget_temporary_code() { temporary_.clear(); }

  bool call_function(const Structure& function, Value& result) override;
  void warn(std::string_view message) override;

 private:
  struct Environment {
    Environment* parent;
    const Goal* continuation;
    Value* slots;
    std::span<const Symbol> names;
    FrameStack::Mark start;
    std::uint32_t choice_points;  // when the frame was made
    std::uint32_t slot_count;
    std::uint32_t slots_recorded;  // when the frame was made
    std::size_t trail;             // when the frame was made
  };
  struct AnnotatedQuery {
    Relation* relation;
    Relation::Cursor cursor;
    std::int64_t seq;         // of the fact whose annotations are being tried
    std::size_t combination;  // the next of their subsets; kNextRow: go to the next row
    Value literal;
  };
  struct ChoicePoint {
    enum class Kind : std::uint8_t { rows, annotated, alternative, negation, solutions };
    Kind kind;
    const Goal* goal;
    Environment* environment;
    std::size_t trail;
    FrameStack::Mark frames;
    Heap::Mark heap;
    // rows: the arguments stand below `frames`
    Relation* relation = nullptr;
    Relation::Cursor cursor;
    std::span<const Value> args;
    FrameStack::Mark below_args;
    std::unique_ptr<AnnotatedQuery> annotated;
    // solutions
    std::unique_ptr<ActionCall> call;
  };

  bool run(std::size_t base);
  bool fail(std::size_t base);
  bool step();
  bool retry();
  bool query(const Goal& goal);
  bool slow_query(const Goal& goal, Value literal);
  bool try_rows(Relation& relation, Relation::Cursor& cursor, const Goal& goal);
  void push_rows(Relation& relation, const Relation::Cursor& cursor, const Goal& goal);
  bool retry_rows();
  static constexpr std::size_t kNextRow = static_cast<std::size_t>(-1);
  bool try_annotated(AnnotatedQuery query, const Goal& goal);
  bool unify_fact(Value fact, std::span<const Value> args);
  bool unify_subset(Value literal, Value fact, std::size_t combination, bool& exhausted);
  bool enter_rule(const RuleCode& rule, const Goal& goal, std::span<const Value> args);
  bool variable_goal(const Goal& goal);
  [[nodiscard]] std::vector<Relation*> relations_for(Value pattern) const;
  bool any_belief(const Goal& goal, Value pattern);
  bool enter_term(Value formula, const Goal& goal);
  bool next_solution();
  bool unify(const Goal& goal, Value* slots);
  bool compare(const Goal& goal, Value* slots);
  enum class Tests { hold, fail, undecided };
  Tests test_in_place(const Goal*& goal, Value* slots);
  bool univ(const Goal& goal);
  bool action(const Goal& goal);
  bool finish_negation(const Goal& done);
  ChoicePoint& push(ChoicePoint::Kind kind, const Goal& goal);
  void restore(const ChoicePoint& choice);
  Environment* make_environment(Environment* parent, const Goal* continuation,
                                std::span<const Symbol> names, std::size_t slot_count);
  void count_inference() {
    if (++inferences_ >= next_check_) check_limits();
  }
  // How many inferences come between two looks at the limits.
  static constexpr std::uint64_t kChecked = 4096;
  void check_limits();
  void start_query() {
    query_start_ = inferences_;
    next_check_ = inferences_ + std::min<std::uint64_t>(kChecked, max_inferences_ + 1);
  }

  // Saves what a run changes and puts it back, also when a limit ends the run.
  class Run;

  Heap* heap_ = nullptr;
  SymbolTable& symbols_;
  BeliefBase* beliefs_ = nullptr;
  const ActionRegistry* actions_ = nullptr;
  Unifier unifier_;
  Agent* agent_ = nullptr;
  MachineSurroundings* surroundings_ = nullptr;
  const std::vector<RuleFunction>* functions_ = nullptr;
  std::function<void(std::string_view)> log_;

  const Goal* goal_ = nullptr;
  Environment* environment_ = nullptr;
  Environment* root_ = nullptr;
  std::vector<ChoicePoint> choices_;
  FrameStack frames_;
  std::vector<Value> registers_;
  std::vector<std::unique_ptr<FormulaCode>> temporary_;
  std::uint64_t inferences_ = 0;
  std::uint64_t query_start_ = 0;
  std::uint64_t next_check_ = 0;  // when the limits are to be looked at again
  std::uint64_t max_inferences_ = 1'000'000'000;
  int nesting_ = 0;

  const std::vector<RuleFunction> own_functions_;  // none
};

}  // namespace jaywalk
