// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/walk.h"

#include <vector>

#include "interpreter/term/heap.h"

namespace jaywalk {
namespace {

struct Visit {
  Value value;
  bool is_left = false;  // all below it has been visited
};

void add_parts(Value value, std::vector<Visit>& todo) {
  if (value.is_pair()) {
    todo.push_back({value.pair()->tail});
    todo.push_back({value.pair()->head});
    return;
  }
  const Structure& s = *value.structure();
  todo.push_back({s.annots()});
  for (const Value arg : s.arg_span()) todo.push_back({arg});
}

}  // namespace

Circles circles_of(Value term, const Value* slots) {
  enum class Place : std::uint8_t { on_the_way, behind };
  Circles circles;
  std::unordered_map<std::uint64_t, Place> known;
  std::vector<Visit> todo{{term}};
  while (!todo.empty()) {
    auto [value, is_left] = todo.back();
    todo.pop_back();
    if (is_left) {
      known[value.bits()] = Place::behind;
      continue;
    }
    if (value.is_slot() && slots != nullptr) value = slots[value.slot_index()];
    const Variable* variable = nullptr;
    while (value.is_variable() && !value.variable()->value.is_unset()) {
      variable = value.variable();
      value = variable->value;
    }
    if (value.is_closed() || (!value.is_pair() && !value.is_structure())) continue;
    const auto [place, is_new] = known.emplace(value.bits(), Place::on_the_way);
    if (is_new) {
      todo.push_back({value, true});
      add_parts(value, todo);
    } else if (place->second == Place::on_the_way && variable != nullptr) {
      circles.emplace(value.bits(), variable);
    }
  }
  return circles;
}

}  // namespace jaywalk
