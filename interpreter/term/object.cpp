// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/object.h"

#include <algorithm>

#include "interpreter/term/compare.h"

namespace jaywalk {
namespace {

auto less_than(const SymbolTable& symbols) {
  return [&symbols](Value a, Value b) { return compare_terms(a, b, symbols) < 0; };
}

auto key_less_than(const SymbolTable& symbols) {
  return [&symbols](const MapObject::Entry& entry, Value key) {
    return compare_terms(entry.first, key, symbols) < 0;
  };
}

}  // namespace

std::unique_ptr<Object> SetObject::copy() const {
  auto copied = std::make_unique<SetObject>();
  copied->elements_ = elements_;
  return copied;
}

void SetObject::visit(const std::function<void(Value&)>& visit) {
  for (Value& element : elements_) visit(element);
}

void SetObject::add(Value element, const SymbolTable& symbols) {
  const auto place =
      std::lower_bound(elements_.begin(), elements_.end(), element, less_than(symbols));
  if (place != elements_.end() && compare_terms(*place, element, symbols) == 0) return;
  elements_.insert(place, element);
}

void SetObject::remove(Value element, const SymbolTable& symbols) {
  const auto place =
      std::lower_bound(elements_.begin(), elements_.end(), element, less_than(symbols));
  if (place != elements_.end() && compare_terms(*place, element, symbols) == 0) {
    elements_.erase(place);
  }
}

bool SetObject::contains(Value element, const SymbolTable& symbols) const {
  return std::binary_search(elements_.begin(), elements_.end(), element, less_than(symbols));
}

void SetObject::keep(Keep which, const SetObject& other, const SymbolTable& symbols) {
  std::erase_if(elements_, [&](Value element) {
    return other.contains(element, symbols) != (which == Keep::common);
  });
}

std::unique_ptr<Object> MapObject::copy() const {
  auto copied = std::make_unique<MapObject>();
  copied->entries_ = entries_;
  return copied;
}

void MapObject::visit(const std::function<void(Value&)>& visit) {
  for (auto& [key, value] : entries_) {
    visit(key);
    visit(value);
  }
}

void MapObject::put(Value key, Value value, const SymbolTable& symbols) {
  const auto place =
      std::lower_bound(entries_.begin(), entries_.end(), key, key_less_than(symbols));
  if (place != entries_.end() && compare_terms(place->first, key, symbols) == 0) {
    place->second = value;
  } else {
    entries_.insert(place, {key, value});
  }
}

const Value* MapObject::find(Value key, const SymbolTable& symbols) const {
  const auto place =
      std::lower_bound(entries_.begin(), entries_.end(), key, key_less_than(symbols));
  const bool found = place != entries_.end() && compare_terms(place->first, key, symbols) == 0;
  return found ? &place->second : nullptr;
}

void MapObject::remove(Value key, const SymbolTable& symbols) {
  const auto place =
      std::lower_bound(entries_.begin(), entries_.end(), key, key_less_than(symbols));
  if (place != entries_.end() && compare_terms(place->first, key, symbols) == 0) {
    entries_.erase(place);
  }
}

std::unique_ptr<Object> QueueObject::copy() const {
  auto copied = std::make_unique<QueueObject>(order_);
  copied->elements_ = elements_;
  return copied;
}

void QueueObject::visit(const std::function<void(Value&)>& visit) {
  for (Value& element : elements_) visit(element);
}

void QueueObject::add(Value element, const SymbolTable& symbols) {
  elements_.push_back(element);
  if (order_ == Order::arrival) return;
  std::size_t at = elements_.size() - 1;
  while (at > 0) {
    const std::size_t parent = (at - 1) / 2;
    if (compare_terms(element, elements_[parent], symbols) >= 0) break;
    elements_[at] = elements_[parent];
    at = parent;
  }
  elements_[at] = element;
}

Value QueueObject::take(const SymbolTable& symbols) {
  const Value head = elements_.front();
  if (order_ == Order::arrival) {
    elements_.pop_front();
    return head;
  }
  const Value last = elements_.back();
  elements_.pop_back();
  if (elements_.empty()) return head;
  std::size_t at = 0;
  for (std::size_t child = 1; child < elements_.size(); child = 2 * at + 1) {
    if (child + 1 < elements_.size() &&
        compare_terms(elements_[child], elements_[child + 1], symbols) > 0) {
      ++child;
    }
    if (compare_terms(last, elements_[child], symbols) <= 0) break;
    elements_[at] = elements_[child];
    at = child;
  }
  elements_[at] = last;
  return head;
}

}  // namespace jaywalk
