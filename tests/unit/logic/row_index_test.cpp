// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/row_index.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::int64_t> rows(const RowIndex& index, std::uint32_t key) {
  std::vector<std::int64_t> found;
  for (std::int64_t row = index.newest(key); row != RowIndex::kNone; row = index.older(row)) {
    found.push_back(row);
  }
  return found;
}

TEST(RowIndex, ListsTheRowsOfAKeyFromTheNewest) {
  RowIndex index(-2);
  for (const std::uint32_t key : {1U, 3U, 1U, RowIndex::kHoleKey, 1U}) index.add_newest(key);
  index.add_oldest(3);
  EXPECT_THAT(rows(index, 1), ElementsAre(2, 0, -2));
  EXPECT_THAT(rows(index, 3), ElementsAre(-1, -3));
  EXPECT_THAT(rows(index, 5), IsEmpty());
  EXPECT_EQ(index.count(1), 3);
}

TEST(RowIndex, LeavesOutWhatWasSkipped) {
  RowIndex index(0);
  for (int i = 0; i < 4; ++i) index.add_newest(1);
  index.erase(2);
  index.skip(1, 3, 1);
  EXPECT_THAT(rows(index, 1), ElementsAre(3, 1, 0));
  index.erase(3);
  index.drop_newest();
  EXPECT_THAT(rows(index, 1), ElementsAre(1, 0));
}

TEST(RowIndex, KeepsManyKeysApart) {
  RowIndex index(0);
  for (std::uint32_t round = 0; round < 3; ++round) {
    for (std::uint32_t key = 1; key < 2001; key += 2) index.add_newest(key);
  }
  for (std::int64_t i = 0; i < 1000; ++i) {
    const auto key = static_cast<std::uint32_t>(2 * i + 1);
    ASSERT_THAT(rows(index, key), ElementsAre(2000 + i, 1000 + i, i));
  }
}

TEST(RowIndex, CountsTheRowsOfAValueUnlessOthersShareItsKey) {
  constexpr RowIndex::Bits kValue = 70;
  constexpr RowIndex::Bits kOther = 80;
  RowIndex index(0);
  index.add_newest(1, kValue);
  index.add_newest(1, kValue);
  EXPECT_EQ(index.count(1, kValue), 2);
  EXPECT_EQ(index.count(1, kOther), std::nullopt);
  EXPECT_EQ(index.count(3, kValue), 0);
  index.erase(0);
  EXPECT_EQ(index.count(1, kValue), 1);
  index.add_newest(1, kOther);
  EXPECT_EQ(index.count(1, kValue), std::nullopt);
  EXPECT_EQ(index.count(1, kOther), std::nullopt);
}

TEST(RowIndex, CountsAgainOnceAllRowsOfAKeyHaveGone) {
  RowIndex index(0);
  index.add_newest(1, 70);
  index.add_newest(1, 80);
  index.erase(0);
  index.erase(1);
  index.add_newest(1, 80);
  EXPECT_EQ(index.count(1, 80), 1);
}

}  // namespace
}  // namespace jaywalk
