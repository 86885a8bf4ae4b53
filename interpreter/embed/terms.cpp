// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"

namespace jaywalk {
namespace {

// The elements of a list as far as it goes, each dereferenced.
std::vector<Value> dereferenced_elements(Value list) {
  std::vector<Value> elements;
  for (Value rest = deref(list); rest.is_pair(); rest = deref(rest.pair()->tail)) {
    elements.push_back(deref(rest.pair()->head));
  }
  return elements;
}

}  // namespace

Predicate predicate_named(SymbolTable& symbols, std::string_view functor, std::size_t arity) {
  return symbols.predicate(functor, static_cast<std::uint16_t>(arity));
}

Value Terms::value(Value term) const { return deref(term); }
bool Terms::is_literal(Value term) const { return jaywalk::is_literal(deref(term)); }

std::string_view Terms::functor(Value term) const {
  return is_literal(term) ? symbols_->functor(predicate_of(deref(term))) : std::string_view();
}

bool Terms::is_negated(Value term) const {
  return is_literal(term) && jaywalk::is_negated(predicate_of(deref(term)));
}

std::vector<Value> Terms::args(Value term) const {
  std::vector<Value> args;
  if (!is_literal(term)) return args;
  for (const Value arg : literal_parts(deref(term)).args) args.push_back(deref(arg));
  return args;
}

std::vector<Value> Terms::annotations(Value term) const {
  return is_literal(term) ? dereferenced_elements(literal_parts(deref(term)).annots)
                          : std::vector<Value>();
}

std::vector<Value> Terms::elements(Value term) const { return dereferenced_elements(term); }

std::string_view Terms::text(Value term) const {
  const Value found = deref(term);
  return found.is_text() ? found.text()->view() : std::string_view();
}

std::string Terms::printed(Value term) const { return term_text(term, *symbols_); }
bool Terms::equal(Value a, Value b) const { return equal_terms(deref(a), deref(b)); }

Value Terms::atom(std::string_view functor) const {
  return Value::atom(symbols_->predicate(functor, 0));
}
Value Terms::string(std::string_view content) const { return heap_->text(content); }
Value Terms::list(const std::vector<Value>& elements) const { return heap_->list(elements); }

Value Terms::structure(std::string_view functor, const std::vector<Value>& args,
                       const std::vector<Value>& annotations) const {
  const auto arity = static_cast<std::uint16_t>(args.size());
  if (args.empty() && annotations.empty()) return atom(functor);
  return heap_->structure(symbols_->predicate(functor, arity), args,
                          sorted_set(*heap_, list(annotations), *symbols_));
}

Value Terms::variable() const { return heap_->variable(); }

}  // namespace jaywalk
