// SPDX-License-Identifier: Apache-2.0
#pragma once

// A stack of small values in one block of memory, which doubles when it is full. How many there are
// is a number of its own: it is asked for far more often than it changes. What the stack grows by
// is not cleared before it is written.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace jaywalk {

template <class T>
class FlatStack {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  FlatStack() = default;
  FlatStack(const FlatStack& other) { *this = other; }
  FlatStack(FlatStack&& other) noexcept { swap(other); }
  FlatStack& operator=(const FlatStack& other) {
    if (this == &other) return *this;
    size_ = 0;
    std::copy_n(other.data(), other.size_, extend(other.size_));
    return *this;
  }
  FlatStack& operator=(FlatStack&& other) noexcept {
    FlatStack taken(std::move(other));
    swap(taken);
    return *this;
  }
  ~FlatStack() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] T* data() { return values_.get(); }
  [[nodiscard]] const T* data() const { return values_.get(); }
  [[nodiscard]] T* begin() { return data(); }
  [[nodiscard]] T* end() { return data() + size_; }
  /// The elements pushed since there were `size`.
  [[nodiscard]] std::span<const T> since(std::size_t size) const {
    return {data() + size, size_ - size};
  }

  /// Room for more values, which the caller writes at once.
  [[nodiscard, gnu::always_inline]] T* extend(std::size_t count) {
    if (size_ + count > capacity_) grow(size_ + count);
    T* const first = values_.get() + size_;
    size_ += count;
    return first;
  }
  [[gnu::always_inline]] void push_back(T value) { *extend(1) = value; }
  /// REQUIRES: it is not empty.
  [[gnu::always_inline]] T take_back() { return values_[--size_]; }
  /// REQUIRES: there are as many.
  void cut(std::size_t size) { size_ = size; }
  void clear() { size_ = 0; }
  /// Takes those out that have come since there were `from` and that `is_it` holds for.
  template <class IsIt>
  void erase_if(std::size_t from, IsIt is_it) {
    if (from < size_)
      size_ = static_cast<std::size_t>(std::remove_if(begin() + from, end(), is_it) - begin());
  }

 private:
  void swap(FlatStack& other) noexcept {
    std::swap(values_, other.values_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }
  [[gnu::noinline]] void grow(std::size_t least) {
    const std::size_t wider = std::max({least, 2 * capacity_, std::size_t{8}});
    auto values = std::make_unique_for_overwrite<T[]>(wider);
    std::copy_n(values_.get(), size_, values.get());
    values_ = std::move(values);
    capacity_ = wider;
  }

  std::unique_ptr<T[]> values_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace jaywalk
