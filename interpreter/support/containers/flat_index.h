// SPDX-License-Identifier: Apache-2.0
#pragma once

// A hash table from numbers to small numbers in one block of memory: keys that collide stand in the
// next free place (linear probing). For tables that are asked far more often than they change;
// nothing is removed from them.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jaywalk {

template <class Key>
class FlatIndex {
 public:
  static constexpr std::uint32_t kNone = 0xFFFF'FFFFU;

  /// The number for a key; kNone if there is none.
  [[nodiscard]] std::uint32_t find(Key key) const {
    if (entries_.empty()) return kNone;
    for (std::size_t i = place(key);; i = (i + 1) & mask_) {
      const Entry& entry = entries_[i];
      if (entry.key == key || entry.value == kNone) return entry.value;
    }
  }
  /// REQUIRES: the key is new, the value is not kNone.
  void insert(Key key, std::uint32_t value) {
    if (2 * (size_ + 1) > entries_.size()) grow();
    put(key, value);
    ++size_;
  }
  void clear() {
    entries_.clear();
    size_ = 0;
  }

 private:
  struct Entry {
    Key key{};
    std::uint32_t value = kNone;
  };
  [[nodiscard]] std::size_t place(Key key) const {
    const std::uint64_t mixed = static_cast<std::uint64_t>(key) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(mixed >> 32U) & mask_;
  }
  void put(Key key, std::uint32_t value) {
    std::size_t i = place(key);
    while (entries_[i].value != kNone) i = (i + 1) & mask_;
    entries_[i] = {key, value};
  }
  void grow() {
    std::vector<Entry> old(entries_.empty() ? 8 : 2 * entries_.size());
    old.swap(entries_);
    mask_ = entries_.size() - 1;
    for (const Entry& entry : old) {
      if (entry.value != kNone) put(entry.key, entry.value);
    }
  }

  std::vector<Entry> entries_;  // a power of two places
  std::size_t mask_ = 0;        // one less
  std::size_t size_ = 0;
};

}  // namespace jaywalk
