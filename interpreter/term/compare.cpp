// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/compare.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/term/program_terms.h"
#include "interpreter/term/walk.h"

namespace jaywalk {
namespace {

int sign(std::strong_ordering order) { return order < 0 ? -1 : order > 0 ? 1 : 0; }

// An atom and a structure without arguments are the same kind of thing.
struct LiteralView {
  Predicate predicate{};
  std::span<const Value> args;
  Value annots = Value::empty_list();
  Form form = Form::literal;
};

LiteralView view_of(Value value) {
  if (value.is_atom()) return {.predicate = value.atom_id(), .args = {}};
  const Structure& s = *value.structure();
  return {s.predicate(), s.arg_span(), s.annots(), s.form()};
}

std::vector<Value> contents(Object& object) {
  std::vector<Value> all;
  object.visit([&](Value& value) { all.push_back(value); });
  return all;
}

class Equality {
 public:
  explicit Equality(Annotations annotations) : annotations_(annotations) {}

  bool equal(Value a, Value b) {
    const TermWalk::Level level(walk_);
    ListWalk list;
    // Lists are walked in a loop: they may be long.
    for (;;) {
      a = deref(a);
      b = deref(b);
      if (a.same_as(b)) return true;
      if (!a.is_pair() || !b.is_pair()) break;
      list.visit(a);
      if (!equal(a.pair()->head, b.pair()->head)) return false;
      a = a.pair()->tail;
      b = b.pair()->tail;
    }
    if (a.is_number() && b.is_number()) return a.as_number() == b.as_number();
    if (a.is_text() && b.is_text()) return a.text()->view() == b.text()->view();
    if ((a.is_structure() || a.is_atom()) && (b.is_structure() || b.is_atom())) {
      // An atom is a literal without arguments: `a` equals `a[]`.
      return equal_literals(view_of(a), view_of(b));
    }
    return a.is_object() && b.is_object() &&
           equal_objects(*a.object()->object, *b.object()->object);
  }

 private:
  bool equal_literals(const LiteralView& a, const LiteralView& b) {
    if (a.predicate != b.predicate || a.form != b.form || a.args.size() != b.args.size()) {
      return false;
    }
    const std::size_t count = a.form == Form::step ? 1 : a.args.size();  // the line does not count
    for (std::size_t i = 0; i < count; ++i) {
      if (!equal(a.args[i], b.args[i])) return false;
    }
    // Annotations of arguments always count; those of the literal itself if asked.
    if (walk_.depth() == 1 && annotations_ == Annotations::ignore) return true;
    return equal(a.annots, b.annots);
  }

  // Sets and maps are equal if their contents are, as in Java; a queue equals itself alone.
  bool equal_objects(Object& a, Object& b) {
    if (&a == &b) return true;
    if (a.kind() != b.kind() || a.size() != b.size() || a.kind() == Object::Kind::queue) {
      return false;
    }
    const std::vector<Value> left = contents(a);
    const std::vector<Value> right = contents(b);
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (!equal(left[i], right[i])) return false;
    }
    return true;
  }

  Annotations annotations_;
  TermWalk walk_;
};

class Order {
 public:
  explicit Order(const SymbolTable& symbols) : symbols_(symbols) {}

  int compare(Value a, Value b) {
    const TermWalk::Level level(walk_);
    ListWalk list;
    for (;;) {
      a = deref(a);
      b = deref(b);
      if (a.same_as(b)) return 0;
      if (!a.is_pair() || !b.is_pair()) break;
      list.visit(a);
      if (const int order = compare(a.pair()->head, b.pair()->head); order != 0) return order;
      a = a.pair()->tail;
      b = b.pair()->tail;
    }
    const int rank_a = rank(a);
    const int rank_b = rank(b);
    if (rank_a != rank_b) return rank_a < rank_b ? -1 : 1;
    switch (rank_a) {
      case 0:
        return numbers(a.as_number(), b.as_number());
      case 1:
        return sign(a.text()->view() <=> b.text()->view());
      case 2:
        return a.is_empty_list() ? -1 : 1;  // one of them has ended
      case 3:
        if (is_program(a) || is_program(b)) return programs(a, b);
        return literals(view_of(a), view_of(b));
      case 4:
        return objects(*a.object()->object, *b.object()->object);
      default:
        return variables(*a.variable(), *b.variable());
    }
  }

 private:
  static int rank(Value value) {
    switch (value.kind()) {
      case Value::Kind::number:
        return 0;
      case Value::Kind::text:
        return 1;
      case Value::Kind::pair:
        return 2;
      case Value::Kind::special:
        return 2;
      case Value::Kind::atom:
        return 3;
      case Value::Kind::structure:
        return 3;
      case Value::Kind::object:
        return 4;
      case Value::Kind::variable:
        return 5;
    }
    return 5;
  }

  // As Double.compare: NaN is above everything and equals itself.
  static int numbers(double a, double b) {
    if (a < b) return -1;
    if (a > b) return 1;
    if (a == b) return 0;
    const bool nan_a = a != a;
    const bool nan_b = b != b;
    return nan_a == nan_b ? 0 : nan_a ? 1 : -1;
  }

  int literals(const LiteralView& a, const LiteralView& b) {
    const Signature& sa = symbols_.signature(a.predicate);
    const Signature& sb = symbols_.signature(b.predicate);
    if (sa.ns != sb.ns) return sign(symbols_.text(sa.ns) <=> symbols_.text(sb.ns));
    if (sa.functor != sb.functor) {
      return sign(symbols_.text(sa.functor) <=> symbols_.text(sb.functor));
    }
    if (sa.negated != sb.negated) return sa.negated ? 1 : -1;
    for (std::size_t i = 0; i < std::min(a.args.size(), b.args.size()); ++i) {
      if (const int order = compare(a.args[i], b.args[i]); order != 0) return order;
    }
    if (a.args.size() != b.args.size()) return a.args.size() < b.args.size() ? -1 : 1;
    return compare(a.annots, b.annots);
  }

  // Compares terms of which one is a program as data, which is ordered as a structure
  // (program_terms.h): a rule like its head, others behind the literals of their functor.
  int programs(Value a, Value b) {
    const bool rule_a = is_form(a, Form::rule);
    const bool rule_b = is_form(b, Form::rule);
    if (rule_a || rule_b) {
      const int order =
          compare(rule_a ? a.structure()->arg(0) : a, rule_b ? b.structure()->arg(0) : b);
      if (order != 0 || rule_a != rule_b) return order != 0 ? order : rule_a ? 1 : -1;
      return compare(a.structure()->arg(1), b.structure()->arg(1));
    }
    const std::string_view left = functor_of(a);
    const std::string_view right = functor_of(b);
    if (left != right) return sign(left <=> right);
    if (is_program(a) != is_program(b)) {
      const bool is_none = left == "none" && (a.is_atom() || b.is_atom());
      return is_none ? 0 : is_program(a) ? 1 : -1;
    }
    return is_form(a, Form::body) ? bodies(*a.structure(), *b.structure())
                                  : literals(view_of(a), view_of(b));
  }

  [[nodiscard]] std::string_view functor_of(Value value) const {
    return is_program(value) ? program_functor(*value.structure(), symbols_)
                             : symbols_.functor(view_of(value).predicate);
  }

  // Compares formula by formula: first the kind, then the term; the shorter body comes first.
  int bodies(const Structure& a, const Structure& b) {
    for (std::size_t i = 0; i < a.arity && i < b.arity; ++i) {
      const std::string_view left = formula_functor(a.arg(i), symbols_);
      const std::string_view right = formula_functor(b.arg(i), symbols_);
      if (left != right) return sign(left <=> right);
      const int order = compare(without_operator(a.arg(i)), without_operator(b.arg(i)));
      if (order != 0) return order;
    }
    return a.arity == b.arity ? 0 : a.arity < b.arity ? -1 : 1;
  }

  // Sets before maps before queues; the smaller first; then by their contents; queues by age.
  int objects(Object& a, Object& b) {
    if (&a == &b) return 0;
    if (a.kind() != b.kind()) return a.kind() < b.kind() ? -1 : 1;
    if (a.kind() == Object::Kind::queue) return a.serial < b.serial ? -1 : 1;
    if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
    const std::vector<Value> left = contents(a);
    const std::vector<Value> right = contents(b);
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (const int order = compare(left[i], right[i]); order != 0) return order;
    }
    return 0;
  }

  int variables(const Variable& a, const Variable& b) {
    const bool named_a = a.name() != names::unnamed;
    const bool named_b = b.name() != names::unnamed;
    if (named_a != named_b) return named_a ? -1 : 1;
    if (named_a && a.name() != b.name()) {
      return sign(symbols_.text(a.name()) <=> symbols_.text(b.name()));
    }
    return a.serial < b.serial ? -1 : a.serial > b.serial ? 1 : 0;
  }

  const SymbolTable& symbols_;
  TermWalk walk_;
};

constexpr std::uint64_t mixed_in(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
  return hash ^ hash >> 32U;
}

class Hash {
 public:
  std::uint64_t hash(Value value) {
    const TermWalk::Level level(walk_);
    ListWalk list;
    std::uint64_t result = 0x51ED270B;
    for (;;) {
      value = deref(value);
      if (!value.is_pair()) break;
      list.visit(value);
      const std::uint64_t head = hash(value.pair()->head);
      if (head == 0) return 0;
      result = mixed_in(result, head);
      value = value.pair()->tail;
    }
    const std::uint64_t last = single(value);
    // 0 stands for a term without a hash (it has a variable, say); other hashes have the lowest bit
    // set.
    return last == 0 ? 0 : mixed_in(result, last) | 1U;
  }

 private:
  std::uint64_t single(Value value) {
    switch (value.kind()) {
      case Value::Kind::number:
        // -0 equals 0, and so has its hash.
        return mixed_in(1, std::bit_cast<std::uint64_t>(value.as_number() + 0.0));
      case Value::Kind::atom:
        return mixed_in(2, static_cast<std::uint64_t>(value.atom_id())) | 1U;
      case Value::Kind::special:
        return mixed_in(3, value.bits());
      case Value::Kind::text:
        return mixed_in(4, std::hash<std::string_view>{}(value.text()->view())) | 1;
      case Value::Kind::object:
        return 5;  // its contents change
      case Value::Kind::structure:
        break;
      default:
        return 0;
    }
    const Structure& s = *value.structure();
    if (s.form() == Form::decorated) return 0;
    // Annotations are left out: terms that differ in them alone may be equal (Annotations::ignore).
    std::uint64_t result = mixed_in(2, static_cast<std::uint64_t>(s.predicate()));
    for (std::size_t i = 0; i < s.arity; ++i) {
      const std::uint64_t part = hash(s.arg(i));
      if (part == 0) return 0;
      result = mixed_in(result, part);
    }
    return result | 1U;
  }

  TermWalk walk_;
};

bool ground(Value value, TermWalk& walk) {
  const TermWalk::Level level(walk);
  ListWalk list;
  for (;;) {
    value = deref(value);
    if (!value.is_pair()) break;
    // A closed pair has no variables below it: the flag saves the walk.
    if (value.is_closed()) return true;
    list.visit(value);
    if (!ground(value.pair()->head, walk)) return false;
    value = value.pair()->tail;
  }
  if (value.is_variable() || value.is_slot() || value.is_unset()) return false;
  if (!value.is_structure() || value.is_closed()) return true;
  const Structure& s = *value.structure();
  for (std::size_t i = 0; i < s.arity; ++i) {
    if (!ground(s.arg(i), walk)) return false;
  }
  return ground(s.annots(), walk);
}

}  // namespace

bool equal_terms(Value a, Value b, Annotations annotations) {
  return Equality(annotations).equal(a, b);
}

int compare_terms(Value a, Value b, const SymbolTable& symbols) {
  return Order(symbols).compare(a, b);
}

std::uint64_t hash_term(Value term) { return Hash().hash(term); }

bool is_ground(Value term) {
  TermWalk walk;
  return ground(term, walk);
}

namespace {

// Few elements, mostly in order already: each goes where it belongs among those before it, unless
// an equal one is there.
void sort_few(std::vector<Value>& elements, const SymbolTable& symbols) {
  std::size_t sorted = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Value element = elements[i];
    std::size_t place = sorted;
    int order = -1;
    while (place > 0 && (order = compare_terms(elements[place - 1], element, symbols)) > 0) --place;
    if (place > 0 && order == 0) continue;
    std::copy_backward(elements.begin() + static_cast<std::ptrdiff_t>(place),
                       elements.begin() + static_cast<std::ptrdiff_t>(sorted),
                       elements.begin() + static_cast<std::ptrdiff_t>(sorted) + 1);
    elements[place] = element;
    ++sorted;
  }
  elements.resize(sorted);
}

// Of equal elements the first one stays, as in the other sort.
void sort_many(std::vector<Value>& elements, const SymbolTable& symbols) {
  std::stable_sort(elements.begin(), elements.end(),
                   [&](Value a, Value b) { return compare_terms(a, b, symbols) < 0; });
  const auto last = std::unique(elements.begin(), elements.end(), [&](Value a, Value b) {
    return compare_terms(a, b, symbols) == 0;
  });
  elements.erase(last, elements.end());
}

constexpr std::size_t kFew = 12;

// Whether a list is a sorted set of few elements as it stands, as most annotations are.
bool is_small_set(Value list, const SymbolTable& symbols) {
  if (!list.is_closed()) return false;
  Value before;
  for (std::size_t count = 0; list.is_pair(); list = list.pair()->tail, ++count) {
    const Value element = list.pair()->head;
    if (count == kFew) return false;
    if (count > 0 && compare_terms(before, element, symbols) >= 0) return false;
    before = element;
  }
  return list.is_empty_list();
}

// A small set with one more element, unless it has an equal one.
Value set_with(Heap& heap, Value set, Value element, const SymbolTable& symbols) {
  if (!set.is_pair()) return heap.pair(element, set);
  const int order = compare_terms(set.pair()->head, element, symbols);
  if (order == 0) return set;
  if (order > 0) return heap.pair(element, set);
  return heap.pair(set.pair()->head, set_with(heap, set.pair()->tail, element, symbols));
}

}  // namespace

Value append_elements(std::vector<Value>& elements, Value list) {
  list = deref(list);
  for (; list.is_pair(); list = deref(list.pair()->tail)) {
    elements.push_back(deref(list.pair()->head));
  }
  return list;
}

Value sorted_set(Heap& heap, std::vector<Value> elements, Value tail, const SymbolTable& symbols) {
  if (elements.size() <= kFew) {
    sort_few(elements, symbols);
  } else {
    sort_many(elements, symbols);
  }
  return heap.list(elements, tail);
}

Value sorted_set(Heap& heap, Value list, const SymbolTable& symbols) {
  list = deref(list);
  if (is_small_set(list, symbols)) return list;
  std::vector<Value> elements;
  const Value tail = append_elements(elements, list);
  return sorted_set(heap, std::move(elements), tail, symbols);
}

Value union_of(Heap& heap, Value a, Value b, const SymbolTable& symbols) {
  a = deref(a);
  b = deref(b);
  if (a.same_as(b) || (!b.is_pair() && !b.is_variable())) return a;
  if (!a.is_pair() && !a.is_variable()) return b;
  const bool is_one = b.is_closed() && b.pair()->tail.is_empty_list();
  if (is_one && is_small_set(a, symbols)) return set_with(heap, a, b.pair()->head, symbols);
  std::vector<Value> elements;
  const Value end = append_elements(elements, a);
  const Value other_end = append_elements(elements, b);
  return sorted_set(heap, std::move(elements), other_end.is_variable() ? other_end : end, symbols);
}

}  // namespace jaywalk
