// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/walk.h"

#include <functional>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

/// Goes down through levels of these terms until a limit stops it; how many levels there were.
int levels_before_the_end(TermWalk& walk, const std::function<Value(int)>& term_of) {
  const int depth = walk.depth();
  if (depth > kMaxTermDepth) return depth;  // no limit has stopped it
  try {
    const TermWalk::Level level(walk, term_of(depth));
    return levels_before_the_end(walk, term_of);
  } catch (const TermTooDeep&) {
    return depth;
  }
}

Value another(int number) { return Value::number(number); }

TEST(TermWalk, EndsAtTheGreatestDepthOfTermsThatDiffer) {
  TermWalk walk;
  EXPECT_EQ(levels_before_the_end(walk, another), kMaxTermDepth);
}

TEST(TermWalk, EndsSoonWithinATermThatContainsItself) {
  for (const int length : {1, 2, 50, 300}) {
    TermWalk walk;
    const int levels =
        levels_before_the_end(walk, [&](int depth) { return another(depth % length); });
    EXPECT_LT(levels, 4 * length + 130) << length;
  }
}

TEST(TermWalk, TakesLevelsOfNoTermForNoCircle) {
  TermWalk walk;
  EXPECT_EQ(levels_before_the_end(walk, [](int) { return Value(); }), kMaxTermDepth);
}

// A term may be met again beside where it was, deeper or less deep: it shares its parts.
TEST(TermWalk, LetsPartsBeShared) {
  TermWalk walk;
  const auto go_down = [&](const auto& self, int to, int shared_at) -> void {
    if (walk.depth() == to) return;
    const bool is_shared = walk.depth() == shared_at;
    const TermWalk::Level level(walk, another(is_shared ? -1 : walk.depth()));
    self(self, to, shared_at);
  };
  for (int shared_at : {64, 65, 128, 127, 200, 64, 256, 255, 1000, 512, 70}) {
    EXPECT_NO_THROW(go_down(go_down, 1500, shared_at)) << shared_at;
  }
  // Like above, without the way back to the top.
  const auto fork = [&](const auto& self, int depth) -> void {
    const TermWalk::Level level(walk, another(walk.depth()));
    if (walk.depth() < depth) return self(self, depth);
    for (int shared_at : {150, 128, 300, 140, 256}) go_down(go_down, 400, shared_at);
  };
  EXPECT_NO_THROW(fork(fork, 100));
}

}  // namespace
}  // namespace jaywalk
