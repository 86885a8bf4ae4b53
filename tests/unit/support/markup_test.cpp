#include "interpreter/support/markup.h"

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

}  // namespace
}  // namespace jaywalk
