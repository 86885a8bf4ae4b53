// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

// The term with one of its arguments replaced.
Value with_argument(Heap& heap, Value term, std::size_t index, Value argument) {
  const Structure& s = *term.structure();
  std::vector<Value> args(s.arg_span().begin(), s.arg_span().end());
  args[index] = argument;
  return heap.structure(s.predicate(), args, s.annots(), s.form());
}

// `function` applied to a literal, to the head of a rule, to the label of a plan or to each element
// of a list; other terms stay.
template <class Function>
Value map_literals(ActionCall& call, Value value, const Function& function) {
  value = deref(value);
  if (value.is_list()) {
    std::vector<Value> all;
    for (const Value element : elements(value)) {
      all.push_back(map_literals(call, element, function));
    }
    return call.heap().list(all);
  }
  if (is_form(value, Form::rule) || is_form(value, Form::plan)) {
    const Value inner = deref(value.structure()->arg(0));
    if (!is_literal(inner)) return value;
    return with_argument(call.heap(), value, 0, function(inner));
  }
  return is_literal(value) ? function(value) : value;
}

}  // namespace

Outcome add_annot(ActionCall& call) {
  const Value added = call.arg(1);
  const Value result = map_literals(call, call.arg(0), [&](Value literal) {
    const std::array<Value, 1> one{added};
    return with_annotations(call.heap(), literal,
                            union_of(call.heap(), literal_parts(literal).annots,
                                     call.heap().list(one), call.symbols()));
  });
  return when(call.unifier().unify(result, call.arg(2)));
}

Outcome add_nested_source(ActionCall& call) {
  if (call.agent() == nullptr) return Outcome::failed;
  const Value result = map_literals(call, call.arg(0), [&](Value literal) {
    return call.agent()->add_source(literal, call.arg(1));
  });
  return when(call.unifier().unify(result, call.arg(2)));
}

Outcome remove_source_annot(ActionCall& call) {
  return call.result(1, map_literals(call, call.arg(0), [&](Value literal) {
                       return without_sources(call.heap(), literal);
                     }));
}

Value without_sources(Heap& heap, Value literal) {
  const Value annots = literal_parts(literal).annots;
  if (!has_source(annots)) return literal;
  std::vector<Value> kept;
  Value rest = deref(annots);
  for (; rest.is_pair(); rest = deref(rest.pair()->tail)) {
    const Value annot = deref(rest.pair()->head);
    if (!annot.is_structure() || annot.structure()->predicate() != predicates::source) {
      kept.push_back(annot);
    }
  }
  return with_annotations(heap, literal, heap.list(kept, rest));
}

Outcome copy_term(ActionCall& call) {
  return call.result(1, call.unifier().fresh_copy(call.arg(0)));
}

Outcome rename_apart(ActionCall& call) {
  return call.result(1, call.unifier().fresh_copy(call.applied(0)));
}

Outcome get_src_info(ActionCall& call) {
  if (!is_literal(call.arg(0))) return Outcome::failed;
  // Terms do not remember where they were written: the place reported is that of the formula that
  // asks.
  std::string source = call.agent()->program().name() + ".asl";
  double number = 0;
  const Intention* const own = call.intention();
  if (own != nullptr && !own->is_finished() && !own->top().is_finished()) {
    source = own->top().plan->file;
    number = own->top().step().place.line;
  }
  Heap& heap = call.heap();
  SymbolTable& symbols = call.symbols();
  const std::array<Value, 1> file{heap.text("file:" + source)};
  const std::array<Value, 1> line{Value::number(number)};
  const std::array<Value, 2> info{heap.structure(predicates::code_line, line),
                                  heap.structure(predicates::code_src, file)};
  const Value annots = union_of(heap, literal_parts(call.arg(0)).annots, heap.list(info), symbols);
  return call.result(1, with_annotations(heap, call.arg(0), annots));
}

}  // namespace jaywalk::actions
