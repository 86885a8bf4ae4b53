// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/containers/lazy.h"

#include <string>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(Lazy, IsMadeOnceAndOnlyIfAskedFor) {
  int made = 0;
  const Lazy<std::string> text([&made] {
    ++made;
    return std::string();
  });
  EXPECT_EQ(made, 0);
  EXPECT_EQ(*text, "");
  EXPECT_TRUE(text->empty());
  EXPECT_EQ(made, 1);
}

}  // namespace
}  // namespace jaywalk
