// SPDX-License-Identifier: Apache-2.0
#pragma once

// A queue in one block of memory, which doubles when it is full. An empty one that was never used
// owns no memory, which counts where there are several for each of 100,000 agents.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>

namespace jaywalk {

template <class T>
class Ring {
  template <class Owner, class Element>
  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Element*;
    using reference = Element&;

    Iterator() = default;
    Iterator(Owner& ring, std::size_t index) : ring_(&ring), index_(index) {}

    reference operator*() const { return (*ring_)[index_]; }
    pointer operator->() const { return &(*ring_)[index_]; }
    reference operator[](difference_type n) const { return *(*this + n); }
    Iterator& operator++() { return *this += 1; }
    Iterator operator++(int) { return std::exchange(*this, *this + 1); }
    Iterator& operator--() { return *this -= 1; }
    Iterator operator--(int) { return std::exchange(*this, *this - 1); }
    Iterator& operator+=(difference_type n) {
      index_ = static_cast<std::size_t>(static_cast<difference_type>(index_) + n);
      return *this;
    }
    Iterator& operator-=(difference_type n) { return *this += -n; }
    friend Iterator operator+(Iterator i, difference_type n) { return i += n; }
    friend Iterator operator+(difference_type n, Iterator i) { return i += n; }
    friend Iterator operator-(Iterator i, difference_type n) { return i -= n; }
    friend difference_type operator-(const Iterator& a, const Iterator& b) {
      return static_cast<difference_type>(a.index_) - static_cast<difference_type>(b.index_);
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }
    friend auto operator<=>(const Iterator& a, const Iterator& b) { return a.index_ <=> b.index_; }

   private:
    Owner* ring_ = nullptr;
    std::size_t index_ = 0;
  };

 public:
  using value_type = T;
  using iterator = Iterator<Ring, T>;
  using const_iterator = Iterator<const Ring, const T>;

  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// How many elements there is memory for.
  [[nodiscard]] std::size_t capacity() const {
    return slots_ == nullptr ? 0 : std::size_t{mask_} + 1;
  }

  /// REQUIRES: there is such an element; so do front(), back() and pop_front().
  [[nodiscard]] T& operator[](std::size_t index) { return slots_[place(index)]; }
  [[nodiscard]] const T& operator[](std::size_t index) const { return slots_[place(index)]; }
  [[nodiscard]] T& front() { return slots_[first_]; }
  [[nodiscard]] const T& front() const { return slots_[first_]; }
  [[nodiscard]] T& back() { return (*this)[size_ - 1]; }
  [[nodiscard]] const T& back() const { return (*this)[size_ - 1]; }

  void push_back(T value) {
    make_room();
    slots_[place(size_++)] = std::move(value);
  }
  void push_front(T value) {
    make_room();
    first_ = static_cast<std::uint32_t>(place(mask_));
    ++size_;
    slots_[first_] = std::move(value);
  }
  void pop_front() {
    slots_[first_] = T{};  // lets go of what it owned
    first_ = static_cast<std::uint32_t>(place(1));
    --size_;
  }
  void pop_back() {
    back() = T{};
    --size_;
  }
  void clear() {
    while (!empty()) pop_front();
  }
  iterator insert(iterator position, T value) {
    const auto index = position - begin();
    push_back(std::move(value));
    std::rotate(begin() + index, end() - 1, end());
    return begin() + index;
  }
  /// Removes the element at a position. REQUIRES: there is one.
  void erase(iterator position) {
    std::move(position + 1, end(), position);
    cut(end() - 1);
  }
  /// Removes the elements from `from` to the end.
  void cut(iterator from) {
    const auto left = static_cast<std::size_t>(from - begin());
    for (std::size_t i = left; i < size_; ++i) (*this)[i] = T{};
    size_ = static_cast<std::uint32_t>(left);
  }

  [[nodiscard]] iterator begin() { return {*this, 0}; }
  [[nodiscard]] iterator end() { return {*this, size_}; }
  [[nodiscard]] const_iterator begin() const { return {*this, 0}; }
  [[nodiscard]] const_iterator end() const { return {*this, size_}; }

 private:
  // The number of slots is a power of two.
  [[nodiscard]] std::size_t place(std::size_t index) const { return (first_ + index) & mask_; }
  void make_room() {
    if (size_ == capacity()) grow();
  }
  [[gnu::noinline]] void grow() {
    const std::size_t capacity = std::max<std::size_t>(1, 2 * std::size_t{size_});
    auto wider = std::make_unique<T[]>(capacity);
    std::move(begin(), end(), wider.get());
    slots_ = std::move(wider);
    first_ = 0;
    mask_ = static_cast<std::uint32_t>(capacity - 1);
  }

  std::unique_ptr<T[]> slots_;
  std::uint32_t first_ = 0;
  std::uint32_t size_ = 0;
  std::uint32_t mask_ = 0;
};

/// As std::erase_if and std::erase for the standard containers.
template <class T, class Predicate>
std::size_t erase_if(Ring<T>& ring, Predicate predicate) {
  const auto kept = std::remove_if(ring.begin(), ring.end(), predicate);
  const auto removed = static_cast<std::size_t>(ring.end() - kept);
  ring.cut(kept);
  return removed;
}
template <class T>
std::size_t erase(Ring<T>& ring, const T& value) {
  return erase_if(ring, [&](const T& element) { return element == value; });
}

}  // namespace jaywalk
