// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/transfer.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace jaywalk {
namespace {

// All parts of the literal are the same in any heap.
bool is_flat(const Structure& literal) {
  const Value* const cells = literal.cells();
  const std::size_t count = literal.arity + (literal.is_annotated() ? 1U : 0U);
  return std::all_of(cells, cells + count, [](Value part) {
    return part.is_number() || part.is_atom() || part.is_empty_list() ||
           (part.is_static() && part.is_closed());
  });
}

}  // namespace

Value transfer(Value term, Heap& to) {
  if (is_form(term, Form::literal) && !term.is_static() && is_flat(*term.structure())) {
    const Structure& literal = *term.structure();
    return to.structure(literal.predicate(), literal.arg_span(), literal.annots());
  }
  return Transfer(to).copy(term);
}

Value Transfer::copy(Value term) {
  term = deref(term);
  if (term.is_static() && term.is_closed() && !term.is_number()) return term;
  switch (term.kind()) {
    case Value::Kind::number:
    case Value::Kind::atom:
    case Value::Kind::special:
      return term;
    case Value::Kind::text:
      return to_.text(term.text()->view());
    case Value::Kind::variable: {
      const auto [entry, is_new] = variables_.try_emplace(term.bits());
      if (is_new) entry->second = to_.variable(term.variable()->name());
      return entry->second;
    }
    case Value::Kind::object:
    case Value::Kind::pair:
    case Value::Kind::structure:
      break;
  }
  if (depth_ >= kMaxTermDepth) throw TermTooDeep{};
  ++depth_;
  const Value made = term.is_object() ? object(*term.object()->object)
                     : term.is_pair() ? list(term)
                                      : structure(*term.structure());
  --depth_;
  return made;
}

// A collection is copied, too: agents share nothing.
Value Transfer::object(const Object& from) {
  std::unique_ptr<Object> copied = from.copy();
  copied->visit([this](Value& value) { value = copy(value); });
  return to_.object(std::move(copied));
}

Value Transfer::list(Value term) {
  std::vector<Value> elements;
  for (; term.is_pair(); term = deref(term.pair()->tail)) {
    elements.push_back(copy(term.pair()->head));
  }
  return to_.list(elements, copy(term));
}

Value Transfer::structure(const Structure& structure) {
  std::array<Value, 8> few;
  std::vector<Value> many(structure.arity > few.size() ? structure.arity : 0);
  const std::span<Value> args = many.empty() ? std::span(few).first(structure.arity) : many;
  for (std::size_t i = 0; i < args.size(); ++i) args[i] = copy(structure.arg(i));
  const Value made =
      to_.structure(structure.predicate(), args, copy(structure.annots()), structure.form());
  if (made.is_structure()) made.structure()->info |= structure.info & Structure::kBare;
  return made;
}

}  // namespace jaywalk
