// SPDX-License-Identifier: Apache-2.0
#include "interpreter/support/markup.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

TEST(Markup, WritesWhatTagsAndAttributesAreMadeOfAsReferences) {
  EXPECT_EQ(escaped("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
}

TEST(Markup, EscapesReferencesThemselves) { EXPECT_EQ(escaped("&amp;"), "&amp;amp;"); }

TEST(Markup, LeavesOtherTextAsItIs) {
  EXPECT_EQ(escaped("it's\n\t50 % – ½ \x01"), "it's\n\t50 % – ½ \x01");
  EXPECT_EQ(escaped(""), "");
}

TEST(MarkupOfXml, WritesWhatTagsAndAttributesAreMadeOfAsReferences) {
  EXPECT_EQ(escaped_xml("a < b & \"c\" > d"), "a &lt; b &amp; &quot;c&quot; &gt; d");
}

TEST(MarkupOfXml, KeepsLineFeedsAndTabsForTheReader) {
  EXPECT_EQ(escaped_xml("one\n\ttwo"), "one&#10;&#9;two");
}

TEST(MarkupOfXml, HasNoCharacterThatXmlForbids) {
  using namespace std::string_view_literals;
  EXPECT_EQ(escaped_xml("\0\x01\r\x1b\x1f – é"sv), "????? – é");
}

TEST(Markup, LeavesNothingInAScriptThatEndsIt) {
  EXPECT_EQ(in_script(R"(["</script>","<!--<script>","a<b"])"),
            R"(["\u003c/script>","\u003c!--\u003cscript>","a\u003cb"])");
}

TEST(Markup, KeepsPathsWholeInUris) {
  EXPECT_EQ(escaped_uri("/a-b/c_d.e~1"), "/a-b/c_d.e~1");
  EXPECT_EQ(escaped_uri("a #1?%\xC3\xA4"), "a%20%231%3F%25%C3%A4");
}

TEST(Markup, ShowsControlCharacters) {
  EXPECT_EQ(visible("a\x1b[2Jb\r\x7f\tc\n"), "a\\x1b[2Jb\\x0d\\x7f\tc\\n");
  EXPECT_EQ(visible("two\nlines", LineBreaks::kept), "two\nlines");
  EXPECT_EQ(visible("\xC2\x9B"
                    "31m \xC3\xA4 \xC2\xA0"),
            "\\x9b31m \xC3\xA4 \xC2\xA0");
  EXPECT_EQ(visible(std::string_view("\0", 1)), "\\x00");
}

TEST(Markup, LetsColoursAlonePass) {
  EXPECT_EQ(visible_with_colours("\x1b[1;31mred\x1b[0m\n"), "\x1b[1;31mred\x1b[0m\n");
  EXPECT_EQ(visible_with_colours("\x1b[2J\x1b]0;title\x07\x1b[31mx\x1b"),
            "\\x1b[2J\\x1b]0;title\\x07\x1b[31mx\\x1b");
  EXPECT_EQ(visible_with_colours("\x1b[\x1b[m"), "\\x1b[\x1b[m");
}

TEST(ShellQuoted, LeavesPlainWordsAlone) {
  for (const std::string word : {"scenarios/paper.yaml", "--seed=7", "a_b-c", "50%", "me@here"}) {
    EXPECT_EQ(shell_quoted(word), word);
  }
}

TEST(ShellQuoted, QuotesWhatAShellWouldRead) {
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("two words"), "'two words'");
  EXPECT_EQ(shell_quoted("$HOME"), "'$HOME'");
  EXPECT_EQ(shell_quoted("*"), "'*'");
  EXPECT_EQ(shell_quoted("~"), "'~'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
}

TEST(Names, OfOursAreLettersDigitsUnderscoresAndHyphens) {
  using namespace std::string_view_literals;
  for (const std::string_view name : {"proximity_25"sv, "a"sv, "7"sv, "_x"sv, "by-the-text"sv}) {
    EXPECT_TRUE(is_identifier(name)) << name;
  }
  for (const std::string_view name : {""sv, "../x"sv, "/etc/x"sv, "x\0"sv, "\x1b[2J"sv,
                                      "=HYPERLINK(1)"sv, "-1"sv, "a b"sv, "a.b"sv, "\xC3\xA4"sv}) {
    EXPECT_FALSE(is_identifier(name)) << visible(name);
  }
  EXPECT_TRUE(is_identifier(std::string(100, 'x')));
  EXPECT_FALSE(is_identifier(std::string(101, 'x')));
}

TEST(Names, OfOtherProgramsAreTextThatNoTerminalAndNoTableObeys) {
  using namespace std::string_view_literals;
  for (const std::string_view name : {"av"sv, "flow0.1"sv, "Ped #7, \"left\""sv, ":J0_1"sv,
                                      "latency=0.3"sv, "\xC3\xA4 \xC2\xA0"sv}) {
    EXPECT_TRUE(is_label(name)) << name;
  }
  for (const std::string_view name :
       {""sv, " a"sv, "=1+1"sv, "+1"sv, "-1"sv, "@x"sv, "a\0"sv, "a\tb"sv, "a\nb"sv, "\x1b[2J"sv,
        "a\x7f"sv, "a\xC2\x9B"sv, "\xFF"sv, "a\xC3"sv}) {
    EXPECT_FALSE(is_label(name)) << visible(name);
  }
  EXPECT_TRUE(is_label(std::string(200, 'x')));
  EXPECT_FALSE(is_label(std::string(201, 'x')));
}

}  // namespace
}  // namespace jaywalk
