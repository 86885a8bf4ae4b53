#include "interpreter/actions/collections/collections.h"

namespace jaywalk::actions {
namespace {

using Sets = Collections<SetObject>;

// A list or set as a set.
bool as_set(ActionCall& call, Value value, SetObject& set) {
  std::vector<Value> all;
  if (!collection_in(value, all)) return false;
  for (const Value element : all) set.add(element, call.symbols());
  return true;
}

Outcome add_elements(ActionCall& call) {
  std::vector<Value> all;
  if (!collection_in(call.arg(1), all))
    return call.java_exception("the second argument is neither list nor set");
  SetObject* const set = Sets::get_or_make(call);
  if (set == nullptr) return Sets::wrong(call);
  for (const Value element : all) set->add(kept(call, element), call.symbols());
  return within_limit(call, *set);
}

Outcome keep_elements(ActionCall& call, SetObject::Keep which) {
  SetObject* const set = Sets::get_or_make(call);
  if (set == nullptr) return Sets::wrong(call);
  SetObject other;
  if (!as_set(call, call.arg(1), other))
    return call.java_exception("the second argument is neither list nor set");
  set->keep(which, other, call.symbols());
  return Outcome::succeeded;
}

}  // namespace

Outcome set_create(ActionCall& call) { return Sets::create(call); }

Outcome set_add(ActionCall& call) {
  SetObject* const set = Sets::get_or_make(call);
  if (set == nullptr) return Sets::wrong(call);
  set->add(kept(call, call.arg(1)), call.symbols());
  return within_limit(call, *set);
}

Outcome set_add_all(ActionCall& call) { return add_elements(call); }
Outcome set_unite(ActionCall& call) { return add_elements(call); }
Outcome set_intersect(ActionCall& call) { return keep_elements(call, SetObject::Keep::common); }
Outcome set_subtract(ActionCall& call) { return keep_elements(call, SetObject::Keep::others); }

Outcome set_remove(ActionCall& call) {
  SetObject* const set = Sets::get_or_make(call);
  if (set == nullptr) return Sets::wrong(call);
  set->remove(call.arg(1), call.symbols());
  return Outcome::succeeded;
}

Outcome set_to_list(ActionCall& call) {
  const SetObject* const set = Sets::get_or_make(call);
  if (set == nullptr) return Sets::wrong(call);
  return call.result(1, call.heap().list(set->elements()));
}

Outcome set_clear(ActionCall& call) { return Sets::clear(call); }
Outcome set_copy(ActionCall& call) { return Sets::copy(call); }

}  // namespace jaywalk::actions
