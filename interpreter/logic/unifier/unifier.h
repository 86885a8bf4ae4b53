// SPDX-License-Identifier: Apache-2.0
#pragma once

// Unification and application of unifiers (Jason's `unifies` and `capply`). Bindings are written
// into variable cells and frame slots and recorded on a trail, so that undoing is popping.

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "interpreter/support/containers/flat_stack.h"
#include "interpreter/term/heap.h"
#include "interpreter/term/symbol.h"
#include "interpreter/term/walk.h"

namespace jaywalk {

/// Thrown by `X div 0`; caught where the agent executes a step, which fails.
struct DivisionByZero {};

/// Callbacks of the evaluation of terms: functions that are queries, and warnings.
class FunctionCaller {
 public:
  virtual ~FunctionCaller() = default;
  /// Evaluates a function term whose arguments have been applied. False: it stays as it is.
  virtual bool call_function(const Structure& function, Value& result) = 0;
  /// Calls a function of these numbers directly. False: it cannot be called so.
  virtual bool call_of_numbers(Predicate function, std::span<const Value> args, Value& result) {
    static_cast<void>(function);
    static_cast<void>(args);
    static_cast<void>(result);
    return false;
  }
  virtual void warn(std::string_view message) = 0;
};

class Unifier {
 public:
  Unifier(Heap& heap, SymbolTable& symbols) : heap_(&heap), symbols_(symbols) {}
  /// Without a heap: set_heap() comes before anything else.
  explicit Unifier(SymbolTable& symbols) : symbols_(symbols) {}
  void set_heap(Heap& heap) { heap_ = &heap; }
  void set_functions(FunctionCaller* functions) { functions_ = functions; }

  /// Unifies `a` with `b`; asymmetric: the annotations of `a` must be among those of `b`, inside
  /// arguments too. If it fails, all its bindings have been undone.
  [[nodiscard]] bool unify(Value a, Value b);
  /// Like unify(), without undoing on failure: for callers that go back to an earlier mark anyway.
  [[nodiscard]] bool unify_no_undo(Value a, Value b);
  /// Each of `a` in order with a distinct one of `b`; tails collect the rest.
  [[nodiscard]] bool unify_annotations(Value a, Value b);

  enum class Direction { template_first, value_first };
  /// Unifies a template, whose slots are in `slots`, with a value, building as little as possible.
  [[nodiscard]] bool match(Value pattern, Value* slots, Value value, Direction direction);

  /// The term with variables and slots replaced by their values and arithmetic evaluated where
  /// possible. Unset slots become fresh variables named by `slot_names`.
  [[nodiscard]] Value instantiate(Value term, Value* slots);
  [[nodiscard]] Value apply(Value term) { return instantiate(term, nullptr); }
  /// While it lives, terms that contain themselves are instantiated, too, instead of throwing
  /// TermTooDeep: callers that walk through the result must end by themselves.
  class KeepCircles {
   public:
    explicit KeepCircles(Unifier& unifier)
        : keeps_(unifier.keeps_circles_), outer_(std::exchange(keeps_, true)) {}
    ~KeepCircles() { keeps_ = outer_; }
    KeepCircles(const KeepCircles&) = delete;
    KeepCircles& operator=(const KeepCircles&) = delete;

   private:
    bool& keeps_;
    bool outer_;
  };
  /// Like instantiate(), but refers to the values of slots and variables instead of replacing
  /// within them; a query passes such terms to a rule. Arithmetic is evaluated.
  [[nodiscard]] Value build(Value term, Value* slots) {
    if (term.is_slot()) {
      const Value value = slots[term.slot_index()];
      if (!value.is_unset()) return deref(value);
    } else if (term.is_closed()) {
      return term;
    }
    return build_term(term, slots);
  }
  [[nodiscard]] Value build_term(Value term, Value* slots);  // the rest of build
  /// A literal for an event: instantiated, its open variables renamed, with these annotations.
  /// Appends each variable with its copy to `renamed` (unless null). Unset if the literal has
  /// arguments that are more than constants, variables, numbers and ground terms: then nothing but
  /// slots has changed.
  [[nodiscard]] Value instantiate_renamed(const Structure& literal, Value* slots, Value annots,
                                          std::vector<std::pair<Value, Value>>* renamed);
  /// Variables bound to slots are replaced by these: data at run time becomes a template. (Applying
  /// would look for the slots' values.)
  [[nodiscard]] Value apply_slots(Value term);
  /// A copy with fresh variables in place of the unbound ones.
  [[nodiscard]] Value fresh_copy(Value term);
  /// Like fresh_copy(), and appends each variable with its copy to `renamed`.
  [[nodiscard]] Value rename(Value term, std::vector<std::pair<Value, Value>>* renamed);
  /// The names of the slots of the frames in use, for variables made by instantiate.
  void set_slot_names(std::span<const Symbol> names) { slot_names_ = names; }
  [[nodiscard]] std::span<const Symbol> slot_names() const { return slot_names_; }

  /// The number that an expression stands for, if all its operands are known.
  [[nodiscard]] bool evaluate(Value term, Value* slots, double& result) {
    Value value = term.is_slot() && !keep_slots_ ? slots[term.slot_index()] : term;
    if (value.is_variable()) value = deref(value);
    if (value.is_number()) {
      result = value.as_number();
      return true;
    }
    return evaluate_term(term, slots, result);
  }

  /// Whether a term is a number, or plain arithmetic on numbers: the usual case, which has no
  /// effect and needs no more than a look. False: it may still be one.
  [[nodiscard]] bool is_number(Value term, const Value* slots, double& result, int depth = 0) {
    if (term.is_slot()) term = deref(slots[term.slot_index()]);
    if (term.is_number()) {
      result = term.as_number();
      return true;
    }
    return term.is_structure() && is_sum(*term.structure(), slots, result, depth);
  }

  void bind(Variable* variable, Value value) {
    variable->value = value;
    trail_.push_back(&variable->value);
  }
  /// Like bind(), for callers that never backtrack past the creation of young variables
  /// (set_young); those bindings need no trail entry.
  void bind_young(Variable* variable, Value value) {
    variable->value = value;
    if (variable->serial < young_) trail_.push_back(&variable->value);
  }
  [[nodiscard]] std::uint32_t young() const { return young_; }
  void set_young(std::uint32_t first_serial) { young_ = first_serial; }
  static constexpr std::uint32_t kNoneYoung = 0xFFFF'FFFFU;
  void set_slot(Value* slot, Value value) {
    *slot = value;
    const auto offset = reinterpret_cast<std::uintptr_t>(slot) - fresh_begin_;
    if (offset < fresh_bytes_) return;
    trail_.push_back(slot);
    ++slots_recorded_;
  }
  /// A slot without a value gets a variable with its name.
  Value make_variable(Value* slots, std::uint32_t index) {
    const Symbol name = index < slot_names_.size() ? slot_names_[index] : names::unnamed;
    const Value made = heap().variable(name);
    set_slot(slots + index, made);
    return made;
  }
  /// A frame that nothing can go back behind without giving it up: what is set in it need not be
  /// undone. Until the next choice point.
  void begin_fresh_frame(std::span<Value> slots) {
    fresh_begin_ = reinterpret_cast<std::uintptr_t>(slots.data());
    fresh_bytes_ = slots.size_bytes();
  }
  void end_fresh_frame() { fresh_bytes_ = 0; }
  /// How many bindings of slots have ever been recorded.
  [[nodiscard]] std::uint32_t slots_recorded() const { return slots_recorded_; }

  [[nodiscard]] std::size_t mark() const { return trail_.size(); }
  void undo(std::size_t mark) {
    while (trail_.size() > mark) *trail_.take_back() = Value();
  }
  /// The bindings since a mark are kept for good.
  void commit(std::size_t mark) { trail_.cut(mark); }
  /// Bindings of these cells since a mark are not undone: the cells are about to go.
  void forget(std::size_t mark, const Value* first, const Value* last);
  /// Forgets the bindings of a frame that is given up: nothing will ask for its slots again.
  void forget(std::size_t mark, std::span<Value> slots) {
    trail_.erase_if(mark, [slots](const Value* cell) {
      return cell >= slots.data() && cell < slots.data() + slots.size();
    });
  }
  [[nodiscard]] std::span<Value* const> bindings_since(std::size_t mark) const {
    return trail_.since(mark);
  }

  /// A variable of no namespace does not take literals of others.
  [[nodiscard]] static bool is_of_other_namespace(Value value) {
    if (!value.is_name()) return false;
    return is_foreign(value.is_atom() ? value.atom_id() : value.structure()->predicate());
  }

  [[nodiscard]] Heap& heap() { return *heap_; }
  [[nodiscard]] SymbolTable& symbols() { return symbols_; }

 private:
  bool is_sum(const Structure& expression, const Value* slots, double& result, int depth);
  void rename_arguments(std::span<Value> args, std::vector<std::pair<Value, Value>>* renamed);
  [[nodiscard]] bool is_open(Value term, const Value* slots) const;
  bool evaluate_term(Value term, Value* slots, double& result);
  bool evaluate_function(const Structure& function, const Value* slots, double& result, int depth);
  Value instantiate_parts(Value term, Value* slots);
  [[gnu::noinline]] Value instantiate_circular(Value term, Value* slots);
  [[nodiscard]] bool is_circular(Value term) const {
    return !circles_.empty() && circles_.contains(term.bits());
  }
  [[nodiscard]] bool unify_deep(Value a, Value b);
  Value instantiate_structure(const Structure& structure, Value* slots);
  Value keep_expression(const Structure& structure, Value* slots);
  Value instantiate_decorated(const Structure& structure, Value* slots);
  Value instantiate_pairs(Value list, Value* slots);
  bool unify_literals(Value a, Value b);
  bool unify_structures(const Structure& a, const Structure& b);
  bool unify_decorated(Value a, Value b);
  bool unify_variable(Value variable, Value value);
  bool unify_bodies(const Structure& a, const Structure& b);
  bool match_structure(Value pattern, Value* slots, Value value, Direction direction);

  Heap* heap_ = nullptr;
  SymbolTable& symbols_;
  FunctionCaller* functions_ = nullptr;
  FlatStack<Value*> trail_;
  std::span<const Symbol> slot_names_;
  std::unordered_set<std::uint64_t> fresh_;  // only while fresh_copy runs
  TermWalk walk_;
  Circles circles_;  // only while a term that has some is instantiated
  using DeepPairs = std::set<std::pair<std::uint64_t, std::uint64_t>>;
  DeepPairs deep_pairs_;  // those that are being unified
  bool keep_slots_ = false;
  bool keeps_circles_ = false;
  std::uintptr_t fresh_begin_ = 0;
  std::size_t fresh_bytes_ = 0;
  std::uint32_t slots_recorded_ = 0;
  std::uint32_t young_ = kNoneYoung;
};

/// Slots for a template that is instantiated aside, without a place in any frame. When they go,
/// also because a limit was hit, the trail forgets them.
class ScratchSlots {
 public:
  ScratchSlots(Unifier& unifier, std::size_t count)
      : unifier_(unifier), mark_(unifier.mark()), slots_(count) {}
  ~ScratchSlots() { unifier_.forget(mark_, slots_.data(), slots_.data() + slots_.size()); }
  ScratchSlots(const ScratchSlots&) = delete;
  ScratchSlots& operator=(const ScratchSlots&) = delete;

  [[nodiscard]] Value* data() { return slots_.data(); }

 private:
  Unifier& unifier_;
  std::size_t mark_;
  std::vector<Value> slots_;
};

/// A literal's (or atom's) parts, for code that treats both alike.
struct LiteralParts {
  Predicate predicate{};
  std::span<const Value> args;
  Value annots = Value::empty_list();
};

/// Whether a dereferenced value is a literal: an atom or a structure of form literal.
[[nodiscard]] inline bool is_literal(Value value) {
  return value.is_atom() || (value.is_structure() && value.structure()->form() == Form::literal);
}
/// REQUIRES: is_literal(value).
[[nodiscard]] inline LiteralParts literal_parts(Value value) {
  if (value.is_atom()) return {.predicate = value.atom_id(), .args = {}};
  const Structure& s = *value.structure();
  return {s.predicate(), s.arg_span(), s.annots()};
}
/// The predicate alone. REQUIRES: is_literal(value).
[[nodiscard]] inline Predicate predicate_of(Value value) {
  return value.is_atom() ? value.atom_id() : value.structure()->predicate();
}
/// The same literal with other annotations.
[[nodiscard]] Value with_annotations(Heap& heap, Value literal, Value annots);
/// Whether the annotations contain some `source(_)`.
[[nodiscard]] bool has_source(Value annots);

}  // namespace jaywalk
