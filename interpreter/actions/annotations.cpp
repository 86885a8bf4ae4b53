#include "interpreter/actions/actions.h"
#include "interpreter/agent/agent.h"
#include "interpreter/term/compare.h"

namespace jaywalk::actions {
namespace {

Value without_sources(Heap& heap, Value value) {
  value = deref(value);
  if (value.is_pair()) {
    std::vector<Value> all;
    for (const Value element : elements(value)) all.push_back(without_sources(heap, element));
    return heap.list(all);
  }
  if (!is_literal(value)) return value;
  std::vector<Value> kept;
  for (const Value annot : elements(literal_parts(value).annots)) {
    if (!annot.is_structure() || annot.structure()->predicate() != predicates::source) {
      kept.push_back(annot);
    }
  }
  return with_annotations(heap, value, heap.list(kept));
}

}  // namespace

Outcome add_nested_source(ActionCall& call) {
  const Value value = call.arg(0);
  if (!value.is_list()) return call.result(2, call.agent()->add_source(value, call.arg(1)));
  std::vector<Value> all;
  for (const Value element : elements(value)) {
    all.push_back(call.agent()->add_source(element, call.arg(1)));
  }
  return call.result(2, call.heap().list(all));
}

Outcome remove_source_annot(ActionCall& call) {
  return call.result(1, without_sources(call.heap(), call.arg(0)));
}

}  // namespace jaywalk::actions
