#include "interpreter/logic/beliefs/fact_index.h"

#include <map>
#include <random>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

std::int64_t find(const FactIndex& index, std::uint32_t hash, std::int64_t row) {
  return index.find(hash, [row](std::int64_t candidate) { return candidate == row; });
}

TEST(FactIndex, FindsWhatWasAddedAmongEqualHashes) {
  FactIndex index(-3);
  for (std::int64_t row = -5; row < 40; ++row) index.add(7, row);
  for (std::int64_t row = -5; row < 40; ++row) EXPECT_EQ(find(index, 7, row), row);
  EXPECT_EQ(find(index, 7, 40), FactIndex::kNone);
  EXPECT_EQ(find(index, 9, 3), FactIndex::kNone);
}

TEST(FactIndex, IsEmptyAtFirst) {
  const FactIndex index(0);
  EXPECT_EQ(find(index, 1, 0), FactIndex::kNone);
}

TEST(FactIndex, KeepsTheOthersWhenSomeGo) {
  // Few hashes at both ends of the table, so that runs of entries are long and go round its end.
  std::mt19937 random(1);
  std::map<std::int64_t, std::uint32_t> rows;
  FactIndex index(0);
  for (std::int64_t row = 0; row < 20'000; ++row) {
    const auto number = static_cast<std::uint32_t>(random() % 50);
    const std::uint32_t hash = (number << 1U | 1U) - (random() % 2 == 0 ? 101U : 0U);
    if (rows.size() < 60 || random() % 2 == 0) {
      index.add(hash, row);
      rows[row] = hash;
    } else {
      const auto gone = std::next(rows.begin(), static_cast<long>(random() % rows.size()));
      index.erase(gone->second, gone->first);
      EXPECT_EQ(find(index, gone->second, gone->first), FactIndex::kNone);
      rows.erase(gone);
    }
    if (row % 500 != 0) continue;
    for (const auto& [each, its_hash] : rows) ASSERT_EQ(find(index, its_hash, each), each);
  }
}

TEST(FactIndex, TakesAFactAwayWhoseHashHasChanged) {
  FactIndex index(0);
  index.add(1, 0);
  index.add(0xFFFF'FFFFU, 1);
  index.erase(0x8000'0001U, 1);
  EXPECT_EQ(find(index, 0xFFFF'FFFFU, 1), FactIndex::kNone);
  EXPECT_EQ(find(index, 1, 0), 0);
}

}  // namespace
}  // namespace jaywalk
