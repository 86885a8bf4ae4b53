#include "interpreter/logic/machine.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/logic/formula_compiler.h"
#include "interpreter/logic/univ.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

constexpr int kMaxNestedQueries = 150;
constexpr std::size_t kMaxTemporaryCode = 1'000'000;

// The facts and answers of rules for a query that is a free variable.
class ListedSolutions : public Solutions {
 public:
  ListedSolutions(Value pattern, std::vector<Value> found)
      : pattern_(pattern), found_(std::move(found)) {}

  bool next(ActionCall& call) override {
    while (next_ < found_.size()) {
      if (call.unifier().unify(pattern_, call.unifier().fresh_copy(found_[next_++]))) return true;
    }
    return false;
  }

 private:
  Value pattern_;
  std::vector<Value> found_;
  std::size_t next_ = 0;
};

std::size_t list_length(Value list) {
  std::size_t length = 0;
  for (list = deref(list); list.is_pair(); list = deref(list.pair()->tail)) ++length;
  return length;
}

// The `ordinal`-th subset of `wanted` out of `count` in lexicographic order; empty at the end.
std::vector<std::size_t> subset(std::size_t count, std::size_t wanted, std::size_t ordinal) {
  std::vector<std::size_t> chosen(wanted);
  for (std::size_t i = 0; i < wanted; ++i) chosen[i] = i;
  for (; ordinal > 0; --ordinal) {
    std::size_t i = wanted;
    while (i > 0 && chosen[i - 1] == count - wanted + i - 1) --i;
    if (i == 0) return {};
    ++chosen[i - 1];
    for (; i < wanted; ++i) chosen[i] = chosen[i - 1] + 1;
  }
  return chosen;
}

// Undoes what is bound while it lives, unless that is kept; also when a limit ends a query.
class UndoGuard {
 public:
  explicit UndoGuard(Unifier& unifier) : unifier_(unifier), mark_(unifier.mark()) {}
  ~UndoGuard() {
    if (!kept_) unifier_.undo(mark_);
  }
  UndoGuard(const UndoGuard&) = delete;
  UndoGuard& operator=(const UndoGuard&) = delete;
  void keep() { kept_ = true; }

 private:
  Unifier& unifier_;
  std::size_t mark_;
  bool kept_ = false;
};

}  // namespace

void FrameStack::next_chunk(std::size_t words) {
  while (chunk_ >= chunks_.size() || used_ + words > sizes_[chunk_]) {
    if (chunk_ + 1 > chunks_.size()) {
      const std::size_t size = std::max(words, chunks_.empty() ? kChunkWords / 16 : kChunkWords);
      chunks_.push_back(std::make_unique_for_overwrite<std::uint64_t[]>(size));
      sizes_.push_back(size);
    } else {
      ++chunk_;
    }
    used_ = 0;
  }
}

bool FrameStack::contains(const void* address) const {
  const auto* const word = static_cast<const std::uint64_t*>(address);
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    if (std::less_equal<>{}(chunks_[i].get(), word) &&
        std::less<>{}(word, chunks_[i].get() + sizes_[i])) {
      return true;
    }
  }
  return false;
}

class Machine::Run {
 public:
  Run(Machine& machine, const Goal* entry, Value* slots)
      : machine_(machine),
        goal_(machine.goal_),
        environment_(machine.environment_),
        outer_root_(machine.root_),
        frames_(machine.frames_.mark()),
        names_(machine.unifier_.slot_names()),
        trail_(machine.unifier_.mark()),
        base_(machine.choices_.size()),
        root_{nullptr, nullptr, slots,
              names_,  frames_, static_cast<std::uint32_t>(base_),
              0,       0,       machine.unifier_.mark()} {
    if (machine.nesting_ == 0) machine.start_query();
    if (++machine.nesting_ > kMaxNestedQueries) {
      --machine.nesting_;
      throw QueryLimit{fmt::format("queries within queries, {} deep", kMaxNestedQueries)};
    }
    machine.unifier_.end_fresh_frame();
    machine.goal_ = entry;
    machine.environment_ = &root_;
    machine.root_ = &root_;
  }
  ~Run() {
    --machine_.nesting_;
    machine_.unifier_.end_fresh_frame();
    if (!keeps_bindings_) machine_.unifier_.undo(trail_);
    machine_.choices_.erase(machine_.choices_.begin() + static_cast<std::ptrdiff_t>(base_),
                            machine_.choices_.end());
    machine_.frames_.release(frames_);
    machine_.goal_ = goal_;
    machine_.environment_ = environment_;
    machine_.root_ = outer_root_;
    machine_.unifier_.set_slot_names(names_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  [[nodiscard]] std::size_t base() const { return base_; }
  /// What the run has bound stays; else it is undone at its end, also when a limit ends it.
  void keep_bindings() { keeps_bindings_ = true; }

 private:
  Machine& machine_;
  const Goal* goal_;
  Environment* environment_;
  Environment* outer_root_;
  FrameStack::Mark frames_;
  std::span<const Symbol> names_;
  std::size_t trail_;
  std::size_t base_;
  bool keeps_bindings_ = false;
  Environment root_;
};

Machine::Machine(Heap& heap, SymbolTable& symbols, BeliefBase& beliefs,
                 const ActionRegistry& actions)
    : Machine(symbols) {
  attach({.heap = &heap, .beliefs = &beliefs, .actions = &actions});
}

Machine::Machine(SymbolTable& symbols) : symbols_(symbols), unifier_(symbols) {
  unifier_.set_functions(this);
}

void Machine::attach(const MachineClient& client) {
  heap_ = client.heap;
  beliefs_ = client.beliefs;
  actions_ = client.actions;
  agent_ = client.agent;
  surroundings_ = client.surroundings;
  functions_ = client.functions == nullptr ? &own_functions_ : client.functions;
  max_inferences_ = client.max_inferences;
  unifier_.set_heap(*client.heap);
}

Machine::~Machine() = default;

// The comparisons and unifications with which many contexts begin, or of which they consist, leave
// no choice: they need neither frame nor choice point. `goal` becomes the first that needs them.
Machine::Tests Machine::test_in_place(const Goal*& goal, Value* slots) {
  if (nesting_ == 0) start_query();
  for (; goal != nullptr; goal = goal->next) {
    bool holds = true;
    switch (goal->kind) {
      case Goal::Kind::compare:
        holds = compare(*goal, slots);
        break;
      case Goal::Kind::unify:
        holds = unify(*goal, slots);
        break;
      case Goal::Kind::truth:
        break;
      default:
        return Tests::undecided;
    }
    count_inference();
    if (!holds) return Tests::fail;
  }
  return Tests::hold;
}

bool Machine::solve(const Goal* entry, Value* slots) {
  UndoGuard bindings(unifier_);
  const Tests tests = test_in_place(entry, slots);
  if (tests == Tests::fail) return false;
  if (tests == Tests::undecided) {
    Run state(*this, entry, slots);
    if (!run(state.base())) return false;
    state.keep_bindings();
  }
  bindings.keep();
  return true;
}

void Machine::solve_all(const Goal* entry, Value* slots, const std::function<bool()>& solution) {
  if (entry == nullptr) {
    const std::size_t trail = unifier_.mark();
    solution();
    unifier_.undo(trail);
    return;
  }
  Run state(*this, entry, slots);
  bool found = run(state.base());
  while (found) {
    const bool more = solution();
    heap().protect();  // what the caller made of the solution
    found = more && fail(state.base()) && run(state.base());
  }
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

bool Machine::run(std::size_t base) {
  for (;;) {
    if (goal_ == nullptr) {
      if (environment_ == root_) return true;
      goal_ = environment_->continuation;
      environment_ = environment_->parent;
      continue;
    }
    count_inference();
    if (!step() && !fail(base)) return false;
  }
}

// One goal. False: it failed.
bool Machine::step() {
  const Goal& goal = *goal_;
  unifier_.set_slot_names(environment_->names);
  bool holds = false;
  switch (goal.kind) {
    case Goal::Kind::query:
      return query(goal);
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
      holds = unify(goal, environment_->slots);
      break;
    case Goal::Kind::compare:
      holds = compare(goal, environment_->slots);
      break;
    case Goal::Kind::univ:
      holds = univ(goal);
      break;
    case Goal::Kind::truth:
      holds = true;
      break;
    case Goal::Kind::falsity:
      break;
  }
  if (!holds) return false;
  goal_ = goal.next;
  return true;
}

Machine::ChoicePoint& Machine::push(ChoicePoint::Kind kind, const Goal& goal) {
  if (choices_.size() * sizeof(ChoicePoint) > heap().limit()) {
    throw QueryLimit{"a query leaves too many choices open for the memory allowed"};
  }
  ChoicePoint& choice = choices_.emplace_back();
  choice.kind = kind;
  choice.goal = &goal;
  choice.environment = environment_;
  unifier_.end_fresh_frame();
  choice.trail = unifier_.mark();
  choice.frames = frames_.mark();
  choice.heap = heap().mark();
  return choice;
}

void Machine::restore(const ChoicePoint& choice) {
  unifier_.undo(choice.trail);
  frames_.release(choice.frames);
  heap().release(choice.heap);
  environment_ = choice.environment;
}

// Goes back to the latest choice point that has something left; false if there is none above
// `base`. A loop: a query may leave any number of choice points that turn out to be empty.
bool Machine::fail(std::size_t base) {
  while (choices_.size() > base) {
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
      choices_.pop_back();
      return try_annotated(query, goal);
    }
    case ChoicePoint::Kind::alternative:
      goal_ = choice.goal->other;
      choices_.pop_back();
      return true;
    case ChoicePoint::Kind::negation:
      goal_ = choice.goal->next;
      choices_.pop_back();
      return true;
    case ChoicePoint::Kind::solutions:
      return next_solution();
  }
  return false;
}

bool Machine::next_solution() {
  ChoicePoint& choice = choices_.back();
  const Goal& goal = *choice.goal;
  // The action may run queries of its own, which use the stack above this choice point.
  std::unique_ptr<ActionCall> call = std::move(choice.call);
  const bool found = call->solutions->next(*call);
  choices_.back().call = std::move(call);
  if (!found) {
    choices_.pop_back();
    return false;
  }
  goal_ = goal.next;
  return true;
}

void Machine::check_limits() {
  if (inferences_ - query_start_ > max_inferences_) {
    throw QueryLimit{fmt::format("a query took more than {} inferences", max_inferences_)};
  }
  if (unifier_.mark() * sizeof(Value*) > heap().limit()) {
    throw QueryLimit{"a query binds too many variables for the memory allowed"};
  }
  if (surroundings_ != nullptr && surroundings_->interrupted()) {
    throw QueryLimit{"the query was interrupted"};
  }
  next_check_ = std::min(inferences_ + kChecked, query_start_ + max_inferences_ + 1);
}

bool Machine::query(const Goal& goal) {
  Relation* const relation = beliefs_->find(goal.predicate);
  if (relation == nullptr) return false;
  const std::span<const Value> args = goal.args();
  registers_.resize(args.size());
  for (std::size_t i = 0; i < args.size(); ++i) {
    registers_[i] = unifier_.build(args[i], environment_->slots);
  }
  Relation::Cursor cursor = relation->open(registers_);
  return try_rows(*relation, cursor, goal);
}

// The candidates of a cursor for the arguments in the registers. The last of them needs no choice
// point: if it fails, so does the query. A fact that matches not needs none either.
bool Machine::try_rows(Relation& relation, Relation::Cursor& cursor, const Goal& goal) {
  std::int64_t seq = 0;
  while (const Row* const row = relation.advance(cursor, seq)) {
    const bool is_last = !cursor.has_more();
    if (row->rule != nullptr) {
      if (is_last) return enter_rule(*row->rule, goal, registers_);
      push_rows(relation, cursor, goal);
      if (enter_rule(*row->rule, goal, registers_)) return true;
      restore(choices_.back());
      frames_.release(choices_.back().below_args);
      choices_.pop_back();
      continue;
    }
    const std::size_t trail = unifier_.mark();
    const Heap::Mark top = heap().mark();
    if (unify_fact(row->fact, registers_)) {
      if (!is_last) {
        push_rows(relation, cursor, goal);
        choices_.back().trail = trail;
        choices_.back().heap = top;
      }
      goal_ = goal.next;
      return true;
    }
    unifier_.undo(trail);
    heap().release(top);
  }
  return false;
}

// A choice point for what is left of a cursor.
void Machine::push_rows(Relation& relation, const Relation::Cursor& cursor, const Goal& goal) {
  const FrameStack::Mark below_args = frames_.mark();
  auto* const saved = reinterpret_cast<Value*>(frames_.allocate(registers_.size()));
  std::copy(registers_.begin(), registers_.end(), saved);
  ChoicePoint& choice = push(ChoicePoint::Kind::rows, goal);
  choice.relation = &relation;
  choice.cursor = cursor;
  choice.args = {saved, registers_.size()};
  choice.below_args = below_args;
}

// The choice point stays as long as it has candidates left.
bool Machine::retry_rows() {
  Relation& relation = *choices_.back().relation;
  const Goal& goal = *choices_.back().goal;
  const std::span<const Value> args = choices_.back().args;
  std::int64_t seq = 0;
  while (const Row* const row = relation.advance(choices_.back().cursor, seq)) {
    if (!choices_.back().cursor.has_more()) {
      registers_.assign(args.begin(), args.end());
      frames_.release(choices_.back().below_args);
      choices_.pop_back();
      if (row->rule != nullptr) return enter_rule(*row->rule, goal, registers_);
      goal_ = goal.next;
      return unify_fact(row->fact, registers_);
    }
    if (row->rule != nullptr) {
      if (enter_rule(*row->rule, goal, args)) return true;
    } else if (unify_fact(row->fact, args)) {
      goal_ = goal.next;
      return true;
    }
    restore(choices_.back());
  }
  frames_.release(choices_.back().below_args);
  choices_.pop_back();
  return false;
}

bool Machine::unify_fact(Value fact, std::span<const Value> args) {
  if (args.empty()) return true;
  if (!fact.is_closed()) fact = unifier_.fresh_copy(fact);
  const Structure& s = *fact.structure();
  for (std::size_t i = 0; i < args.size(); ++i) {
    const Value arg = deref(args[i]);
    const Value other = s.arg(i);
    if (arg.same_as(other)) continue;
    if (arg.is_variable()) {
      unifier_.bind(arg.variable(), other);
    } else if (!unifier_.unify_no_undo(arg, other)) {
      return false;
    }
  }
  return true;
}

Machine::Environment* Machine::make_environment(Environment* parent, const Goal* continuation,
                                                std::span<const Symbol> names,
                                                std::size_t slot_count) {
  constexpr std::size_t kWords = (sizeof(Environment) + 7) / 8;
  const FrameStack::Mark start = frames_.mark();
  if (frames_.words() * sizeof(std::uint64_t) > heap().limit()) {
    throw QueryLimit{"rules nest too deeply for the memory allowed"};
  }
  std::uint64_t* const block = frames_.allocate(kWords + slot_count);
  auto* const slots = reinterpret_cast<Value*>(block + kWords);
  std::fill_n(slots, slot_count, Value());
  return new (block) Environment{parent,
                                 continuation,
                                 slots,
                                 names,
                                 start,
                                 static_cast<std::uint32_t>(choices_.size()),
                                 static_cast<std::uint32_t>(slot_count),
                                 unifier_.slots_recorded(),
                                 unifier_.mark()};
}

bool Machine::enter_rule(const RuleCode& rule, const Goal& goal, std::span<const Value> args) {
  Environment* parent = environment_;
  const Goal* continuation = goal.next;
  if (continuation == nullptr && parent != root_) {
    // The last call of a rule: its frame is not needed any more, unless a choice point keeps it.
    Environment* const caller = parent;
    continuation = caller->continuation;
    parent = caller->parent;
    if (caller->choice_points == choices_.size()) {
      if (unifier_.slots_recorded() != caller->slots_recorded) {
        unifier_.forget(caller->trail, {caller->slots, caller->slot_count});
      }
      frames_.release(caller->start);
    }
  }
  Environment* const made =
      make_environment(parent, continuation, rule.slot_names, rule.slot_count);
  unifier_.set_slot_names(rule.slot_names);
  unifier_.begin_fresh_frame({made->slots, made->slot_count});
  if (!args.empty()) {
    const Value* const head = rule.head.structure()->args();
    for (std::size_t i = 0; i < args.size(); ++i) {
      if (!unifier_.match_value(head[i], made->slots, args[i])) return false;
    }
  }
  environment_ = made;
  goal_ = rule.body.entry;
  return true;
}

bool Machine::slow_query(const Goal& goal, Value literal) {
  if (!is_literal(literal)) return enter_term(literal, goal);
  const LiteralParts parts = literal_parts(literal);
  Relation* const relation = beliefs_->find(parts.predicate);
  if (relation == nullptr) return false;
  return try_annotated({relation, relation->open(parts.args), 0, kNextRow, literal}, goal);
}

// Facts with each subset of their annotations that is as large as the query's; rules by their head.
bool Machine::try_annotated(AnnotatedQuery query, const Goal& goal) {
  const LiteralParts parts = literal_parts(query.literal);
  for (;;) {
    if (query.combination == kNextRow) {
      if (query.relation->advance(query.cursor, query.seq) == nullptr) return false;
      query.combination = 0;
    }
    const Row& row = query.relation->row(query.seq);
    ChoicePoint& choice = push(ChoicePoint::Kind::annotated, goal);
    choice.annotated = std::make_unique<AnnotatedQuery>(query);
    if (row.is_hole()) {
      query.combination = kNextRow;
    } else if (row.rule != nullptr) {
      choice.annotated->combination = kNextRow;
      Environment* const caller = environment_;
      // The head's annotations are in the rule's variables, hence the frame first.
      const bool entered =
          enter_rule(*row.rule, goal, parts.args) &&
          unifier_.unify_annotations(
              parts.annots,
              unifier_.instantiate(literal_parts(row.rule->head).annots, environment_->slots));
      if (entered) return true;
      environment_ = caller;
      query.combination = kNextRow;
    } else {
      bool exhausted = false;
      choice.annotated->combination = query.combination + 1;
      if (unify_subset(query.literal, row.fact, query.combination, exhausted)) {
        goal_ = goal.next;
        return true;
      }
      query.combination = exhausted ? kNextRow : query.combination + 1;
    }
    restore(choices_.back());
    choices_.pop_back();
  }
}

bool Machine::unify_subset(Value literal, Value fact, std::size_t combination, bool& exhausted) {
  if (!fact.is_closed()) fact = unifier_.fresh_copy(fact);
  const LiteralParts wanted = literal_parts(literal);
  const LiteralParts known = literal_parts(fact);
  Value tail = deref(wanted.annots);
  while (tail.is_pair()) tail = deref(tail.pair()->tail);
  const std::size_t count = list_length(wanted.annots);
  const std::size_t available = list_length(known.annots);
  Value annots = known.annots;
  if (tail.is_variable()) {
    exhausted = combination > 0;  // an open set takes them all, once
  } else {
    const std::vector<std::size_t> chosen =
        count > available ? std::vector<std::size_t>{} : subset(available, count, combination);
    exhausted = chosen.empty();
    std::vector<Value> all;
    for (Value a = known.annots; a.is_pair(); a = a.pair()->tail) all.push_back(a.pair()->head);
    std::vector<Value> some;
    for (const std::size_t index : chosen) some.push_back(all[index]);
    annots = heap().list(some);
  }
  if (exhausted) return false;
  return unify_fact(fact, wanted.args) && unifier_.unify_annotations(wanted.annots, annots);
}

bool Machine::variable_goal(const Goal& goal) {
  const Value value = unifier_.instantiate(goal.term, environment_->slots);
  const bool open =
      value.is_variable() || (value.is_structure() && value.structure()->form() == Form::decorated);
  return open ? any_belief(goal, value) : enter_term(value, goal);
}

bool Machine::enter_term(Value formula, const Goal& goal) {
  if (temporary_.size() > kMaxTemporaryCode) throw QueryLimit{"too many formulas made in a query"};
  auto code = std::make_unique<FormulaCode>();
  code->entry = FormulaCompiler(*code, *actions_, symbols_).compile(formula, nullptr);
  const Goal* const entry = code->entry;
  temporary_.push_back(std::move(code));
  if (entry != nullptr && entry->kind == Goal::Kind::falsity) return false;
  environment_ = make_environment(environment_, goal.next, {}, 0);
  goal_ = entry;
  return true;
}

// All relations for a variable; for N::p(X) those of that name in any namespace, the default one
// first.
std::vector<Relation*> Machine::relations_for(Value pattern) const {
  const bool named = pattern.is_structure() && is_literal(deref(pattern.structure()->arg(0)));
  Signature wanted;
  if (named) {
    wanted = symbols_.signature(literal_parts(deref(pattern.structure()->arg(0))).predicate);
  }
  std::vector<Relation*> found;
  for (const auto& relation : beliefs_->relations()) {
    Signature signature = symbols_.signature(relation->predicate());
    const bool is_default = signature.ns == names::default_ns;
    signature.ns = wanted.ns;
    if (named && signature != wanted) continue;
    found.insert(named && is_default ? found.begin() : found.end(), relation.get());
  }
  return found;
}

bool Machine::any_belief(const Goal& goal, Value pattern) {
  std::vector<Value> found;
  const std::vector<Relation*> relations = relations_for(pattern);
  for (Relation* const relation : relations) {
    for (std::int64_t seq = relation->end_seq() - 1; seq >= relation->first_seq(); --seq) {
      const Row& row = relation->row(seq);
      if (!row.fact.is_unset()) found.push_back(row.fact);
      if (row.rule == nullptr) continue;
      ScratchSlots slots(unifier_, row.rule->slot_count);
      const RuleCode& rule = *row.rule;
      solve_all(rule.body.entry, slots.data(), [&] {
        found.push_back(unifier_.instantiate(rule.head, slots.data()));
        return true;
      });
    }
  }
  auto call = std::make_unique<ActionCall>(*this, goal, environment_->slots, agent_, nullptr);
  call->solutions = std::make_unique<ListedSolutions>(pattern, std::move(found));
  push(ChoicePoint::Kind::solutions, goal).call = std::move(call);
  return next_solution();
}

bool Machine::unify(const Goal& goal, Value* slots) {
  const Value left = goal.args()[0];
  const Value right = unifier_.build(goal.args()[1], slots);
  const bool foreign = (right.is_atom() && is_foreign(right.atom_id())) ||
                       (right.is_structure() && is_foreign(right.structure()->predicate()));
  if (left.is_slot() && slots[left.slot_index()].is_unset() && !foreign) {
    unifier_.set_slot(slots + left.slot_index(), right);
    return true;
  }
  return unifier_.unify_no_undo(unifier_.build(left, slots), right);
}

bool Machine::compare(const Goal& goal, Value* slots) {
  const Value* const sides = goal.term.structure()->args();
  const Value left = unifier_.build(sides[0], slots);
  const Value right = unifier_.build(sides[1], slots);
  if (left.is_number() && right.is_number()) {
    const double a = left.as_number();
    const double b = right.as_number();
    if (a == a && b == b) {
      switch (goal.predicate) {
        case predicates::less:
          return a < b;
        case predicates::less_equal:
          return a <= b;
        case predicates::greater:
          return a > b;
        case predicates::greater_equal:
          return a >= b;
        case predicates::equal:
          return a == b;
        default:
          return a != b;
      }
    }
  }
  if (left.is_variable() && right.is_variable() && left.same_as(right)) {
    // Unbound variables that have been unified are still two: Jason compares their names.
    const bool one = goal.args()[0].same_as(goal.args()[1]);
    if (goal.predicate == predicates::equal) return one;
    if (goal.predicate == predicates::not_equal) return !one;
  }
  const Value a = unifier_.apply(left);
  const Value b = unifier_.apply(right);
  switch (goal.predicate) {
    case predicates::equal:
      return equal_terms(a, b);
    case predicates::not_equal:
      return !equal_terms(a, b);
    default:
      break;
  }
  const int order = compare_terms(a, b, symbols_);
  switch (goal.predicate) {
    case predicates::less:
      return order < 0;
    case predicates::less_equal:
      return order <= 0;
    case predicates::greater:
      return order > 0;
    default:
      return order >= 0;
  }
}

bool Machine::univ(const Goal& goal) {
  const Value left = unifier_.instantiate(goal.args()[0], environment_->slots);
  const Value right = unifier_.instantiate(goal.args()[1], environment_->slots);
  return unify_univ(unifier_, left, right);
}

bool Machine::finish_negation(const Goal& done) {
  std::size_t index = choices_.size() - 1;
  while (choices_[index].kind != ChoicePoint::Kind::negation ||
         choices_[index].goal != done.origin || choices_[index].environment != environment_) {
    --index;
  }
  restore(choices_[index]);
  choices_.erase(choices_.begin() + static_cast<std::ptrdiff_t>(index), choices_.end());
  return false;
}

}  // namespace jaywalk
