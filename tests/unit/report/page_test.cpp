// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/html.h"

namespace jaywalk::reporting {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Page, HasItsSectionsInTheirOrderWithLinksToThem) {
  const std::array sections{PageSection{"first", "The first", "<p>one</p>"},
                            PageSection{"second", "The second", "<p>two</p>"}};
  const std::string page = render_page("report", "a title", sections);
  EXPECT_THAT(page, HasSubstr("<a href=\"#first\">The first</a>\n"
                              "<a href=\"#second\">The second</a>\n"));
  EXPECT_THAT(page, HasSubstr("<section id=\"first\">\n<h2>The first</h2>\n<p>one</p></section>"));
  EXPECT_LT(page.find("<section id=\"first\">"), page.find("<section id=\"second\">"));
}

TEST(Page, LeavesOutSectionsWithoutContent) {
  const std::array sections{PageSection{"empty", "Nothing", ""}};
  const std::string page = render_page("report", "a title", sections);
  EXPECT_THAT(page, Not(HasSubstr("Nothing")));
  EXPECT_THAT(page, Not(HasSubstr("#empty")));
}

TEST(Page, EscapesTitlesAndTakesContentAsItIs) {
  const std::array sections{PageSection{"s", "a < b", "<b>&amp;</b>"}};
  const std::string page = render_page("report", "<script>", sections);
  EXPECT_THAT(page, HasSubstr("<title>Jaywalk: &lt;script&gt;</title>"));
  EXPECT_THAT(page, HasSubstr("<h1>&lt;script&gt;</h1>"));
  EXPECT_THAT(page, HasSubstr("<h2>a &lt; b</h2>\n<b>&amp;</b>"));
}

TEST(Page, SaysWhatItIsAboveItsTitle) {
  EXPECT_THAT(render_page("a search", "t", {}), HasSubstr("<p class=\"kind\">a search</p>"));
}

TEST(Page, IsNotFilledByATitleThatLooksLikeAPlace) {
  const std::string page = render_page("report", "<!--BODY-->", {});
  EXPECT_THAT(page, HasSubstr("<h1>&lt;!--BODY--&gt;</h1>"));
}

TEST(Page, LoadsNothingFromOutside) {
  const std::string page = render_page("report", "t", {});
  for (const char* from : {"<link", "src=", "url(http", "@import"}) {
    EXPECT_THAT(page, Not(HasSubstr(from)));
  }
}

}  // namespace
}  // namespace jaywalk::reporting
