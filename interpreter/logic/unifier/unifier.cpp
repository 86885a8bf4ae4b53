// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/unifier/unifier.h"

#include <algorithm>
#include <functional>

#include "interpreter/term/compare.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
Value with_annotations(Heap& heap, Value literal, Value annots) {
  if (literal.is_atom()) {
    return annots.is_empty_list() ? literal : heap.structure(literal.atom_id(), {}, annots);
  }
  const Structure& s = *literal.structure();
  if (s.annots().same_as(annots)) return literal;
  return heap.structure(s.predicate(), s.arg_span(), annots, s.form());
}

bool has_source(Value annots) {
  if (annots.same_as(source_self())) return true;
  for (annots = deref(annots); annots.is_pair(); annots = deref(annots.pair()->tail)) {
    const Value annot = deref(annots.pair()->head);
    if (annot.is_structure() && annot.structure()->predicate() == predicates::source) return true;
  }
  return false;
}

void Unifier::forget(std::size_t mark, const Value* first, const Value* last) {
  trail_.erase_if(mark, [&](const Value* cell) {
    return !std::less<>{}(cell, first) && std::less<>{}(cell, last);
  });
}

bool Unifier::unify(Value a, Value b) {
  const std::size_t start = mark();
  if (unify_no_undo(a, b)) return true;
  undo(start);
  return false;
}

bool Unifier::unify_no_undo(Value a, Value b) {
  const TermWalk::Level level(walk_);
  ListWalk list;
  for (;;) {
    a = deref(a);
    b = deref(b);
    if (a.same_as(b)) return true;
    if (!a.is_pair() || !b.is_pair()) break;
    list.visit(a);
    if (!unify_no_undo(a.pair()->head, b.pair()->head)) return false;
    a = a.pair()->tail;
    b = b.pair()->tail;
  }
  if (is_evaluable(a)) {
    a = apply(a);
    if (!is_evaluable(a)) return unify_no_undo(a, b);
  }
  if (is_evaluable(b)) {
    b = apply(b);
    if (!is_evaluable(b)) return unify_no_undo(a, b);
  }
  if (a.is_variable()) return unify_variable(a, b);
  if (b.is_variable()) return unify_variable(b, a);
  if (is_form(a, Form::decorated) || is_form(b, Form::decorated)) return unify_decorated(a, b);
  switch (a.kind()) {
    case Value::Kind::number:
      return b.is_number() && a.as_number() == b.as_number();
    case Value::Kind::text:
      return b.is_text() && a.text()->view() == b.text()->view();
    case Value::Kind::object:
      return equal_terms(a, b);
    case Value::Kind::atom:
    case Value::Kind::structure:
      return walk_.depth() <= TermWalk::kShallow ? unify_literals(a, b) : unify_deep(a, b);
    default:
      return false;
  }
}

// Two terms that contain themselves unify unless a difference is found: a pair that is being
// unified already has none.
bool Unifier::unify_deep(Value a, Value b) {
  struct Begun {
    ~Begun() { pairs.erase(place); }
    DeepPairs& pairs;
    DeepPairs::iterator place;
  };
  const auto [place, is_new] = deep_pairs_.emplace(a.bits(), b.bits());
  if (!is_new) return true;
  const Begun begun{deep_pairs_, place};
  return unify_literals(a, b);
}

bool Unifier::unify_variable(Value variable, Value value) {
  if (value.is_variable()) {
    // Jason: the smaller points to the other. An unnamed one always gives way, so names survive.
    Variable* const a = variable.variable();
    Variable* const b = value.variable();
    const bool a_points = compare_terms(variable, value, symbols_) < 0;
    a_points ? bind(a, value) : bind(b, variable);
    return true;
  }
  if (is_of_other_namespace(value)) return false;
  bind(variable.variable(), value);
  return true;
}

bool Unifier::unify_literals(Value a, Value b) {
  if (is_program(a) != is_program(b)) {
    if (is_program(a)) return unify_no_undo(program_structure(heap(), symbols_, a), b);
    return unify_no_undo(a, program_structure(heap(), symbols_, b));
  }
  if (a.is_atom()) {
    if (b.is_atom()) return false;  // equal ones were found to be the same
    return b.is_structure() && b.structure()->arity == 0 && is_literal(b) &&
           b.structure()->predicate() == a.atom_id();
  }
  if (b.is_atom()) {
    const Structure& s = *a.structure();
    return s.arity == 0 && is_literal(a) && s.predicate() == b.atom_id() &&
           unify_annotations(s.annots(), Value::empty_list());
  }
  return b.is_structure() && unify_structures(*a.structure(), *b.structure());
}

bool Unifier::unify_structures(const Structure& a, const Structure& b) {
  if (a.form() == Form::body && b.form() == Form::body) return unify_bodies(a, b);
  if (a.predicate_id != b.predicate_id || a.arity != b.arity || a.form() != b.form()) return false;
  // A step's line and a plan's missing parts do not count.
  const std::size_t count = a.form() == Form::step ? 1 : a.arity;
  for (std::size_t i = 0; i < count; ++i) {
    Value x = a.arg(i);
    Value y = b.arg(i);
    if (x.is_unset() && y.is_unset()) continue;
    // Seen from outside a plan without context has the context `true`.
    constexpr std::size_t kContext = 2;
    if (a.form() == Form::plan && i == kContext) {
      if (x.is_unset()) x = Value::atom(predicates::truth);
      if (y.is_unset()) y = Value::atom(predicates::truth);
    }
    if (!unify_no_undo(x, y)) return false;
  }
  if (!a.is_annotated()) return true;
  return unify_annotations(a.annots(), b.annots());
}

// Formula by formula. A variable without operator stands for any formula, with its operator: a body
// of that one formula; as the last of its body, for all that is left.
bool Unifier::unify_bodies(const Structure& a, const Structure& b) {
  const auto plain_variable = [this](const Structure& body, std::size_t index) {
    const Value step = index < body.arity ? deref(body.arg(index)) : Value();
    if (!is_form(step, Form::step)) return Value();
    const bool plain = symbols_.signature(step.structure()->predicate()).functor == names::empty;
    const Value term = deref(step.structure()->arg(0));
    // Or the body that the variable is bound to.
    return plain && (term.is_variable() || is_form(term, Form::body)) ? term : Value();
  };
  const auto part = [this](const Structure& body, std::size_t from, std::size_t count) {
    const Predicate predicate = symbols_.predicate(
        Signature{.functor = names::body_text, .arity = static_cast<std::uint16_t>(count)});
    return heap().structure(predicate, body.arg_span().subspan(from, count), Value::empty_list(),
                            Form::body);
  };
  // The rest prints as the body that it is of, a single formula without braces.
  const auto unify_part = [&](Value variable, const Structure& body, std::size_t from, bool last) {
    const std::size_t left = body.arity - std::min<std::size_t>(from, body.arity);
    const Value made = part(body, std::min<std::size_t>(from, body.arity), last ? left : 1);
    made.structure()->info |= last ? body.info & Structure::kBare : Structure::kBare;
    return unify_no_undo(variable, made);
  };
  if ((a.arity == 0) != (b.arity == 0)) return false;
  for (std::size_t i = 0;; ++i) {
    const Value x = plain_variable(a, i);
    const Value y = plain_variable(b, i);
    if (!x.is_unset() && !y.is_unset()) {
      if (!unify_no_undo(x, y)) return false;
    } else if (!x.is_unset()) {
      const bool last = i + 1 == a.arity;
      if (!last && i >= b.arity) return false;
      if (!unify_part(x, b, i, last)) return false;
      if (last) return true;
    } else if (!y.is_unset()) {
      const bool last = i + 1 == b.arity;
      if (!last && i >= a.arity) return false;
      if (!unify_part(y, a, i, last)) return false;
      if (last) return true;
    } else {
      if (i >= a.arity || i >= b.arity) return a.arity == b.arity;
      if (!unify_no_undo(a.arg(i), b.arg(i))) return false;
    }
  }
}

// X[a], ~X: the annotations first, then the variable takes the literal without them.
bool Unifier::unify_decorated(Value a, Value b) {
  const bool a_is_variable = is_form(a, Form::decorated);
  const Value pattern = apply(a_is_variable ? a : b);
  const Value other = apply(a_is_variable ? b : a);
  if (!is_form(pattern, Form::decorated))
    return unify_no_undo(a_is_variable ? pattern : other, a_is_variable ? other : pattern);
  if (other.is_variable()) {
    bind(other.variable(), pattern);
    return true;
  }
  const Structure& p = *pattern.structure();
  const bool negated = symbols_.signature(p.predicate()).negated;
  if (is_form(other, Form::decorated)) {
    const Structure& o = *other.structure();
    if (p.predicate_id != o.predicate_id) return false;
    if (!(a_is_variable ? unify_annotations(p.annots(), o.annots())
                        : unify_annotations(o.annots(), p.annots()))) {
      return false;
    }
    return unify_no_undo(p.arg(0), o.arg(0));
  }
  if (!is_literal(other)) return !negated && !p.is_annotated() && unify_no_undo(p.arg(0), other);
  LiteralParts parts = literal_parts(other);
  if (!(a_is_variable ? unify_annotations(p.annots(), parts.annots)
                      : unify_annotations(parts.annots, p.annots()))) {
    return false;
  }
  Signature signature = symbols_.signature(parts.predicate);
  if (p.arity > 1) {  // N::X
    const Value ns = Value::atom(symbols_.predicate(Signature{.functor = signature.ns}));
    if (!unify_no_undo(p.arg(1), ns)) return false;
    signature.ns = names::default_ns;
  }
  if (negated) {
    if (!signature.negated) return false;
    signature.negated = false;
  }
  const Predicate bare = symbols_.predicate(signature);
  const bool keep_annots = !p.is_annotated();
  return unify_no_undo(
      p.arg(0),
      heap().structure(bare, parts.args, keep_annots ? parts.annots : Value::empty_list()));
}

namespace {

// The annotations of the second set while those of the first are looked for in their order, as
// Jason does it: each from where the one before was found, the first variable from the start again.
class AnnotationSearch {
 public:
  AnnotationSearch(Unifier& unifier, const SymbolTable& symbols)
      : unifier_(unifier), symbols_(symbols) {}

  // Both return the tail.
  Value want(Value set);
  Value offer(Value set);

  [[nodiscard]] const std::vector<Value>& wanted() const { return wanted_; }
  [[nodiscard]] const std::vector<Value>& left() const { return offered_; }
  bool take(Value annot);

 private:
  static constexpr std::size_t kNone = SIZE_MAX;

  bool take_variable(Value annot);

  Unifier& unifier_;
  const SymbolTable& symbols_;
  std::vector<Value> wanted_;
  std::vector<Value> offered_;
  std::vector<Value> variables_;
  std::size_t next_variable_ = 0;
  std::size_t current_ = kNone;
  std::size_t next_ = 0;
  bool restarted_ = false;
};

Value AnnotationSearch::want(Value set) {
  const bool is_sorted = set.is_closed();
  for (; set.is_pair(); set = deref(set.pair()->tail)) {
    const Value annot = deref(set.pair()->head);
    wanted_.push_back(is_sorted ? annot : unifier_.apply(annot));
  }
  if (!is_sorted) {
    std::stable_sort(wanted_.begin(), wanted_.end(),
                     [&](Value x, Value y) { return compare_terms(x, y, symbols_) < 0; });
  }
  return set;
}

Value AnnotationSearch::offer(Value set) {
  for (; set.is_pair(); set = deref(set.pair()->tail)) {
    offered_.push_back(deref(set.pair()->head));
    if (offered_.back().is_variable()) variables_.push_back(offered_.back());
  }
  return set;
}

bool AnnotationSearch::take(Value annot) {
  if (annot.is_variable() && !restarted_) {
    restarted_ = true;
    current_ = kNone;
    next_ = 0;
  }
  for (;;) {
    if (current_ != kNone) {
      if (unifier_.unify(annot, offered_[current_])) {
        offered_.erase(offered_.begin() + static_cast<std::ptrdiff_t>(current_));
        next_ = current_;
        current_ = next_ < offered_.size() ? next_++ : kNone;
        return true;
      }
      if (compare_terms(offered_[current_], annot, symbols_) > 0) return take_variable(annot);
    }
    if (next_ >= offered_.size()) return false;
    current_ = next_++;
  }
}

bool AnnotationSearch::take_variable(Value annot) {
  return next_variable_ < variables_.size() && unifier_.unify(annot, variables_[next_variable_++]);
}

// Unifies annotations that are sets without variables.
bool unify_closed_annotations(Unifier& unifier, Value a, Value b) {
  for (; a.is_pair(); a = a.pair()->tail) {
    const Value annot = a.pair()->head;
    for (;; b = b.pair()->tail) {
      if (!b.is_pair()) return false;
      if (unifier.unify(annot, b.pair()->head)) break;
      if (compare_terms(b.pair()->head, annot, unifier.symbols()) > 0) return false;
    }
    b = b.pair()->tail;
  }
  return true;
}

}  // namespace

bool Unifier::unify_annotations(Value a, Value b) {
  a = deref(a);
  b = deref(b);
  if (a.is_empty_list() || a.same_as(b)) return true;
  if (a.is_closed() && b.is_closed()) return unify_closed_annotations(*this, a, b);
  AnnotationSearch search(*this, symbols_);
  const Value a_tail = search.want(a);
  const Value b_tail = search.offer(b);
  std::vector<Value> missing;
  for (const Value annot : search.wanted()) {
    if (search.take(annot)) continue;
    if (!b_tail.is_variable()) return false;
    missing.push_back(annot);
  }
  if (!missing.empty() && !unify_no_undo(b_tail, heap().list(missing))) return false;
  return !a_tail.is_variable() || b_tail.same_as(a_tail) ||
         unify_no_undo(a_tail, heap().list(search.left(), deref(b_tail)));
}

// Neither this nor build_term counts levels: templates are nested as deep as their text at most.
bool Unifier::match(Value pattern, Value* slots, Value value, Direction direction) {
  for (;;) {
    if (pattern.is_slot()) {
      Value* const slot = slots + pattern.slot_index();
      value = deref(value);
      if (slot->is_unset()) {
        if (is_of_other_namespace(value)) return false;
        set_slot(slot, value);
        return true;
      }
      return direction == Direction::template_first ? unify_no_undo(*slot, value)
                                                    : unify_no_undo(value, *slot);
    }
    value = deref(value);
    if (!pattern.is_pair() || !value.is_pair()) break;
    if (!match(pattern.pair()->head, slots, value.pair()->head, direction)) return false;
    pattern = pattern.pair()->tail;
    value = value.pair()->tail;
  }
  if (pattern.same_as(value)) return true;
  if (pattern.is_atom() && value.is_atom()) return false;
  if (pattern.is_number() && value.is_number()) return pattern.as_number() == value.as_number();
  if (value.is_variable() && (pattern.is_pair() || is_form(pattern, Form::literal))) {
    const Value made = build(pattern, slots);
    if (is_of_other_namespace(made)) return false;
    bind(value.variable(), made);
    return true;
  }
  return match_structure(pattern, slots, value, direction);
}

bool Unifier::match_structure(Value pattern, Value* slots, Value value, Direction direction) {
  if (is_form(pattern, Form::literal) && is_form(value, Form::literal)) {
    const Structure& p = *pattern.structure();
    const Structure& v = *value.structure();
    if (p.predicate_id != v.predicate_id) return false;
    // The annotations of the first must be among those of the second.
    const bool annotated =
        direction == Direction::template_first ? p.is_annotated() : v.is_annotated();
    if (!annotated) {
      for (std::size_t i = 0; i < p.arity; ++i) {
        if (!match(p.arg(i), slots, v.arg(i), direction)) return false;
      }
      return true;
    }
  }
  const Value made = pattern.is_closed() ? pattern : instantiate(pattern, slots);
  return direction == Direction::template_first ? unify_no_undo(made, value)
                                                : unify_no_undo(value, made);
}

}  // namespace jaywalk
