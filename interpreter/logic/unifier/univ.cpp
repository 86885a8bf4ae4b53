// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/unifier/univ.h"

#include <array>
#include <span>
#include <string>
#include <vector>

#include "interpreter/term/heap.h"
#include "interpreter/term/program_terms.h"

namespace jaywalk {
namespace {

bool take_apart(Unifier& unifier, Predicate predicate, std::span<const Value> args, Value annots,
                Value list) {
  Heap& heap = unifier.heap();
  SymbolTable& symbols = unifier.symbols();
  const Signature signature = symbols.signature(predicate);
  std::string functor(symbols.text(signature.functor));
  if (signature.negated) functor.insert(0, "~");
  const std::array<Value, 4> whole{
      Value::atom(symbols.predicate(Signature{.functor = signature.ns})),
      Value::atom(symbols.predicate(Signature{.functor = symbols.symbol(functor)})),
      heap.list(args), annots};
  if (unifier.unify(heap.list(whole), list)) return true;
  return unifier.unify(heap.list(std::span(whole).subspan(1)), list);
}

bool take_apart(Unifier& unifier, Value literal, Value list) {
  const LiteralParts parts = literal_parts(literal);
  return take_apart(unifier, parts.predicate, parts.args, parts.annots, list);
}

// As in Jason a trigger shows none of its parts.
bool take_apart_trigger(Unifier& unifier, Value literal, Value list) {
  return take_apart(unifier, literal_parts(literal).predicate, {}, Value::empty_list(), list);
}

std::vector<Value> elements_of(Value list) {
  std::vector<Value> elements;
  for (list = deref(list); list.is_pair(); list = deref(list.pair()->tail)) {
    elements.push_back(deref(list.pair()->head));
  }
  return elements;
}

// Label, trigger, context and body. The context may be in braces, { p(X) }.
Value plan_of(Heap& heap, SymbolTable& symbols, const std::vector<Value>& parts) {
  std::array<Value, 6> plan{parts[0], parts[1], parts[2], parts[3], Value(), Value()};
  Value& context = plan[2];
  if (is_form(context, Form::body) && context.structure()->arity > 0) {
    context = without_operator(context.structure()->arg(0));
  }
  if (context.is_atom() && context.atom_id() == predicates::truth) context = Value();
  const Value made =
      heap.structure(symbols.predicate(Signature{.functor = names::plan_text, .arity = 6}), plan,
                     Value::empty_list(), Form::plan);
  made.structure()->info |= Structure::kBare;
  return made;
}

bool put_together(Unifier& unifier, TextsRead& texts, Value term, Value list) {
  Heap& heap = unifier.heap();
  SymbolTable& symbols = unifier.symbols();
  const std::vector<Value> parts = elements_of(list);
  if (parts.size() == 4 && is_form(parts[3], Form::body)) {
    return unifier.unify(term, plan_of(heap, symbols, parts));
  }
  if (parts.size() != 3 && parts.size() != 4) return false;
  const std::size_t first = parts.size() - 3;
  std::string functor;
  if (parts[first].is_text()) {
    texts.require_room(heap, parts[first].text()->view().size());
    functor = parts[first].text()->view();
  } else if (is_literal(parts[first])) {
    const Predicate named = literal_parts(parts[first]).predicate;
    functor = symbols.functor(named);
    if (symbols.signature(named).negated) functor.insert(0, "~");
  } else {
    return false;
  }
  Signature signature;
  if (first == 1) {
    if (!is_literal(parts[0])) return false;
    signature.ns = symbols.signature(literal_parts(parts[0]).predicate).functor;
  }
  if (functor.starts_with('~')) {
    signature.negated = true;
    functor.erase(0, 1);
  }
  const std::vector<Value> args = elements_of(parts[first + 1]);
  if (args.size() > kMostParts) throw TermTooWide{};
  signature.functor = symbols.symbol(functor);
  signature.arity = static_cast<std::uint16_t>(args.size());
  return unifier.unify(term, heap.structure(symbols.predicate(signature), args, parts[first + 2]));
}

}  // namespace

bool unify_univ(Unifier& unifier, TextsRead& texts, Value term, Value list) {
  if (is_literal(term)) return take_apart(unifier, term, list);
  if (is_program(term) && !is_form(term, Form::plan)) {
    const Value literal = program_structure(unifier.heap(), unifier.symbols(), term);
    if (is_form(term, Form::trigger)) return take_apart_trigger(unifier, literal, list);
    return is_literal(literal) && take_apart(unifier, literal, list);
  }
  if (is_form(term, Form::plan)) {
    const Structure& plan = *term.structure();
    std::array<Value, 4> parts{plan.arg(0), plan.arg(1), plan.arg(2), plan.arg(3)};
    if (deref(parts[0]).is_unset()) parts[0] = unifier.heap().variable();
    if (deref(parts[2]).is_unset()) parts[2] = Value::atom(predicates::truth);
    return unifier.unify(unifier.heap().list(parts), list);
  }
  return list.is_pair() && put_together(unifier, texts, term, list);
}

}  // namespace jaywalk
