// SPDX-License-Identifier: Apache-2.0
// Messages between an editor and the language server, as bytes.

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {
namespace {

using testing::IsEmpty;

std::vector<Frame> frames_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<Frame> frames;
  while (const auto frame = read_frame(in)) frames.push_back(*frame);
  return frames;
}

TEST(LspFrames, AreReadOneAfterAnother) {
  const auto frames = frames_of(
      "Content-Length: 2\r\n\r\n{}"
      "content-length:3\nContent-Type: x\n\n[1]");
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].content, "{}");
  EXPECT_EQ(frames[1].content, "[1]");
}

TEST(LspFrames, AreReadAgainAsTheyWereWritten) {
  std::ostringstream out;
  write_frame(out, "{\"é\": 1}");
  EXPECT_EQ(out.str(), "Content-Length: 9\r\n\r\n{\"é\": 1}") << "bytes are counted";
  EXPECT_EQ(frames_of(out.str()).at(0).content, "{\"é\": 1}");
}

TEST(LspFrames, WithoutALengthAreBroken) {
  for (const char* header : {"Content-Type: x", "Content-Length: -1", "Content-Length: 2x",
                             "Content-Length: 99999999999", "Content-Length:", "Length: 2"}) {
    const auto frames = frames_of(std::string(header) + "\r\n\r\nContent-Length: 2\r\n\r\n{}");
    ASSERT_EQ(frames.size(), 2U) << header;
    EXPECT_TRUE(frames[0].is_broken) << header;
    EXPECT_EQ(frames[1].content, "{}") << header;
  }
}

TEST(LspFrames, ThatEndTooSoonAreBroken) {
  const auto frames = frames_of("Content-Length: 10\r\n\r\n{}");
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_TRUE(frames[0].is_broken);
  EXPECT_EQ(frames[0].content, "");
  EXPECT_THAT(frames_of(""), IsEmpty());
  EXPECT_THAT(frames_of("\r\n\r\n"), IsEmpty());
}

}  // namespace
}  // namespace jaywalk::lsp
