// SPDX-License-Identifier: Apache-2.0
// Application of unifiers (Jason's `capply`): terms with values in place of variables and slots,
// and their copies with fresh variables.

#include <algorithm>
#include <array>

#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/compare.h"

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

}  // namespace

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
  if (walk_.depth() > 0) return instantiate_parts(term, slots);
  try {
    return instantiate_parts(term, slots);
  } catch (const TermTooDeep&) {
    return instantiate_circular(term, slots);
  }
}

Value Unifier::instantiate_parts(Value term, Value* slots) {
  if (is_circular(term)) return term;
  const TermWalk::Level level(walk_, term);
  return term.is_pair() ? instantiate_pairs(term, slots)
                        : instantiate_structure(*term.structure(), slots);
}

// A term that contains itself stays as it is: it has no copy without its variable.
Value Unifier::instantiate_circular(Value term, Value* slots) {
  struct Forgotten {
    ~Forgotten() { circles.clear(); }
    Circles& circles;
  };
  if (!keeps_circles_ || !circles_.empty()) throw TermTooDeep{};
  const Forgotten forgotten{circles_};
  circles_ = circles_of(term, slots);
  if (circles_.empty()) throw TermTooDeep{};
  return instantiate_parts(term, slots);
}

Value Unifier::build_term(Value term, Value* slots) {
  if (term.is_variable()) return deref(term);
  if (term.is_slot()) return instantiate(term, slots);
  double number = 0;
  if (is_number(term, slots, number)) return Value::number(number);
  if (term.is_pair()) {
    const Value head = build(term.pair()->head, slots);
    Value tail = term.pair()->tail;
    ElementBuffer more;  // a list may be as long as its text: it is not gone down by recursion
    for (; !tail.is_closed() && tail.is_pair(); tail = tail.pair()->tail) {
      more.push_back(build(tail.pair()->head, slots));
    }
    Value made = build(tail, slots);
    const std::span<const Value> elements = more.span();
    for (std::size_t i = elements.size(); i > 0; --i) made = heap().pair(elements[i - 1], made);
    return heap().pair(head, made);
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
  std::size_t steps = 0;
  while (!todo.empty()) {
    const Value value = deref(todo.back());
    todo.pop_back();
    // A term that contains itself comes again and again.
    constexpr std::size_t kUsual = 1000;
    const bool is_known = ++steps > kUsual && !value.is_closed() && !value.is_variable() &&
                          !fresh_.insert(value.bits()).second;
    if (is_known) continue;
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
  while (tail.is_pair() && !tail.is_closed() && !is_circular(tail)) {
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
  const TermWalk::Level level(walk_, Value::reference(Value::Kind::structure, &s, 0));
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
    // Truth and internal actions are of no namespace.
    const bool has_namespace = !signature.dotted && parts.predicate != predicates::truth &&
                               parts.predicate != predicates::falsity;
    if (ns.is_atom() && has_namespace) signature.ns = symbols_.signature(ns.atom_id()).functor;
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

}  // namespace jaywalk
