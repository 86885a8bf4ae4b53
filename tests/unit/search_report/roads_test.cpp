// SPDX-License-Identifier: Apache-2.0
// Pictures of roads, as the page's styles show them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/report/html.h"
#include "search/report/search_page.h"
#include "search/suts/lane_keeping.h"

namespace jaywalk::search {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A test on a straight road of 170 m; the car was farthest out of its lane after 60 m.
std::string picture_of_a_failure() {
  static const LaneKeeping kModel({}, lane::drive_settings(*lane::find_controller("paper-rate")));
  TestRow row;
  row.test.input = {Form::points, {100, 10, 100, 60, 100, 110, 100, 180}};
  row.test.failed = true;
  row.test.outcome.measures.resize(kModel.measures().size());
  row.test.outcome.measures.at(*find_measure(kModel.measures(), "worst_arc_m")) = 60;
  RoadPictures pictures(kModel, 2);
  pictures.add(row, "a <test>");
  return pictures.html();
}

/// The declarations of the page's styles for a class.
std::string style_of(const std::string& name) {
  const std::string page = reporting::render_page("", "", {});
  const std::size_t begin = page.find("svg ." + name + " {");
  return begin == std::string::npos ? "" : page.substr(begin, page.find('}', begin) - begin);
}

TEST(RoadPictures, ShowTheWorstPlaceAsADotThatIsSeen) {
  const std::string picture = picture_of_a_failure();
  const std::size_t title = picture.find("<title>farthest out of the lane</title></circle>");
  ASSERT_NE(title, std::string::npos);
  const std::string begin = "class=\"";
  const std::size_t name = picture.rfind(begin, title) + begin.size();
  EXPECT_THAT(style_of(picture.substr(name, picture.find('"', name) - name)),
              AllOf(HasSubstr("fill: var("), Not(HasSubstr("transparent"))));
  // 60 m along the road: at x = 100 m and y = 70 m of a map of 200 m that is 110 wide.
  EXPECT_THAT(picture, HasSubstr("<circle cx=\"55.0\" cy=\"71.5\""));
}

TEST(RoadPictures, HaveNoDotWhereTheWorstPlaceIsNotKnown) {
  static const LaneKeeping kModel({}, lane::drive_settings(*lane::find_controller("paper-rate")));
  TestRow row;
  row.test.input = {Form::points, {100, 10, 100, 60, 100, 110, 100, 180}};
  RoadPictures pictures(kModel, 0);
  pictures.add(row, "");
  EXPECT_THAT(pictures.html(), Not(HasSubstr("<circle")));
}

}  // namespace
}  // namespace jaywalk::search
