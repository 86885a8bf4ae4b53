#include "interpreter/support/markup.h"

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

}  // namespace
}  // namespace jaywalk
