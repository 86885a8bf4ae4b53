// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/frame_stack.h"

#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(FrameStack, GivesTheSamePlacesAgainAfterARelease) {
  FrameStack stack;
  const FrameStack::Mark empty = stack.mark();
  std::vector<FrameStack::Mark> marks;
  std::vector<std::uint64_t*> frames;
  // Over several blocks, with frames that do not fit into the rest of one, or into any.
  for (std::size_t words : {10U, 200U, 100U, 4000U, 90U, 9000U, 5U, 4096U, 1U}) {
    marks.push_back(stack.mark());
    frames.push_back(stack.allocate(words));
    frames.back()[0] = frames.back()[words - 1] = words;
    EXPECT_TRUE(stack.contains(frames.back() + words - 1));
  }
  for (std::size_t i = frames.size(); i > 0; --i) {
    EXPECT_EQ(frames[i - 1][0],
              std::vector<std::size_t>({10, 200, 100, 4000, 90, 9000, 5, 4096, 1})[i - 1]);
    stack.release(marks[i - 1]);
    EXPECT_EQ(stack.mark() == nullptr ? frames[0] : stack.mark(),
              i == 1 ? frames[0] : marks[i - 1]);
  }
  stack.release(empty);
  EXPECT_EQ(stack.words(), 0);
  EXPECT_EQ(stack.allocate(10), frames[0]);
}

TEST(FrameStack, IsCutBackToTheBeginOfAFrame) {
  FrameStack stack;
  (void)stack.allocate(200);
  std::uint64_t* const frame = stack.allocate(100);  // in a block of its own
  (void)stack.allocate(5000);
  stack.release(frame);
  EXPECT_EQ(stack.allocate(7), frame);
}

}  // namespace
}  // namespace jaywalk
