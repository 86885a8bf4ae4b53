// SPDX-License-Identifier: Apache-2.0
// Sets, maps and queues.

#include "interpreter/actions/collections/collections.h"

namespace jaywalk::actions {
namespace {

using Queues = Collections<QueueObject>;

using Maps = Collections<MapObject>;

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

Outcome queue_create(ActionCall& call) {
  if (!call.arg(0).is_variable()) return Outcome::failed;
  const bool priority = call.count() == 2 && text_of(call.arg(1), call.symbols()) == "priority";
  const auto order = priority ? QueueObject::Order::priority : QueueObject::Order::arrival;
  return call.result(0, made(call, std::make_unique<QueueObject>(order)));
}

Outcome queue_add(ActionCall& call) {
  QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  queue->add(kept(call, call.arg(1)), call.symbols());
  return within_limit(call, *queue);
}

Outcome queue_add_all(ActionCall& call) {
  QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  std::vector<Value> all;
  if (!collection_in(call.arg(1), all))
    return call.java_exception("the second argument is no list");
  for (const Value element : all) queue->add(kept(call, element), call.symbols());
  return within_limit(call, *queue);
}

Outcome queue_head(ActionCall& call) {
  const QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  return queue->size() == 0 ? Outcome::failed : call.result(1, queue->elements().front());
}

Outcome queue_remove(ActionCall& call) {
  QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  return queue->size() == 0 ? Outcome::failed : call.result(1, queue->take(call.symbols()));
}

Outcome queue_to_list(ActionCall& call) {
  const QueueObject* const queue = Queues::get(call);
  if (queue == nullptr) return Queues::wrong(call);
  const std::vector<Value> all(queue->elements().begin(), queue->elements().end());
  return call.result(1, call.heap().list(all));
}

Outcome queue_clear(ActionCall& call) { return Queues::clear(call); }

Outcome queue_copy(ActionCall& call) { return Queues::copy(call); }

Outcome map_create(ActionCall& call) { return Maps::create(call); }

Outcome map_put(ActionCall& call) {
  MapObject* const map = Maps::get_or_make(call);
  if (map == nullptr) return Maps::wrong(call);
  const Value key = kept(call, call.arg(1));
  map->put(key, kept(call, call.arg(2)), call.symbols());
  return within_limit(call, *map);
}

Outcome map_get(ActionCall& call) {
  const MapObject* const map = Maps::get_or_make(call);
  if (map == nullptr) return Maps::wrong(call);
  const Value* const value = map->find(call.arg(1), call.symbols());
  if (value != nullptr) return call.result(2, *value);
  return call.count() == 4 ? call.result(2, call.arg(3)) : Outcome::failed;
}

Outcome map_remove(ActionCall& call) {
  MapObject* const map = Maps::get_or_make(call);
  if (map == nullptr) return Maps::wrong(call);
  const Value* const found = map->find(call.arg(1), call.symbols());
  if (found == nullptr) return Outcome::failed;
  const Value value = *found;
  map->remove(call.arg(1), call.symbols());
  return call.count() == 3 ? call.result(2, value) : Outcome::succeeded;
}

Outcome map_key(ActionCall& call) {
  const MapObject* const map = Maps::get_or_make(call);
  if (map == nullptr) return Maps::wrong(call);
  std::vector<Value> keys;
  for (const auto& [key, value] : map->entries()) keys.push_back(key);
  return call.many(std::make_unique<ValueSolutions>(1, std::move(keys)));
}

Outcome map_value(ActionCall& call) {
  const MapObject* const map = Maps::get_or_make(call);
  if (map == nullptr) return Maps::wrong(call);
  std::vector<Value> values;
  for (const auto& [key, value] : map->entries()) values.push_back(value);
  return call.many(std::make_unique<ValueSolutions>(1, std::move(values)));
}

Outcome map_clear(ActionCall& call) { return Maps::clear(call); }
Outcome map_copy(ActionCall& call) { return Maps::copy(call); }

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
