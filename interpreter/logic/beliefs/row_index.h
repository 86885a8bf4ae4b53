// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which rows of a relation have a given key, newest first. The rows of one key form a chain: each
// knows the next older one, and a hash table knows both ends.
//
//   table:  key → newest, oldest, number of rows that are no holes, and the value they all have
//   links:  [ ... seq 7: key b, older 4 | seq 8: key a, older 5 | seq 9: key b, older 7 ]
//
// A row that is erased becomes a hole: it stays in its chain, since a walk may stand on it, until
// `skip` takes it out or it is the newest row and its place is given up. So adding, removing and
// finding the next row all take constant time, and there is one block of memory for all chains.
// Rows are counted in 32 bits from the first row that the index knew: eight bytes for a row and
// 24 for a key.

#include <cstdint>
#include <optional>
#include <vector>

#include "interpreter/support/containers/ring.h"

namespace jaywalk {

class RowIndex {
 public:
  static constexpr std::int64_t kNone = INT64_MIN;
  /// For rows that no walk is to find.
  static constexpr std::uint32_t kHoleKey = 4;

  /// The bits of a value, where rows with it have the key, but others may have it, too.
  using Bits = std::uint64_t;
  /// For values that are not compared by their bits.
  static constexpr Bits kVarious = 0;

  explicit RowIndex(std::int64_t first_seq) : first_(first_seq), origin_(first_seq) {}

  /// The newest row with a key, perhaps a hole; kNone if there is none.
  [[nodiscard]] std::int64_t newest(std::uint32_t key) const {
    const Entry* const entry = find(key);
    return entry == nullptr ? kNone : seq_of(entry->newest);
  }
  /// The next older row in the chain of a row.
  [[nodiscard]] std::int64_t older(std::int64_t seq) const { return seq_of(link(seq).older); }
  /// How many rows a key has.
  [[nodiscard]] std::size_t count(std::uint32_t key) const {
    const Entry* const entry = find(key);
    return entry == nullptr ? 0 : entry->count;
  }

  /// How many rows have a value; nothing where other rows share its key.
  [[nodiscard]] std::optional<std::size_t> count(std::uint32_t key, Bits value) const {
    const Entry* const entry = find(key);
    if (entry == nullptr || entry->count == 0) return 0;
    return entry->value == value && value != kVarious ? std::optional<std::size_t>(entry->count)
                                                      : std::nullopt;
  }

  /// A row behind the newest, or before the oldest, of all.
  void add_newest(std::uint32_t key, Bits value = kVarious);
  void add_oldest(std::uint32_t key, Bits value = kVarious);
  /// The row has become a hole.
  void erase(std::int64_t seq);
  /// The newest of all rows is a hole whose place is given up.
  void drop_newest();
  /// The holes between a row and an older one (or kNone) are left out of the chain; `newer` kNone:
  /// the older one becomes the newest.
  void skip(std::uint32_t key, std::int64_t newer, std::int64_t older);

 private:
  static constexpr std::int32_t kNoRow = INT32_MIN;
  struct Link {
    std::uint32_t key = kHoleKey;
    std::int32_t older = kNoRow;
  };
  struct Entry {
    std::uint32_t key = kFree;
    std::int32_t newest = kNoRow;
    std::int32_t oldest = kNoRow;
    std::uint32_t count = 0;
    Bits value = kVarious;  // of all rows
  };
  static constexpr std::uint32_t kFree = 6;  // no key, as kHoleKey: those are odd, or 0

  [[nodiscard]] std::int64_t seq_of(std::int32_t row) const {
    return row == kNoRow ? kNone : origin_ + row;
  }
  [[nodiscard]] std::int32_t row_of(std::int64_t seq) const {
    return seq == kNone ? kNoRow : static_cast<std::int32_t>(seq - origin_);
  }
  [[nodiscard]] const Link& link(std::int64_t seq) const {
    return links_[static_cast<std::size_t>(seq - first_)];
  }
  [[nodiscard]] Link& link(std::int64_t seq) {
    return links_[static_cast<std::size_t>(seq - first_)];
  }
  [[nodiscard]] std::size_t place(std::uint32_t key) const {
    return static_cast<std::size_t>(std::uint64_t{key} * 0x9E3779B97F4A7C15U >> 32U) &
           (table_.size() - 1);
  }
  [[nodiscard]] const Entry* find(std::uint32_t key) const;
  [[nodiscard]] Entry* find(std::uint32_t key) {
    return const_cast<Entry*>(static_cast<const RowIndex*>(this)->find(key));
  }
  Entry& entry(std::uint32_t key, Bits value);
  void grow();

  std::int64_t first_;  // the row of the first link
  std::int64_t origin_;
  Ring<Link> links_;
  std::vector<Entry> table_;  // a power of two places, at most two thirds of them taken
  std::size_t taken_ = 0;
};

}  // namespace jaywalk
