// SPDX-License-Identifier: Apache-2.0
#pragma once

// A value that is allocated or computed when it is first needed, and then kept.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace jaywalk {

/// A computed value. REQUIRES: one thread at a time asks.
template <class T>
class Lazy {
 public:
  explicit Lazy(std::function<T()> make) : make_(std::move(make)) {}

  [[nodiscard]] const T& operator*() const {
    if (!value_) value_ = make_();
    return *value_;
  }
  [[nodiscard]] const T* operator->() const { return &**this; }

 private:
  std::function<T()> make_;
  mutable std::optional<T> value_;
};

/// A value that most of its owners do not have: a single pointer until it is first asked for. A
/// copy of the owner has a copy of it.
template <class T>
class LazyValue {
 public:
  LazyValue() = default;
  LazyValue(const LazyValue& other)
      : value_(other.value_ == nullptr ? nullptr : std::make_unique<T>(*other.value_)) {}
  LazyValue(LazyValue&&) noexcept = default;
  LazyValue& operator=(const LazyValue& other) {
    value_ = other.value_ == nullptr ? nullptr : std::make_unique<T>(*other.value_);
    return *this;
  }
  LazyValue& operator=(LazyValue&&) noexcept = default;
  ~LazyValue() = default;

  [[nodiscard]] explicit operator bool() const { return value_ != nullptr; }
  /// REQUIRES: it is there.
  [[nodiscard]] T& operator*() const { return *value_; }
  [[nodiscard]] T* operator->() const { return value_.get(); }
  /// The value itself, from now on.
  [[nodiscard]] T& make() {
    if (value_ == nullptr) value_ = std::make_unique<T>();
    return *value_;
  }
  void reset() { value_.reset(); }

 private:
  std::unique_ptr<T> value_;
};

/// A container that most of its owners never put anything into: a single pointer until the first
/// element comes. It has as much of the container's interface as is needed.
template <class Container>
class LazyContainer {
 public:
  using value_type = typename Container::value_type;
  using iterator = typename Container::iterator;
  using const_iterator = typename Container::const_iterator;

  [[nodiscard]] bool empty() const { return all_ == nullptr || all_->empty(); }
  [[nodiscard]] std::size_t size() const { return all_ == nullptr ? 0 : all_->size(); }
  /// How many elements there is memory for.
  [[nodiscard]] std::size_t capacity() const { return all_ == nullptr ? 0 : all_->capacity(); }

  [[nodiscard]] iterator begin() { return all_ == nullptr ? iterator{} : all_->begin(); }
  [[nodiscard]] iterator end() { return all_ == nullptr ? iterator{} : all_->end(); }
  [[nodiscard]] const_iterator begin() const {
    return all_ == nullptr ? const_iterator{} : std::as_const(*all_).begin();
  }
  [[nodiscard]] const_iterator end() const {
    return all_ == nullptr ? const_iterator{} : std::as_const(*all_).end();
  }

  /// REQUIRES: there is such an element; so do the others as far as they take one.
  [[nodiscard]] value_type& operator[](std::size_t index) { return (*all_)[index]; }
  [[nodiscard]] value_type& front() { return all_->front(); }
  [[nodiscard]] value_type& back() { return all_->back(); }
  void pop_front() { all_->pop_front(); }
  void pop_back() { all_->pop_back(); }
  void erase(iterator position) { all_->erase(position); }

  void push_back(value_type value) { all().push_back(std::move(value)); }
  template <class... Parts>
  void emplace_back(Parts&&... parts) {
    all().emplace_back(std::forward<Parts>(parts)...);
  }
  void clear() {
    if (all_ != nullptr) all_->clear();
  }
  /// The elements, which leave.
  [[nodiscard]] Container take() {
    return all_ == nullptr ? Container{} : std::exchange(*all_, Container{});
  }
  /// The container itself, from now on.
  [[nodiscard]] Container& all() {
    if (all_ == nullptr) all_ = std::make_unique<Container>();
    return *all_;
  }

 private:
  std::unique_ptr<Container> all_;
};

/// As std::erase_if and std::erase for the standard containers.
template <class Container, class Predicate>
std::size_t erase_if(LazyContainer<Container>& container, Predicate predicate) {
  if (container.empty()) return 0;
  using std::erase_if;
  return erase_if(container.all(), predicate);
}
template <class Container, class T>
std::size_t erase(LazyContainer<Container>& container, const T& value) {
  return erase_if(container, [&](const auto& element) { return element == value; });
}

}  // namespace jaywalk
