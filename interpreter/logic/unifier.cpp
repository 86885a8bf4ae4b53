#include "interpreter/logic/unifier.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "interpreter/logic/arithmetic.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

// A buffer on the stack for the usual few arguments.
class ArgumentBuffer {
 public:
  explicit ArgumentBuffer(std::size_t size) : size_(size) {
    if (size > small_.size()) large_.resize(size);
  }
  Value& operator[](std::size_t index) { return data()[index]; }
  [[nodiscard]] std::span<Value> span() { return {data(), size_}; }

 private:
  Value* data() { return large_.empty() ? small_.data() : large_.data(); }
  std::size_t size_;
  std::array<Value, 8> small_;
  std::vector<Value> large_;
};

// A list's elements, the first few on the stack.
class ElementBuffer {
 public:
  void push_back(Value value) {
    if (size_ < few_.size()) {
      few_[size_++] = value;
      return;
    }
    if (size_ == few_.size()) many_.assign(few_.begin(), few_.end());
    ++size_;
    many_.push_back(value);
  }
  [[nodiscard]] std::span<const Value> span() const {
    return size_ <= few_.size() ? std::span(few_).first(size_) : std::span<const Value>(many_);
  }

 private:
  std::size_t size_ = 0;
  std::array<Value, 8> few_;
  std::vector<Value> many_;
};

bool is_evaluable(Value value) {
  return is_form(value, Form::expression) || is_form(value, Form::function);
}

}  // namespace

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
  if (mark >= trail_.size()) return;
  const auto is_among_them = [&](const Value* cell) {
    return !std::less<>{}(cell, first) && std::less<>{}(cell, last);
  };
  trail_.erase(std::remove_if(trail_.begin() + static_cast<std::ptrdiff_t>(mark), trail_.end(),
                              is_among_them),
               trail_.end());
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
      return unify_literals(a, b);
    default:
      return false;
  }
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

bool Unifier::unify_annotations(Value a, Value b) {
  a = deref(a);
  b = deref(b);
  if (a.is_empty_list() || a.same_as(b)) return true;
  std::vector<Value> available;
  Value b_tail = b;
  for (; b_tail.is_pair(); b_tail = deref(b_tail.pair()->tail)) {
    available.push_back(b_tail.pair()->head);
  }
  std::vector<Value> missing;
  Value a_tail = a;
  for (; a_tail.is_pair(); a_tail = deref(a_tail.pair()->tail)) {
    const Value wanted = a_tail.pair()->head;
    const auto found = std::find_if(available.begin(), available.end(),
                                    [&](Value annot) { return unify(wanted, annot); });
    if (found != available.end()) {
      available.erase(found);
    } else if (b_tail.is_variable()) {
      missing.push_back(wanted);
    } else {
      return false;
    }
  }
  if (a_tail.is_variable() && !unify_no_undo(a_tail, heap().list(available))) return false;
  if (b_tail.is_variable() && !b_tail.same_as(a_tail)) {
    return unify_no_undo(b_tail, heap().list(missing));
  }
  return true;
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

Value Unifier::instantiate(Value term, Value* slots) {
  if (term.is_closed()) return term;
  if (term.is_slot()) {
    if (keep_slots_) return term;
    Value* const slot = slots + term.slot_index();
    if (slot->is_unset()) {
      const Symbol name =
          term.slot_index() < slot_names_.size() ? slot_names_[term.slot_index()] : names::unnamed;
      set_slot(slot, heap().variable(name));
      return *slot;
    }
    return apply(*slot);
  }
  if (term.is_variable()) {
    term = deref(term);
    return term.is_variable() || term.is_closed() ? term : instantiate(term, slots);
  }
  const TermWalk::Level level(walk_);
  return term.is_pair() ? instantiate_pairs(term, slots)
                        : instantiate_structure(*term.structure(), slots);
}

Value Unifier::build_term(Value term, Value* slots) {
  if (term.is_variable()) return deref(term);
  if (term.is_slot()) return instantiate(term, slots);
  double number = 0;
  if (is_number(term, slots, number)) return Value::number(number);
  if (term.is_pair()) {
    const Value head = build(term.pair()->head, slots);
    return heap().pair(head, build(term.pair()->tail, slots));
  }
  const Structure& s = *term.structure();
  if (s.form() != Form::literal || s.is_annotated()) return instantiate_structure(s, slots);
  ArgumentBuffer args(s.arity);
  for (std::size_t i = 0; i < s.arity; ++i) args[i] = build(s.arg(i), slots);
  return heap().structure(s.predicate(), args.span());
}

// Variables among arguments give way to copies of theirs.
void Unifier::rename_arguments(std::span<Value> args,
                               std::vector<std::pair<Value, Value>>* renamed) {
  ArgumentBuffer copies(args.size());
  for (std::size_t i = 0; i < args.size(); ++i) {
    copies[i] = args[i];
    if (!args[i].is_variable()) continue;
    const auto first = static_cast<std::size_t>(
        std::find_if(args.begin(), args.end(), [&](Value arg) { return arg.same_as(args[i]); }) -
        args.begin());
    copies[i] = first < i ? copies[first] : heap().variable(args[i].variable()->name());
    if (first == i && renamed != nullptr) renamed->emplace_back(args[i], copies[i]);
  }
  std::copy(copies.span().begin(), copies.span().end(), args.begin());
}

Value Unifier::instantiate_renamed(const Structure& literal, Value* slots, Value annots,
                                   std::vector<std::pair<Value, Value>>* renamed) {
  ArgumentBuffer args(literal.arity);
  bool is_open = false;
  for (std::size_t i = 0; i < literal.arity; ++i) {
    Value arg = literal.arg(i);
    double number = 0;
    if (arg.is_slot()) {
      arg = deref(slots[arg.slot_index()].is_unset() ? instantiate(arg, slots)
                                                     : slots[arg.slot_index()]);
    } else if (arg.is_variable()) {
      arg = deref(arg);
    } else if (is_form(arg, Form::expression) && evaluate(arg, slots, number)) {
      arg = Value::number(number);
    }
    if (arg.is_variable()) {
      is_open = true;
    } else if (!arg.is_closed()) {
      return {};
    }
    args[i] = arg;
  }
  if (is_open) rename_arguments(args.span(), renamed);
  return heap().structure(literal.predicate(), args.span(), annots);
}

Value Unifier::apply_slots(Value term) {
  struct KeepSlots {
    explicit KeepSlots(bool& keep) : keep_(keep) { keep_ = true; }
    ~KeepSlots() { keep_ = false; }  // also when a limit ends the walk
    bool& keep_;
  };
  const KeepSlots keep(keep_slots_);
  return apply(term);
}

Value Unifier::fresh_copy(Value term) { return rename(term, nullptr); }

Value Unifier::rename(Value term, std::vector<std::pair<Value, Value>>* renamed) {
  term = apply(term);
  if (term.is_closed()) return term;
  // Each variable is bound to its copy while the term is applied, and set free again afterwards.
  const std::size_t start = mark();
  fresh_.clear();  // a limit may have ended an earlier walk
  std::vector<Value> todo{term};
  while (!todo.empty()) {
    const Value value = deref(todo.back());
    todo.pop_back();
    if (value.is_variable()) {
      if (!fresh_.contains(value.bits())) {
        fresh_.insert(value.bits());
      } else {
        continue;
      }
      const Value copy = heap().variable(value.variable()->name());
      fresh_.insert(copy.bits());
      bind(value.variable(), copy);
      if (renamed != nullptr) renamed->emplace_back(value, copy);
    } else if (value.is_pair() && !value.is_closed()) {
      todo.push_back(value.pair()->tail);
      todo.push_back(value.pair()->head);
    } else if (value.is_structure() && !value.is_closed()) {
      const Structure& s = *value.structure();
      todo.push_back(s.annots());
      for (std::size_t i = s.arity; i > 0; --i) todo.push_back(s.arg(i - 1));
    }
  }
  fresh_.clear();
  const Value copy = apply(term);
  undo(start);
  return copy;
}

Value Unifier::instantiate_pairs(Value list, Value* slots) {
  // A loop, since lists are long: the elements first, then the pairs from the end.
  ElementBuffer elements;
  Value tail = list;
  ListWalk walk;
  while (tail.is_pair() && !tail.is_closed()) {
    walk.visit(tail);
    elements.push_back(instantiate(tail.pair()->head, slots));
    tail = tail.pair()->tail;
    if (tail.is_slot() && !keep_slots_ && !slots[tail.slot_index()].is_unset()) {
      tail = slots[tail.slot_index()];
    }
    tail = deref(tail);
  }
  if (!tail.is_closed()) tail = instantiate(tail, slots);
  return heap().list(elements.span(), tail);
}

Value Unifier::instantiate_structure(const Structure& s, Value* slots) {
  if (s.form() == Form::decorated) return instantiate_decorated(s, slots);
  if (s.form() == Form::expression) {
    double number = 0;
    if (evaluate(Value::reference(Value::Kind::structure, &s, 0), slots, number)) {
      return Value::number(number);
    }
  }
  ArgumentBuffer args(s.arity);
  for (std::size_t i = 0; i < s.arity; ++i) {
    const Value arg = s.arg(i);
    // An expression with an unknown part is kept as a whole: no part of it is evaluated alone.
    const bool kept = s.form() == Form::expression && is_form(arg, Form::expression);
    args[i] = arg.is_closed() ? arg
              : kept          ? keep_expression(*arg.structure(), slots)
                              : instantiate(arg, slots);
  }
  Value annots = s.annots();
  if (!annots.is_closed()) annots = sorted_set(heap(), instantiate(annots, slots), symbols_);
  Value made = heap().structure(s.predicate(), args.span(), annots, s.form());
  if ((s.info & Structure::kBare) != 0) made.structure()->info |= Structure::kBare;
  if (s.form() == Form::function && functions_ != nullptr) {
    Value result;
    if (functions_->call_function(*made.structure(), result)) return result;
  }
  return made;
}

Value Unifier::keep_expression(const Structure& s, Value* slots) {
  const TermWalk::Level level(walk_);
  ArgumentBuffer args(s.arity);
  for (std::size_t i = 0; i < s.arity; ++i) {
    args[i] = is_form(s.arg(i), Form::expression) ? keep_expression(*s.arg(i).structure(), slots)
                                                  : instantiate(s.arg(i), slots);
  }
  return heap().structure(s.predicate(), args.span(), Value::empty_list(), Form::expression);
}

Value Unifier::instantiate_decorated(const Structure& s, Value* slots) {
  Value value = instantiate(s.arg(0), slots);
  Value annots = instantiate(s.annots(), slots);
  const bool negated = symbols_.signature(s.predicate()).negated;
  Value ns = s.arity > 1 ? instantiate(s.arg(1), slots) : Value();
  if (is_literal(value)) {
    const LiteralParts parts = literal_parts(value);
    Signature signature = symbols_.signature(parts.predicate);
    signature.negated = signature.negated != negated;
    if (ns.is_atom()) signature.ns = symbols_.signature(ns.atom_id()).functor;
    if (ns.is_variable() || ns.is_slot()) {
      // The namespace is still to be known: the literal stays as it is, for any of them.
      const std::array<Value, 2> parts_of{value, ns};
      return heap().structure(s.predicate(), parts_of, annots, Form::decorated);
    }
    annots = union_of(heap(), parts.annots, annots, symbols_);
    return heap().structure(symbols_.predicate(signature), parts.args, annots);
  }
  if (is_form(value, Form::decorated)) {
    const Structure& inner = *value.structure();
    annots = union_of(heap(), inner.annots(), annots, symbols_);
    if (ns.is_unset() && inner.arity > 1) ns = inner.arg(1);
    value = inner.arg(0);
  } else if (!value.is_variable() && !value.is_slot()) {
    return value;  // annotations of a number, list or string vanish
  }
  const std::array<Value, 2> args{value, ns};
  return heap().structure(s.predicate(), std::span(args).first(ns.is_unset() ? 1 : 2),
                          sorted_set(heap(), annots, symbols_), Form::decorated);
}

// Sums and products of numbers; deeper terms are left to evaluate().
bool Unifier::is_sum(const Structure& s, const Value* slots, double& result, int depth) {
  constexpr int kDeep = 16;
  if (s.form() != Form::expression || s.arity != 2 || depth > kDeep) return false;
  double operands[2];
  for (std::size_t i = 0; i < 2; ++i) {
    Value operand = s.arg(i);
    if (operand.is_slot()) operand = slots[operand.slot_index()];
    operand = deref(operand);
    if (operand.is_number()) {
      operands[i] = operand.as_number();
    } else if (!operand.is_structure() ||
               !is_sum(*operand.structure(), slots, operands[i], depth + 1)) {
      return false;
    }
  }
  switch (s.predicate()) {
    case predicates::add:
      result = operands[0] + operands[1];
      return true;
    case predicates::subtract:
      result = operands[0] - operands[1];
      return true;
    case predicates::multiply:
      result = operands[0] * operands[1];
      return true;
    default:
      return false;
  }
}

bool Unifier::evaluate_term(Value term, Value* slots, double& result) {
  if (term.is_slot()) {
    if (keep_slots_) return false;
    term = slots[term.slot_index()];
  }
  term = deref(term);
  if (term.is_slot()) return false;
  if (term.is_number()) {
    result = term.as_number();
    return true;
  }
  if (term.is_variable() || term.is_unset() || term.is_slot()) return false;
  if (is_form(term, Form::function) && functions_ != nullptr) {
    const Value value = instantiate(term, slots);
    if (is_form(value, Form::function)) return false;
    return evaluate(value, slots, result);
  }
  if (!is_form(term, Form::expression)) {
    if (is_form(term, Form::decorated)) return false;
    if (functions_ != nullptr) {
      functions_->warn("arithmetic on " + term_text(term, symbols_) + ", which is not a number");
    }
    result = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  const TermWalk::Level level(walk_);
  const Structure& s = *term.structure();
  double a = 0;
  if (!evaluate(s.arg(0), slots, a)) return false;
  if (s.arity == 1) {
    result = -a;
    return true;
  }
  double b = 0;
  if (!evaluate(s.arg(1), slots, b)) return false;
  switch (s.predicate()) {
    case predicates::add:
      result = a + b;
      return true;
    case predicates::subtract:
      result = a - b;
      return true;
    case predicates::multiply:
      result = a * b;
      return true;
    default:
      break;
  }
  const std::optional<double> value = calculate(s.predicate(), a, b);
  if (!value) throw DivisionByZero{};
  result = *value;
  return true;
}

}  // namespace jaywalk
