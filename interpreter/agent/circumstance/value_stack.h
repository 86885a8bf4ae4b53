#pragma once

// The frames of an intention: a stack of Values in one block of memory, which doubles when it is
// full. What it grows by is not cleared before it is written.

#include <algorithm>
#include <cstddef>
#include <memory>

#include "interpreter/term/value.h"

namespace jaywalk {

class ValueStack {
 public:
  ValueStack() = default;
  ValueStack(const ValueStack& other) { *this = other; }
  ValueStack(ValueStack&&) noexcept = default;
  ValueStack& operator=(const ValueStack& other) {
    if (this == &other) return *this;
    size_ = 0;
    std::copy_n(other.data(), other.size_, extend(other.size_));
    return *this;
  }
  ValueStack& operator=(ValueStack&&) noexcept = default;
  ~ValueStack() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  [[nodiscard]] Value* data() { return values_.get(); }
  [[nodiscard]] const Value* data() const { return values_.get(); }
  [[nodiscard]] Value* begin() { return data(); }
  [[nodiscard]] Value* end() { return data() + size_; }

  /// Room for more values, which the caller writes at once.
  [[nodiscard, gnu::always_inline]] Value* extend(std::size_t count) {
    if (size_ + count > capacity_) grow(size_ + count);
    Value* const first = values_.get() + size_;
    size_ += count;
    return first;
  }
  void push_back(Value value) { *extend(1) = value; }
  /// REQUIRES: there are as many.
  void cut(std::size_t size) { size_ = size; }
  void clear() { size_ = 0; }
  /// Gives the memory back, too.
  void release() { *this = ValueStack(); }

 private:
  [[gnu::noinline]] void grow(std::size_t least) {
    const std::size_t wider = std::max({least, 2 * capacity_, std::size_t{8}});
    auto values = std::make_unique_for_overwrite<Value[]>(wider);
    std::copy_n(values_.get(), size_, values.get());
    values_ = std::move(values);
    capacity_ = wider;
  }

  std::unique_ptr<Value[]> values_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace jaywalk
