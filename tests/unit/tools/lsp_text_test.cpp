// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include <gtest/gtest.h>

#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {
namespace {

constexpr std::string_view kText = "a\u00E9\U0001F6B6b\r\n\nlast";  // lengths 1, 2, 4, 1 in bytes

TEST(TextPlaces, CountsLinesAndUtf16Units) {
  const TextPlaces places(kText);
  EXPECT_EQ(places.offset({0, 2}), 3U);  // before the character of two units
  EXPECT_EQ(places.offset({0, 4}), 7U);  // behind it
  EXPECT_EQ(places.position(7).unit, 4U);
  EXPECT_EQ(places.offset({2, 1}), kText.find("ast"));
  EXPECT_EQ(places.position(static_cast<std::uint32_t>(kText.find("last"))).line, 2U);
}

TEST(TextPlaces, EndsWhereLinesAndTextsEnd) {
  const TextPlaces places(kText);
  EXPECT_EQ(places.offset({0, 99}), 8U);  // before the line break of two characters
  EXPECT_EQ(places.offset({1, 99}), 10U);
  EXPECT_EQ(places.offset({99, 0}), kText.size());
  EXPECT_EQ(places.position(1000).line, 2U);
  EXPECT_EQ(places.position(1000).unit, 4U);
  EXPECT_EQ(TextPlaces("").offset({0, 1}), 0U);
}

TEST(Uris, AreThePathsOfFiles) {
  EXPECT_EQ(path_of_uri("file:///a%20b/%C3%A9.asl"), "/a b/\u00E9.asl");
  EXPECT_EQ(uri_of_path("/a b/\u00E9.asl"), "file:///a%20b/%C3%A9.asl");
  EXPECT_EQ(path_of_uri("untitled:1"), "untitled:1");
  EXPECT_EQ(uri_of_path("untitled:1"), "untitled:1");
  EXPECT_EQ(path_of_uri("file:///%"), "/%");
  EXPECT_EQ(path_of_uri("file:///%zz1"), "/%zz1");
}

TEST(Frames, AreReadOneAfterAnother) {
  std::istringstream in("Content-Length: 2\r\n\r\n{}content-length:3\nOther: x\n\n[1]");
  EXPECT_EQ(read_frame(in)->content, "{}");
  EXPECT_EQ(read_frame(in)->content, "[1]");
  EXPECT_FALSE(read_frame(in).has_value());
}

TEST(Frames, GoOnBehindABrokenOne) {
  std::istringstream in(
      "Content-Length: x\r\n\r\nContent-Length: 99999999999\r\n\r\n"
      "Content-Length: 2\r\n\r\n{}Content-Length: 9\r\n\r\n{}");
  EXPECT_TRUE(read_frame(in)->is_broken);
  EXPECT_TRUE(read_frame(in)->is_broken);
  EXPECT_EQ(read_frame(in)->content, "{}");
  EXPECT_TRUE(read_frame(in)->is_broken);  // the end comes too soon
  EXPECT_FALSE(read_frame(in).has_value());
}

}  // namespace
}  // namespace jaywalk::lsp
