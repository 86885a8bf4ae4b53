// SPDX-License-Identifier: Apache-2.0
#include "env/vehicle/view_text.h"

#include <array>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace jaywalk {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::array kActors{SeenActor{.id = 1,
                                   .kind = ActorKind::pedestrian,
                                   .gap_m = 12.5,
                                   .left_m = 2,
                                   .right_m = 2.5,
                                   .speed_ahead_mps = 0,
                                   .speed_right_mps = 9e-17,
                                   .length_m = 0.5,
                                   .heading_rad = -1.5},
                         SeenActor{.id = 2, .kind = ActorKind::vehicle, .gap_m = 30}};
const std::array kLanes{SeenLane{3, 9, false}, SeenLane{9, 15, true}};
const std::array kObstacles{SeenObstacle{.gap_m = 20, .far_m = 26, .left_m = 1.5, .right_m = 3}};
const std::array kLines{StopLine{.gap_m = 20, .closed = true}};

VehicleView view() {
  return {.time_s = 0.4,
          .period_s = 0.1,
          .speed_mps = 9,
          .cruise_mps = 9,
          .left_m = 4.5,
          .right_m = 7.5,
          .lane_left_m = 3,
          .lane_right_m = 9,
          .actors = kActors,
          .stop_lines = kLines,
          .obstacles = kObstacles,
          .front_m = 12.6,
          .length_m = 4.5,
          .range_m = 100,
          .lanes = kLanes};
}

TEST(ViewText, HasEverythingThatTheVehicleSees) {
  const json expected = json::parse(R"({
    "step": 4, "test": 7, "time": 0.4, "period": 0.1, "speed": 9.0, "cruise": 9.0, "front": 12.6,
    "length": 4.5, "body": [4.5, 7.5], "lane": [3.0, 9.0], "kerb": [3.0, 15.0], "range": 100.0,
    "lanes": [{"sides": [3.0, 9.0], "oncoming": false}, {"sides": [9.0, 15.0], "oncoming": true}],
    "actors": [{"id": 1, "kind": "pedestrian", "gap": 12.5, "far": 13.0, "sides": [2.0, 2.5],
                "ahead": 0.0, "right": 0.0, "heading": -1.5},
               {"id": 2, "kind": "vehicle", "gap": 30.0, "far": 30.0, "sides": [0.0, 0.0],
                "ahead": 0.0, "right": 0.0, "heading": 0.0}],
    "obstacles": [{"gap": 20.0, "far": 26.0, "sides": [1.5, 3.0]}],
    "stop_lines": [{"gap": 20.0, "closed": true}]})");
  EXPECT_EQ(json::parse(view_text(view(), 7, 4)), expected);
}

TEST(ViewText, HasEmptyListsWhereNothingIsSeen) {
  const json seen = json::parse(view_text(VehicleView{.lane_left_m = 3, .lane_right_m = 9}, 0, 0));
  for (const char* list : {"actors", "lanes", "obstacles", "stop_lines"}) {
    EXPECT_EQ(seen.at(list), json::array()) << list;
  }
  EXPECT_EQ(seen.at("kerb"), json({3.0, 9.0}));
}

TEST(ViewText, HasOnlyTheFieldsThatAreReadAndTheStep) {
  EXPECT_EQ(json::parse(view_text(view(), 7, 4, {"stop_lines", "lane"})),
            json::parse(R"({"lane": [3.0, 9.0], "step": 4,
                            "stop_lines": [{"gap": 20.0, "closed": true}]})"));
  const json whole = json::parse(view_text(view(), 7, 4));
  EXPECT_EQ(json::parse(view_text(view(), 7, 4, all_view_fields())), whole);
  EXPECT_EQ(json::parse(view_text(view(), 7, 4, {"actors"}))["actors"], whole["actors"])
      << "the elements of a list are whole";
  EXPECT_EQ(json::parse(view_text(view(), 7, 4, {"actors.gap", "actors.id", "time"})),
            json::parse(R"({"actors": [{"gap": 12.5, "id": 1}, {"gap": 30.0, "id": 2}], "step": 4,
                            "time": 0.4})"))
      << "or have the fields that are read of them";
}

// Controllers in languages with types read a number with a point as one that may have a fraction.
TEST(ViewText, WritesNumbersTheSameWayWhateverTheirValue) {
  VehicleView odd = view();
  odd.speed_mps = -1e-12;
  odd.time_s = 1e-6;
  odd.front_m = 123456.123456789;
  odd.range_m = std::numeric_limits<double>::infinity();
  const std::string text = view_text(odd, 0, 0);
  EXPECT_THAT(text, HasSubstr(R"("speed":0.0,)"));
  EXPECT_THAT(text, HasSubstr(R"("time":0.000001})"));
  EXPECT_THAT(text, HasSubstr(R"("front":123456.123456789,)"));
  EXPECT_THAT(text, HasSubstr(R"("range":null,)"));
  EXPECT_THAT(text, Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace jaywalk
