// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "interpreter/logic/formula_compiler.h"
#include "interpreter/logic/machine_inline.h"

namespace jaywalk {
namespace {

constexpr int kMaxNestedQueries = 150;

}  // namespace

class Machine::Run {
 public:
  [[gnu::always_inline]] Run(Machine& machine, const Goal* entry, Value* slots, Frame frame)
      : machine_(machine),
        frames_(machine.frames_.mark()),
        trail_(machine.unifier_.mark()),
        base_(machine.choice_count_),
        root_{.parent = nullptr,
              .continuation = nullptr,
              .slots = slots,
              .names = machine.unifier_.slot_names().data(),
              .slot_count = static_cast<std::uint32_t>(machine.unifier_.slot_names().size()),
              .choice_points = frame == Frame::given_up ? base_ : kOutside,
              .slots_recorded = 0,
              .trail = trail_} {
    machine.nesting_ == 0 ? machine.start_query() : machine.begin_nested();
    ++machine.nesting_;
    machine.run_young_ = machine.heap().first_young();
    machine.unifier_.set_young(machine.run_young_);
    machine.goal_ = entry;
    machine.environment_ = &root_;
    machine.root_ = &root_;
    machine.use_frame(root_);
  }
  [[gnu::always_inline]] ~Run() {
    Unifier& unifier = machine_.unifier_;
    unifier.end_fresh_frame();
    if (!keeps_bindings_) unifier.undo(trail_);
    if (machine_.choice_count_ > base_) machine_.cut(base_);
    if (machine_.frames_.mark() != frames_) machine_.frames_.release(frames_);
    unifier.set_slot_names({root_.names, root_.slot_count});
    unifier.set_young(Unifier::kNoneYoung);
    if (--machine_.nesting_ > 0) machine_.end_nested();
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  [[nodiscard]] std::size_t base() const { return base_; }
  /// Keeps the run's bindings; else they are undone at its end, also when a limit ends it.
  void keep_bindings() { keeps_bindings_ = true; }

 private:
  Machine& machine_;
  FrameStack::Mark frames_;
  std::size_t trail_;
  std::uint32_t base_;
  bool keeps_bindings_ = false;
  Environment root_;
};

// A function in an argument is a query while the arguments of another are made.
[[gnu::noinline]] void Machine::begin_nested() {
  if (nesting_ == kMaxNestedQueries) {
    throw QueryLimit{fmt::format("queries within queries, {} deep", kMaxNestedQueries),
                     ReachedLimit::nesting};
  }
  outer_.push_back({.goal = goal_,
                    .environment = environment_,
                    .root = root_,
                    .young = unifier_.young(),
                    .run_young = run_young_,
                    .registers = std::exchange(registers_, std::move(spare_registers_))});
}

[[gnu::noinline]] void Machine::end_nested() {
  Outer& outer = outer_.back();
  spare_registers_ = std::exchange(registers_, std::move(outer.registers));
  unifier_.set_young(outer.young);
  run_young_ = outer.run_young;
  goal_ = outer.goal;
  environment_ = outer.environment;
  root_ = outer.root;
  outer_.pop_back();
}

Machine::Machine(Heap& heap, SymbolTable& symbols, BeliefBase& beliefs,
                 const ActionRegistry& actions)
    : Machine(symbols) {
  attach({.heap = &heap, .beliefs = &beliefs, .actions = &actions});
}

Machine::Machine(SymbolTable& symbols) : symbols_(symbols), unifier_(symbols) {
  unifier_.set_functions(this);
}

void Machine::attach(const MachineClient& client) {
  if (actions_ != client.actions || symbols_cleared_ != symbols_.times_cleared()) {
    known_functions_ = {};
    symbols_cleared_ = symbols_.times_cleared();
  }
  heap_ = client.heap;
  beliefs_ = client.beliefs;
  actions_ = client.actions;
  agent_ = client.agent;
  surroundings_ = client.surroundings;
  texts_ = client.texts;
  functions_ = client.functions == nullptr ? &own_functions_ : client.functions;
  max_inferences_ = client.max_inferences;
  unifier_.set_heap(*client.heap);
}

Machine::~Machine() = default;

bool Machine::solve_goals(const Goal* entry, Value* slots, Frame frame) {
  Run state(*this, entry, slots, frame);
  if (!run(state.base())) return false;
  state.keep_bindings();
  return true;
}

void Machine::solve_all(const Goal* entry, Value* slots, const std::function<bool()>& solution) {
  if (entry == nullptr) {
    const std::size_t trail = unifier_.mark();
    solution();
    unifier_.undo(trail);
    return;
  }
  Run state(*this, entry, slots, Frame::restored);
  bool found = run(state.base());
  while (found) {
    const bool more = solution();
    heap().protect();  // what the caller made of the solution
    found = more && fail(state.base()) && run(state.base());
  }
}

std::size_t Machine::count_all(const Goal* entry, Value* slots) {
  if (entry != nullptr && entry->next == nullptr && entry->is_plain) {
    if (const std::optional<std::size_t> known = count_facts(*entry, slots)) return *known;
  }
  std::size_t number = 0;
  solve_all(entry, slots, [&] {
    ++number;
    return true;
  });
  return number;
}

bool Machine::solve_term(Value formula) {
  auto code = std::make_unique<FormulaCode>();
  code->entry = FormulaCompiler(*code, *actions_, symbols_).compile(formula, nullptr);
  const Goal* const entry = code->entry;
  temporary_.push_back(std::move(code));
  return solve(entry, nullptr);
}

void Machine::solve_all_terms(Value formula, const std::function<bool()>& solution) {
  auto code = std::make_unique<FormulaCode>();
  code->entry = FormulaCompiler(*code, *actions_, symbols_).compile(formula, nullptr);
  const Goal* const entry = code->entry;
  temporary_.push_back(std::move(code));
  solve_all(entry, nullptr, solution);
}

// Executes one goal; false if it failed.
[[gnu::always_inline]] inline bool Machine::step(const Goal& goal) {
  bool holds = false;
  switch (goal.kind) {
    case Goal::Kind::query:
      return query(goal);
    case Goal::Kind::unfolded:
      return enter_unfolded(goal);
    case Goal::Kind::slow_query:
      return slow_query(goal, unifier_.instantiate(goal.term, environment_->slots));
    case Goal::Kind::variable:
      return variable_goal(goal);
    case Goal::Kind::action:
      return action(goal);
    case Goal::Kind::negation:
      push(ChoicePoint::Kind::negation, goal);
      goal_ = goal.inner;
      return true;
    case Goal::Kind::negation_done:
      return finish_negation(goal);
    case Goal::Kind::disjunction:
      push(ChoicePoint::Kind::alternative, goal);
      goal_ = goal.inner;
      return true;
    case Goal::Kind::unify:
      if (!decide(goal, environment_->slots, holds)) {
        holds = unify_sides(goal, environment_->slots);
      }
      break;
    case Goal::Kind::compare:
      if (!decide(goal, environment_->slots, holds)) {
        holds = compare_sides(goal, environment_->slots);
      }
      break;
    case Goal::Kind::univ:
      holds = univ(goal);
      break;
    case Goal::Kind::truth:
      holds = true;
      break;
    case Goal::Kind::falsity:
      break;
    case Goal::Kind::probe:
      --inferences_;
      probe(goal, environment_->slots);
      holds = true;
      break;
  }
  if (!holds) return false;
  goal_ = goal.next;
  return true;
}

bool Machine::run(std::size_t base) {
  for (;;) {
    if (goal_ == nullptr) {
      if (environment_ == root_) return true;
      leave_frame();
      continue;
    }
    count_inference();
    if (!step(*goal_) && !fail(base)) return false;
  }
}

// A query's memory beside its terms, whatever room earlier queries, perhaps of other agents, have
// reserved. The trail doubles when it is full.
std::size_t Machine::stack_bytes() const {
  return frames_.words() * sizeof(std::uint64_t) + choices_.size() * sizeof(ChoicePoint) +
         unifier_.mark() * sizeof(Value*) * 3;
}

bool Machine::has_memory(std::size_t bytes) {
  constexpr std::size_t kMuch = std::size_t{16} << 20U;
  const std::size_t all = stack_bytes() + bytes;
  if (all > kMuch) has_grown_ = true;
  return all + heap().all_bytes() <= heap().limit();
}

void Machine::check_memory(std::size_t bytes) {
  if (!has_memory(bytes)) throw QueryLimit{"a query needs more memory than the agent may have"};
}

void Machine::grow_choices() {
  const std::size_t most = std::max<std::size_t>(16, 2 * choices_.capacity());
  if (!has_memory(most * sizeof(ChoicePoint))) {
    throw QueryLimit{"a query leaves too many choices open for the memory allowed"};
  }
  choices_.reserve(most);
}

Machine::ChoicePoint& Machine::push(ChoicePoint::Kind kind, const Goal& goal) {
  if (choices_.size() == choices_.capacity()) grow_choices();
  unifier_.end_fresh_frame();
  unifier_.set_young(heap().first_young());
  ++choice_count_;
  ChoicePoint& choice = choices_.emplace_back();
  choice.kind = kind;
  choice.young = unifier_.young();
  choice.goal = &goal;
  choice.environment = environment_;
  choice.trail = unifier_.mark();
  choice.frames = frames_.mark();
  choice.heap = heap().mark();
  return choice;
}

// Removes the latest choice point. Choice points of outer runs are older than this run's.
void Machine::pop() {
  choices_.pop_back();
  --choice_count_;
  unifier_.set_young(choices_.empty() ? run_young_ : std::max(run_young_, choices_.back().young));
}

// Drops all choice points but the first `kept`.
void Machine::cut(std::size_t kept) {
  choices_.erase(choices_.begin() + static_cast<std::ptrdiff_t>(kept), choices_.end());
  choice_count_ = static_cast<std::uint32_t>(kept);
}

void Machine::restore(const ChoicePoint& choice) {
  unifier_.undo(choice.trail);
  unifier_.set_young(choice.young);
  frames_.release(choice.frames);
  heap().release(choice.heap);
  environment_ = choice.environment;
  use_frame(*environment_);
}

// Goes back to the latest choice point that has something left; false if there is none above
// `base`. A loop: a query may leave any number of choice points that turn out to be empty.
bool Machine::fail(std::size_t base) {
  while (choice_count_ > base) {
    count_inference();
    restore(choices_.back());
    if (retry()) return true;
  }
  return false;
}

// Goes on with the latest choice point. False: it was the last of its choices, and failed.
bool Machine::retry() {
  ChoicePoint& choice = choices_.back();
  switch (choice.kind) {
    case ChoicePoint::Kind::rows:
      return retry_rows();
    case ChoicePoint::Kind::annotated: {
      const AnnotatedQuery query = *choice.annotated;
      const Goal& goal = *choice.goal;
      pop();
      return try_annotated(query, goal);
    }
    case ChoicePoint::Kind::answers:
      return retry_answers();
    case ChoicePoint::Kind::alternative:
      goal_ = choice.goal->other;
      pop();
      return true;
    case ChoicePoint::Kind::negation:
      goal_ = choice.goal->next;
      pop();
      return true;
    case ChoicePoint::Kind::solutions:
      return next_solution();
  }
  return false;
}

void Machine::check_limits() {
  if (inferences_ - query_start_ > max_inferences_) {
    throw QueryLimit{fmt::format("a query took more than {} inferences", max_inferences_),
                     ReachedLimit::inferences};
  }
  check_memory(0);
  if (surroundings_ != nullptr && surroundings_->interrupted()) {
    throw QueryLimit{"the query was interrupted", ReachedLimit::interruption};
  }
  next_check_ = std::min(inferences_ + kChecked, query_start_ + max_inferences_ + 1);
}

// Another block of frames is needed.
void Machine::check_frames() {
  if (!has_memory(0)) {
    throw QueryLimit{"rules nest too deeply for the memory allowed"};
  }
}

bool Machine::finish_negation(const Goal& done) {
  std::size_t index = choices_.size() - 1;
  while (choices_[index].kind != ChoicePoint::Kind::negation ||
         choices_[index].goal != done.origin || choices_[index].environment != environment_) {
    --index;
  }
  restore(choices_[index]);
  cut(index + 1);
  pop();
  return false;
}

}  // namespace jaywalk
