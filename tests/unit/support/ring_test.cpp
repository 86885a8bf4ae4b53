// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/containers/ring.h"

#include <deque>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::ElementsAre;

TEST(Ring, GivesBackInTheOrderOfArrival) {
  Ring<std::string> ring;
  for (const char* const text : {"a", "b", "c"}) ring.push_back(text);
  EXPECT_EQ(ring.front(), "a");
  ring.pop_front();
  EXPECT_THAT(ring, ElementsAre("b", "c"));
}

TEST(Ring, GrowsWhereverItsBeginningIs) {
  Ring<int> ring;
  std::deque<int> like;
  for (int i = 0; i < 1000; ++i) {
    ring.push_back(i);
    like.push_back(i);
    if (i % 3 == 0) {
      ring.pop_front();
      like.pop_front();
    }
    if (i % 7 == 0) {
      ring.push_front(-i);
      like.push_front(-i);
    }
  }
  EXPECT_THAT(ring, testing::ElementsAreArray(like));
}

TEST(Ring, InsertsInTheMiddle) {
  Ring<int> ring;
  for (const int i : {1, 2, 4}) ring.push_back(i);
  ring.insert(ring.begin() + 2, 3);
  EXPECT_THAT(ring, ElementsAre(1, 2, 3, 4));
}

TEST(Ring, LosesWhatIsErased) {
  Ring<int> ring;
  for (int i = 0; i < 10; ++i) ring.push_back(i);
  EXPECT_EQ(erase_if(ring, [](int i) { return i % 2 == 0; }), 5U);
  EXPECT_EQ(erase(ring, 5), 1U);
  EXPECT_THAT(ring, ElementsAre(1, 3, 7, 9));
}

TEST(Ring, OwnsNothingAtFirst) { EXPECT_LE(sizeof(Ring<std::string>), 5 * sizeof(void*)); }

}  // namespace
}  // namespace jaywalk
