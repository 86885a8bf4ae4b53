// SPDX-License-Identifier: Apache-2.0
#pragma once

// An open-addressing hash table from hashes to row numbers, in one block of memory with eight bytes
// for each entry. Colliding entries stand in the next free place. When an entry is removed, those
// behind it move up, so that frequent changes leave no tombstones.

#include <cstdint>
#include <vector>

namespace jaywalk {

class HashIndex {
 public:
  static constexpr std::int64_t kNone = INT64_MIN;
  /// Places are numbered from about here on.
  explicit HashIndex(std::int64_t origin) : origin_(origin) {}

  /// REQUIRES: the hash is not 0; its first bits differ.
  void add(std::uint32_t hash, std::int64_t place) {
    if (3 * (taken_ + 1) > 2 * table_.size()) grow();
    put({hash, static_cast<std::int32_t>(place - origin_)});
    ++taken_;
  }
  void erase(std::uint32_t hash, std::int64_t place);
  /// Everything goes but the memory.
  void clear();
  /// The first place with a hash that is `wanted`; kNone if there is none.
  template <class Wanted>
  [[nodiscard]] std::int64_t find(std::uint32_t hash, Wanted&& wanted) const {
    if (table_.empty()) return kNone;
    for (std::size_t i = home(hash); table_[i].hash != 0; i = after(i)) {
      if (table_[i].hash == hash && wanted(origin_ + table_[i].place))
        return origin_ + table_[i].place;
    }
    return kNone;
  }

 private:
  struct Entry {
    std::uint32_t hash = 0;  // 0: free
    std::int32_t place = 0;  // counted from the origin
  };
  // The number of places is a power of two.
  [[nodiscard]] std::size_t home(std::uint32_t hash) const { return hash >> shift_; }
  [[nodiscard]] std::size_t after(std::size_t i) const { return (i + 1) & (table_.size() - 1); }
  void put(Entry entry) {
    std::size_t i = home(entry.hash);
    while (table_[i].hash != 0) i = after(i);
    table_[i] = entry;
  }
  void grow();
  void remove(std::size_t gap);

  std::int64_t origin_;
  std::vector<Entry> table_;
  std::size_t taken_ = 0;
  unsigned shift_ = 32;
};

}  // namespace jaywalk
