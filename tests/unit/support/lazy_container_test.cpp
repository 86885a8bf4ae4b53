// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/support/containers/lazy.h"
#include "interpreter/support/containers/ring.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LazyContainer, IsAnEmptyContainerUntilSomethingIsPutIn) {
  LazyContainer<std::vector<int>> numbers;
  EXPECT_TRUE(numbers.empty());
  EXPECT_EQ(numbers.size(), 0U);
  EXPECT_THAT(numbers, IsEmpty());
  numbers.clear();
  EXPECT_EQ(erase(numbers, 1), 0U);
  EXPECT_EQ(sizeof(numbers), sizeof(void*));
}

TEST(LazyContainer, HoldsWhatIsPutIn) {
  LazyContainer<Ring<int>> numbers;
  for (const int number : {1, 2, 3, 4}) numbers.push_back(number);
  numbers.pop_front();
  EXPECT_EQ(erase(numbers, 3), 1U);
  EXPECT_THAT(numbers, ElementsAre(2, 4));
  EXPECT_EQ(numbers.front(), 2);
  EXPECT_EQ(numbers.back(), 4);
}

TEST(LazyContainer, GivesAllAwayAtOnce) {
  LazyContainer<std::vector<int>> numbers;
  EXPECT_THAT(numbers.take(), IsEmpty());
  numbers.push_back(7);
  EXPECT_THAT(numbers.take(), ElementsAre(7));
  EXPECT_THAT(numbers, IsEmpty());
}

}  // namespace
}  // namespace jaywalk
