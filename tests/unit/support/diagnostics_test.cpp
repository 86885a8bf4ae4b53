// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/diagnostics.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

SourceSpan place(const std::string& text, std::uint32_t begin, std::uint32_t end) {
  return {std::make_shared<const Source>("a.asl", text), {begin, end}};
}

std::string rendered(SourceSpan where, std::string hint = {}) {
  Diagnostics diagnostics;
  diagnostics.error(std::move(where), "expected ')'", std::move(hint));
  return diagnostics.render();
}

TEST(Diagnostics, ShowTheLineACaretAndTheHint) {
  EXPECT_EQ(rendered(place("b.\nf(abc.\n", 5, 8), "close it"),
            "a.asl:2:3: error: expected ')'\n"
            "  f(abc.\n"
            "    ^~~\n"
            "  hint: close it\n");
}

TEST(Diagnostics, PointBehindTheLastCharacter) {
  EXPECT_EQ(rendered(place("abc", 3, 3)),
            "a.asl:1:4: error: expected ')'\n"
            "  abc\n"
            "     ^\n");
}

TEST(Diagnostics, KeepTabsSoThatTheCaretIsBelowItsCharacter) {
  EXPECT_EQ(rendered(place("\tx\ty", 3, 4)),
            "a.asl:1:4: error: expected ')'\n"
            "  \tx\ty\n"
            "  \t \t^\n");
}

TEST(Diagnostics, PutTheCaretBelowCharactersOfSeveralBytes) {
  EXPECT_EQ(rendered(place("\"äöü\" x", 9, 10)),
            "a.asl:1:7: error: expected ')'\n"
            "  \"äöü\" x\n"
            "        ^\n");
}

TEST(Diagnostics, CutLongLinesAroundTheCaret) {
  const std::string text = std::string(5'000'000, 'a') + "X" + std::string(5'000'000, 'b');
  const std::string message = rendered(place(text, 5'000'000, 5'000'001));
  EXPECT_LT(message.size(), 400U);
  EXPECT_EQ(message, "a.asl:1:5000001: error: expected ')'\n  ..." + std::string(60, 'a') + "X" +
                         std::string(39, 'b') + "...\n" + std::string(65, ' ') + "^\n");
}

TEST(Diagnostics, MarkNoFurtherThanTheLine) {
  EXPECT_EQ(rendered(place("ab\ncd", 1, 5)),
            "a.asl:1:2: error: expected ')'\n"
            "  ab\n"
            "   ^\n");
}

TEST(Diagnostics, ShowNoControlCharacters) {
  EXPECT_EQ(rendered(place("a\x1b[31mb", 6, 7)),
            "a.asl:1:7: error: expected ')'\n"
            "  a?[31mb\n"
            "        ^\n");
}

TEST(Diagnostics, NameTheCodeOfAWarning) {
  Diagnostics diagnostics;
  diagnostics.warning(place("!go.", 1, 3), "unknown-goal", "no plan for '!go'");
  EXPECT_EQ(diagnostics.render(),
            "a.asl:1:2: warning: no plan for '!go' [unknown-goal]\n"
            "  !go.\n"
            "   ^~\n");
}

TEST(Diagnostics, NameTheSubjectIfThereIsNoText) {
  Diagnostics diagnostics;
  diagnostics.error("x.asl", "no such file");
  EXPECT_EQ(diagnostics.render(), "x.asl: error: no such file\n");
}

TEST(Diagnostics, PaintTheirPartsOnlyIfAsked) {
  Diagnostics diagnostics;
  diagnostics.error("x.asl", "no such file");
  EXPECT_EQ(diagnostics.render(Colour::on),
            "\x1b[1mx.asl:\x1b[0m \x1b[1;31merror:\x1b[0m \x1b[1mno such file\x1b[0m\n");
}

TEST(Diagnostics, CountWhatTheyDoNotKeep) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < Diagnostics::kLimit + 5; ++i) diagnostics.error("x", "wrong");
  EXPECT_EQ(diagnostics.items().size(), Diagnostics::kLimit);
  EXPECT_EQ(diagnostics.error_count(), Diagnostics::kLimit + 5);
  EXPECT_TRUE(diagnostics.render().ends_with("... and 5 more\n"));
}

TEST(Diagnostics, AppendOthersWithinTheLimit) {
  Diagnostics some;
  some.error("x", "wrong");
  Diagnostics others;
  for (std::size_t i = 0; i < Diagnostics::kLimit; ++i) others.error("y", "wrong");
  some.append(std::move(others));
  EXPECT_EQ(some.items().size(), Diagnostics::kLimit);
  EXPECT_EQ(some.error_count(), Diagnostics::kLimit + 1);
}

TEST(Diagnostics, ComeInTheOrderOfTheTextOnceSorted) {
  Diagnostics diagnostics;
  diagnostics.error(place("abc", 2, 3), "later");
  diagnostics.error(place("abc", 0, 1), "sooner");
  diagnostics.sort_by_place();
  EXPECT_EQ(diagnostics.items()[0].message, "sooner");
  EXPECT_EQ(diagnostics.items()[1].message, "later");
}

TEST(Diagnostics, ShowOfAVeryLongTextItsBeginAndEnd) {
  const std::string goals(1'000'000, 'g');
  Diagnostics diagnostics;
  diagnostics.error("a.asl", "begin " + goals + " end", "ä" + goals + "ö");
  const std::string text = diagnostics.render();
  EXPECT_LT(text.size(), 5'000U);
  EXPECT_EQ(text.substr(0, 23), "a.asl: error: begin ggg");
  EXPECT_NE(text.find("ggg end\n"), std::string::npos);
  EXPECT_NE(text.find("hint: ägg"), std::string::npos);
  EXPECT_NE(text.find("ggö\n"), std::string::npos);
  EXPECT_NE(text.find("bytes left out"), std::string::npos);
}

}  // namespace
}  // namespace jaywalk
