// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/containers/hash_index.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

std::int64_t find(const HashIndex& index, std::uint32_t hash, std::int64_t row) {
  return index.find(hash, [row](std::int64_t candidate) { return candidate == row; });
}

TEST(HashIndex, FindsWhatWasAddedAmongEqualHashes) {
  HashIndex index(-3);
  for (std::int64_t row = -5; row < 40; ++row) index.add(7, row);
  for (std::int64_t row = -5; row < 40; ++row) EXPECT_EQ(find(index, 7, row), row);
  EXPECT_EQ(find(index, 7, 40), HashIndex::kNone);
  EXPECT_EQ(find(index, 9, 3), HashIndex::kNone);
}

TEST(HashIndex, IsEmptyAtFirst) {
  const HashIndex index(0);
  EXPECT_EQ(find(index, 1, 0), HashIndex::kNone);
}

TEST(HashIndex, KeepsTheOthersWhenSomeGo) {
  // Few hashes at both ends of the table, so that runs of entries are long and go round its end.
  std::mt19937 random(1);
  std::map<std::int64_t, std::uint32_t> rows;
  HashIndex index(0);
  for (std::int64_t row = 0; row < 20'000; ++row) {
    const auto number = static_cast<std::uint32_t>(random() % 50);
    const std::uint32_t hash = (number << 1U | 1U) - (random() % 2 == 0 ? 101U : 0U);
    if (rows.size() < 60 || random() % 2 == 0) {
      index.add(hash, row);
      rows[row] = hash;
    } else {
      const auto gone = std::next(rows.begin(), static_cast<long>(random() % rows.size()));
      index.erase(gone->second, gone->first);
      EXPECT_EQ(find(index, gone->second, gone->first), HashIndex::kNone);
      rows.erase(gone);
    }
    if (row % 500 != 0) continue;
    for (const auto& [each, its_hash] : rows) ASSERT_EQ(find(index, its_hash, each), each);
  }
}

TEST(HashIndex, TakesAFactAwayWhoseHashHasChanged) {
  HashIndex index(0);
  index.add(1, 0);
  index.add(0xFFFF'FFFFU, 1);
  index.erase(0x8000'0001U, 1);
  EXPECT_EQ(find(index, 0xFFFF'FFFFU, 1), HashIndex::kNone);
  EXPECT_EQ(find(index, 1, 0), 0);
}

TEST(HashIndex, HasNothingWhenItHasBeenCleared) {
  HashIndex index(0);
  for (std::int64_t place = 0; place < 40; ++place) index.add(0x8000'0001U, place);
  index.clear();
  EXPECT_EQ(find(index, 0x8000'0001U, 3), HashIndex::kNone);
  index.add(0x8000'0001U, 7);
  EXPECT_EQ(find(index, 0x8000'0001U, 7), 7);
}

}  // namespace
}  // namespace jaywalk
