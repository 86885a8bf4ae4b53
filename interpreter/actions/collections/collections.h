// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shared by the actions on sets, maps and queues. The collection is always the first argument.

#include <memory>
#include <type_traits>

#include "interpreter/actions/actions.h"
#include "interpreter/logic/machine.h"

namespace jaywalk::actions {

/// No collection has more elements.
inline constexpr std::size_t kMaxElements = std::size_t{1} << 24U;

/// A new object, which outlives backtracking in a query.
[[nodiscard]] inline Value made(ActionCall& call, std::unique_ptr<Object> object) {
  const Value value = call.heap().object(std::move(object));
  call.heap().protect();
  return value;
}

/// A copy of a value for a collection: it has fresh variables and outlives backtracking in a query.
[[nodiscard]] inline Value kept(ActionCall& call, Value value) {
  if (!value.is_closed()) value = call.unifier().fresh_copy(value);
  call.heap().protect();
  return value;
}

[[nodiscard]] inline Outcome within_limit(ActionCall& call, const Object& object) {
  return object.size() <= kMaxElements ? Outcome::succeeded
                                       : call.fail("limit", "the collection is too large");
}

template <class Collection>
struct Collections {
  static constexpr Object::Kind kKind = std::is_same_v<Collection, SetObject> ? Object::Kind::set
                                        : std::is_same_v<Collection, MapObject>
                                            ? Object::Kind::map
                                            : Object::Kind::queue;

  /// Null if the argument is no such collection.
  static Collection* get(ActionCall& call) {
    const Value value = call.arg(0);
    if (!value.is_object() || value.object()->object->kind() != kKind) return nullptr;
    return static_cast<Collection*>(value.object()->object);
  }

  /// Like get(), but an unbound variable receives a new set or map (not a queue).
  static Collection* get_or_make(ActionCall& call) {
    if constexpr (kKind != Object::Kind::queue) {
      if (call.arg(0).is_variable() && create(call) != Outcome::succeeded) return nullptr;
    }
    return get(call);
  }

  static Outcome wrong(ActionCall& call) {
    return call.java_exception(kKind == Object::Kind::set   ? "the first argument is no set"
                               : kKind == Object::Kind::map ? "the first argument is no map"
                                                            : "the first argument is no queue");
  }

  static Outcome create(ActionCall& call) {
    if (!call.arg(0).is_variable()) return Outcome::failed;
    return call.result(0, made(call, std::make_unique<Collection>()));
  }

  static Outcome clear(ActionCall& call) {
    Collection* const collection = get_or_make(call);
    if (collection == nullptr) return wrong(call);
    collection->clear();
    return Outcome::succeeded;
  }

  static Outcome copy(ActionCall& call) {
    const Collection* const collection = get_or_make(call);
    if (collection == nullptr) return wrong(call);
    return call.result(1, made(call, collection->copy()));
  }
};

}  // namespace jaywalk::actions
