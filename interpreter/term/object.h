// SPDX-License-Identifier: Apache-2.0
#pragma once

// Mutable collections that terms refer to: sets, maps and queues. They are shared by reference and
// live as long as a reachable term names them. Sets and maps are in the order of terms (compare.h).
// Terms put into them must be protected from being released (Heap::protect).

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "interpreter/term/symbol.h"
#include "interpreter/term/value.h"

namespace jaywalk {

/// The rough size of an empty collection, in bytes.
inline constexpr std::size_t kObjectBytes = 128;

class Object {
 public:
  enum class Kind { set, map, queue };

  virtual ~Object() = default;
  [[nodiscard]] virtual Kind kind() const = 0;
  /// The number of elements, or of pairs.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// Memory of the object itself, without the terms in it.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  /// Another object with the same Values.
  [[nodiscard]] virtual std::unique_ptr<Object> copy() const = 0;
  /// Passes every Value that it holds to `visit`, which may move it: of a map, each key and then
  /// its value.
  virtual void visit(const std::function<void(Value&)>& visit) = 0;

  /// Set by the collector.
  bool reached = false;
  /// Distinguishes the objects of a heap, numbered in the order of their making.
  std::uint64_t serial = 0;
};

class SetObject final : public Object {
 public:
  [[nodiscard]] Kind kind() const override { return Kind::set; }
  [[nodiscard]] std::size_t size() const override { return elements_.size(); }
  [[nodiscard]] std::size_t bytes() const override {
    return kObjectBytes + 2 * elements_.size() * sizeof(Value);
  }
  [[nodiscard]] std::unique_ptr<Object> copy() const override;
  void visit(const std::function<void(Value&)>& visit) override;

  [[nodiscard]] const std::vector<Value>& elements() const { return elements_; }
  void add(Value element, const SymbolTable& symbols);
  void remove(Value element, const SymbolTable& symbols);
  [[nodiscard]] bool contains(Value element, const SymbolTable& symbols) const;
  /// Keeps the elements that `other`, a sorted set, has, or has not.
  enum class Keep { common, others };
  void keep(Keep which, const SetObject& other, const SymbolTable& symbols);
  void clear() { elements_.clear(); }

 private:
  std::vector<Value> elements_;
};

class MapObject final : public Object {
 public:
  using Entry = std::pair<Value, Value>;

  [[nodiscard]] Kind kind() const override { return Kind::map; }
  [[nodiscard]] std::size_t size() const override { return entries_.size(); }
  [[nodiscard]] std::size_t bytes() const override {
    return kObjectBytes + 2 * entries_.size() * sizeof(Entry);
  }
  [[nodiscard]] std::unique_ptr<Object> copy() const override;
  void visit(const std::function<void(Value&)>& visit) override;

  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  void put(Value key, Value value, const SymbolTable& symbols);
  /// Null if there is none.
  [[nodiscard]] const Value* find(Value key, const SymbolTable& symbols) const;
  void remove(Value key, const SymbolTable& symbols);
  void clear() { entries_.clear(); }

 private:
  std::vector<Entry> entries_;
};

/// First in, first out; or the least first, a binary heap in the order in which Java's has it.
class QueueObject final : public Object {
 public:
  enum class Order { arrival, priority };
  explicit QueueObject(Order order) : order_(order) {}

  [[nodiscard]] Kind kind() const override { return Kind::queue; }
  [[nodiscard]] std::size_t size() const override { return elements_.size(); }
  [[nodiscard]] std::size_t bytes() const override {
    return kObjectBytes + 2 * elements_.size() * sizeof(Value);
  }
  [[nodiscard]] std::unique_ptr<Object> copy() const override;
  void visit(const std::function<void(Value&)>& visit) override;

  [[nodiscard]] const std::deque<Value>& elements() const { return elements_; }
  void add(Value element, const SymbolTable& symbols);
  /// Takes the head away. REQUIRES: not empty.
  Value take(const SymbolTable& symbols);
  void clear() { elements_.clear(); }

 private:
  Order order_;
  std::deque<Value> elements_;
};

}  // namespace jaywalk
