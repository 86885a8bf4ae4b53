#include "interpreter/actions/collections/collections.h"

namespace jaywalk::actions {
namespace {

using Maps = Collections<MapObject>;

}  // namespace

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

}  // namespace jaywalk::actions
