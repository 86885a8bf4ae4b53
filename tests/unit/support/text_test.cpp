// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/support/containers/flat_index.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Characters, AreCountedNotBytes) {
  EXPECT_EQ(character_count(""), 0U);
  EXPECT_EQ(character_count("abc"), 3U);
  EXPECT_EQ(character_count("aé字\U0001F6B6"), 4U);
}

TEST(Characters, BeginWithAnyByteButThoseThatGoOn) {
  const std::string_view text = "é";
  EXPECT_TRUE(begins_character(text[0]));
  EXPECT_FALSE(begins_character(text[1]));
  EXPECT_TRUE(begins_character('\0'));
}

TEST(Characters, OfNamesAreAsciiWhateverTheLocale) {
  for (int c = 0; c < 256; ++c) {
    const char byte = static_cast<char>(c);
    EXPECT_EQ(is_letter(byte), is_lower(byte) || is_upper(byte));
    EXPECT_FALSE(is_lower(byte) && is_upper(byte));
    if (c >= 128) {
      EXPECT_FALSE(is_name_character(byte)) << c;
    }
  }
  EXPECT_TRUE(is_name_character('_'));
  EXPECT_TRUE(is_name_character('0'));
  EXPECT_FALSE(is_name_character('-'));
  EXPECT_FALSE(is_letter('_'));
}

TEST(Trimmed, LosesBlanksAtBothEndsAlone) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed("a"), "a");
  EXPECT_EQ(trimmed(" \n "), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(Trimmed, IsAPartOfTheText) {
  const std::string text = "  word ";
  EXPECT_EQ(trimmed(text).data(), text.data() + 2);
}

TEST(Shortened, KeepsWhatFits) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc...");
  EXPECT_EQ(shortened("abcd", 0), "...");
  EXPECT_EQ(shortened("", 0), "");
}

TEST(Shortened, CutsNoCharacterInTwo) {
  const std::string text = "aé字b";  // 1, 2, 3 and 1 bytes
  EXPECT_EQ(shortened(text, 2), "a...");
  EXPECT_EQ(shortened(text, 3), "aé...");
  EXPECT_EQ(shortened(text, 5), "aé...");
  EXPECT_EQ(shortened(text, 6), "aé字...");
}

TEST(Lines, ArePartedByTheirBreaks) {
  EXPECT_THAT(lines_of("a\nb"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of("a\nb\n"), ElementsAre("a", "b")) << "a break at the end begins none";
  EXPECT_THAT(lines_of("\n\na"), ElementsAre("", "", "a"));
  EXPECT_THAT(lines_of("\n"), ElementsAre(""));
  EXPECT_THAT(lines_of(""), IsEmpty());
}

TEST(Lines, KeepCarriageReturns) { EXPECT_THAT(lines_of("a\r\nb"), ElementsAre("a\r", "b")); }

TEST(FlatIndex, FindsWhatWasPutIn) {
  FlatIndex<std::uint32_t> index;
  EXPECT_EQ(index.find(7), FlatIndex<std::uint32_t>::kNone) << "of an empty one";
  index.insert(7, 1);
  index.insert(0, 2);
  EXPECT_EQ(index.find(7), 1U);
  EXPECT_EQ(index.find(0), 2U);
  EXPECT_EQ(index.find(8), FlatIndex<std::uint32_t>::kNone);
}

TEST(FlatIndex, KeepsEverythingAsItGrows) {
  FlatIndex<std::uint64_t> index;
  for (std::uint32_t i = 0; i < 5000; ++i) index.insert(std::uint64_t{i} * 4096, i);
  for (std::uint32_t i = 0; i < 5000; ++i) {
    ASSERT_EQ(index.find(std::uint64_t{i} * 4096), i);
    ASSERT_EQ(index.find(std::uint64_t{i} * 4096 + 1), FlatIndex<std::uint64_t>::kNone);
  }
}

TEST(FlatIndex, ForgetsAllAtOnce) {
  FlatIndex<std::uint32_t> index;
  index.insert(7, 1);
  index.clear();
  EXPECT_EQ(index.find(7), FlatIndex<std::uint32_t>::kNone);
  index.insert(7, 3);
  EXPECT_EQ(index.find(7), 3U);
}

}  // namespace
}  // namespace jaywalk
