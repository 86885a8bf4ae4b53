// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "experiment/scenario/files/program_text.h"

namespace jaywalk {
namespace {

std::uint64_t lines_of(std::string text) {
  return code_lines(std::make_shared<const Source>("test.asl", std::move(text)));
}

TEST(CodeLines, LeaveBlanksAndCommentsOut) {
  EXPECT_EQ(lines_of(""), 0U);
  EXPECT_EQ(lines_of("// nothing\n\n   \n/* a\nb\nc */\n"), 0U);
  EXPECT_EQ(lines_of("!start.  // go\n\n+!start\n  <- .print(\"// no comment\");\n"), 3U);
  EXPECT_EQ(lines_of("/* before */ a. /* behind\nstill */ b.\n"), 2U);
}

TEST(CodeLines, CountALineWithSeveralTokensOnce) { EXPECT_EQ(lines_of("a. b. c(1, 2)."), 1U); }

TEST(CodeLines, CountATokenOfSeveralLinesAsSeveral) { EXPECT_EQ(lines_of("'a\nb'."), 2U); }

}  // namespace
}  // namespace jaywalk
