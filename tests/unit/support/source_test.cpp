// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <jaywalk/diagnostics.h>

namespace jaywalk {
namespace {

TEST(Source, CountsLinesAndColumnsFromOne) {
  const Source source("a.asl", "one\ntwo three\n\nfour");
  struct Row {
    std::uint32_t offset, line, column;
  };
  for (const auto& [offset, line, column] :
       {Row{0, 1, 1}, Row{3, 1, 4}, Row{4, 2, 1}, Row{8, 2, 5}, Row{14, 3, 1}, Row{19, 4, 5}}) {
    EXPECT_EQ(source.position(offset).line, line) << offset;
    EXPECT_EQ(source.position(offset).column, column) << offset;
  }
}

TEST(Source, CountsCharactersNotBytes) {
  const Source source("a.asl", "\"ä€😀\" x");
  EXPECT_EQ(source.position(static_cast<std::uint32_t>(source.text().find('x'))).column, 7U);
}

TEST(Source, TakesAnOffsetBehindItsEndForTheEnd) {
  const Source source("a.asl", "ab");
  EXPECT_EQ(source.position(1000).column, 3U);
  EXPECT_EQ(source.text({1, 1000}), "b");
  EXPECT_EQ(source.text({500, 1000}), "");
}

TEST(Source, GivesLinesWithoutTheirBreaks) {
  const Source source("a.asl", "one\r\ntwo\n");
  EXPECT_EQ(source.line(1), "one");
  EXPECT_EQ(source.line(2), "two");
  EXPECT_EQ(source.line(3), "");
  EXPECT_EQ(source.line(4), "");
  EXPECT_EQ(source.line(0), "");
}

TEST(Source, MayBeEmpty) {
  const Source source("a.asl", "");
  EXPECT_EQ(source.position(0).line, 1U);
  EXPECT_EQ(source.position(0).column, 1U);
  EXPECT_EQ(source.line(1), "");
}

TEST(Source, CountsCharactersOfVeryLongLines) {
  std::string text = "ä\n";
  for (int i = 0; i < 3000; ++i) text += i % 3 == 0 ? "ö" : "o";
  const Source source("a.asl", text);
  std::uint32_t column = 0;
  for (std::uint32_t offset = 3; offset < text.size(); ++offset) {
    const bool begins = (static_cast<unsigned char>(text[offset]) & 0xC0U) != 0x80U;
    if (!begins) continue;
    ASSERT_EQ(source.position(offset).column, ++column) << offset;
    ASSERT_EQ(source.position(offset).line, 2U);
  }
}

}  // namespace
}  // namespace jaywalk
