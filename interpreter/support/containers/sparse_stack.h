#pragma once

// A stack that is nearly always empty: it takes one word until something is put on it.

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace jaywalk {

template <class T>
class SparseStack {
 public:
  SparseStack() = default;
  SparseStack(const SparseStack& other)
      : items_(other.empty() ? nullptr : std::make_unique<std::vector<T>>(*other.items_)) {}
  SparseStack(SparseStack&&) noexcept = default;
  SparseStack& operator=(const SparseStack& other) {
    items_ = other.empty() ? nullptr : std::make_unique<std::vector<T>>(*other.items_);
    return *this;
  }
  SparseStack& operator=(SparseStack&&) noexcept = default;
  ~SparseStack() = default;

  [[nodiscard]] bool empty() const { return items_ == nullptr || items_->empty(); }
  [[nodiscard]] std::size_t size() const { return items_ == nullptr ? 0 : items_->size(); }
  /// REQUIRES: there is such an item; so do back() and pop_back().
  [[nodiscard]] T& operator[](std::size_t index) { return (*items_)[index]; }
  [[nodiscard]] const T& operator[](std::size_t index) const { return (*items_)[index]; }
  [[nodiscard]] T& back() { return items_->back(); }
  [[nodiscard]] const T& back() const { return items_->back(); }

  void push_back(T item) { items().push_back(std::move(item)); }
  T& emplace_back() { return items().emplace_back(); }
  void pop_back() { items_->pop_back(); }

  [[nodiscard]] T* begin() { return empty() ? nullptr : items_->data(); }
  [[nodiscard]] T* end() { return begin() + size(); }
  [[nodiscard]] const T* begin() const { return empty() ? nullptr : items_->data(); }
  [[nodiscard]] const T* end() const { return begin() + size(); }

 private:
  std::vector<T>& items() {
    if (items_ == nullptr) items_ = std::make_unique<std::vector<T>>();
    return *items_;
  }

  std::unique_ptr<std::vector<T>> items_;
};

}  // namespace jaywalk
