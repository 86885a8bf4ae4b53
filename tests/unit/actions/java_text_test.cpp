// SPDX-License-Identifier: Apache-2.0
#include "interpreter/actions/java/java_text.h"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace jaywalk::actions {
namespace {

TEST(JavaText, CountsUnitsOfUtf16) {
  EXPECT_EQ(utf16_length("abc"), 3U);
  EXPECT_EQ(utf16_length("\u00e4\u20ac"), 2U);
  EXPECT_EQ(utf16_length("\U0001F600"), 2U);
  EXPECT_EQ(utf16_slice("a\u00e4b", 1, 2), "\u00e4");
  EXPECT_EQ(utf16_slice("ab", 1, 9), "b");
}

TEST(JavaText, TakesBrokenBytesForThemselves) {
  std::size_t size = 0;
  EXPECT_EQ(character_at("\xC3", 0, size), 0xC3U);
  EXPECT_EQ(size, 1U);
  EXPECT_EQ(character_at("\xE2\x82", 0, size), 0xE2U);
  EXPECT_EQ(upper_case_text("\xFF").empty(), false);
}

TEST(JavaText, NarrowsToInt) {
  EXPECT_EQ(java_int(2.9), 2);
  EXPECT_EQ(java_int(-2.9), -2);
  EXPECT_EQ(java_int(1e20), INT32_MAX);
  EXPECT_EQ(java_int(std::nan("")), 0);
}

}  // namespace
}  // namespace jaywalk::actions
