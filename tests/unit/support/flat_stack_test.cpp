// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/containers/flat_stack.h"

#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

FlatStack<int> numbers_below(int count) {
  FlatStack<int> stack;
  for (int i = 0; i < count; ++i) stack.push_back(i);
  return stack;
}

TEST(FlatStack, HasWhatWasPutOnItWhenItGrows) {
  const FlatStack<int> stack = numbers_below(1000);
  ASSERT_EQ(stack.size(), 1000U);
  EXPECT_EQ(stack.data()[0], 0);
  EXPECT_EQ(stack.data()[999], 999);
}

TEST(FlatStack, GivesBackTheLastFirst) {
  FlatStack<int> stack = numbers_below(3);
  EXPECT_EQ(stack.take_back(), 2);
  EXPECT_EQ(stack.take_back(), 1);
  EXPECT_EQ(stack.size(), 1U);
}

TEST(FlatStack, TellsWhatHasComeSince) {
  const FlatStack<int> stack = numbers_below(5);
  const auto since = stack.since(3);
  EXPECT_EQ(std::vector<int>(since.begin(), since.end()), (std::vector{3, 4}));
  EXPECT_TRUE(stack.since(5).empty());
}

TEST(FlatStack, TakesSomeOutOfWhatHasComeSince) {
  FlatStack<int> stack = numbers_below(10);
  stack.erase_if(4, [](int each) { return each % 2 == 0; });
  EXPECT_EQ(std::vector<int>(stack.begin(), stack.end()), (std::vector{0, 1, 2, 3, 5, 7, 9}));
}

TEST(FlatStack, LeavesNothingInWhatItWasMovedFrom) {
  FlatStack<int> stack = numbers_below(5);
  FlatStack<int> taken = std::move(stack);
  stack = FlatStack<int>();
  stack.push_back(1);
  EXPECT_EQ(stack.size(), 1U);
  EXPECT_EQ(taken.size(), 5U);
}

TEST(FlatStack, CopiesWhatItHas) {
  FlatStack<int> stack = numbers_below(5);
  const FlatStack<int> copy = stack;
  stack.cut(1);
  EXPECT_EQ(copy.size(), 5U);
  EXPECT_EQ(copy.data()[4], 4);
}

}  // namespace
}  // namespace jaywalk
