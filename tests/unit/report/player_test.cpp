// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/player/player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A pavement, two rows of lane, three cells of 2 m.
GroundPlan small_plan() {
  GroundPlan plan{.grid = {3, 3}, .cell_m = 2};
  plan.bands = {{AreaKind::pavement, 1}, {AreaKind::lane, 2}};
  plan.cells.assign(9, Surface::lane);
  for (std::size_t i = 0; i < 3; ++i) plan.cells[i] = Surface::pavement;
  return plan;
}

/// The data of the page's script.
nlohmann::json data_of(const std::string& page) {
  const std::size_t begin = page.find("{\"actors\"");
  const std::size_t end = page.find('\n', begin);
  const std::string text = page.substr(begin, page.rfind('}', end) + 1 - begin);
  return nlohmann::json::parse(text);
}

nlohmann::json played(const Recording& recording, const GroundPlan& plan = small_plan(),
                      const std::optional<Recording>& twin = {}) {
  return data_of(render_player("a test", plan, recording, MindRecorder(), twin));
}

TEST(Player, HasTheStateOfEachActorAtEachTick) {
  const auto data = played(drive(0.5, {{{1, 2}, {1, 4}}, {{3, 3}, {3.00049, 3}}}));
  EXPECT_EQ(data["tick_s"], 0.5);
  EXPECT_EQ(data["scenes"].size(), 2U);
  EXPECT_EQ(data["scenes"][0][0][0], 1.0);
  EXPECT_EQ(data["scenes"][1][0][1], 4.0);
  EXPECT_EQ(data["scenes"][0][0][2], 4.0) << "m/s";
  EXPECT_EQ(data["scenes"][1][1][0], 3.0) << "to a millimetre";
}

TEST(Player, HasTheActorsWithTheirBoxes) {
  const auto data = played(drive(1, {{{1, 2}}, {{3, 3}}}));
  EXPECT_EQ(data["actors"][0]["name"], "av");
  EXPECT_EQ(data["actors"][0]["kind"], "vehicle");
  EXPECT_EQ(data["actors"][1]["kind"], "pedestrian");
  EXPECT_EQ(data["actors"][1]["length_m"], 0.5);
}

TEST(Player, HasTheBandsOfTheGround) {
  const auto data = played(drive(1, {{{1, 2}}}))["world"];
  EXPECT_EQ(data["rows"], 3);
  EXPECT_EQ(data["cells"], 3);
  EXPECT_EQ(data["cell_m"], 2.0);
  EXPECT_EQ(data["bands"],
            nlohmann::json::parse(R"([{"kind":"pavement","rows":1},{"kind":"lane","rows":2}])"));
  EXPECT_TRUE(data["patches"].empty());
}

TEST(Player, HasWhatLiesOnTheBandsAsStretches) {
  GroundPlan plan = small_plan();
  plan.cells[4] = plan.cells[5] = Surface::crosswalk;  // row 1, cells 1 and 2
  plan.cells[0] = Surface::blocked;                    // row 0, cell 0
  const auto data = played(drive(1, {{{1, 2}}}), plan)["world"];
  EXPECT_EQ(data["patches"],
            nlohmann::json::parse(R"([["blocked", 0, 0, 1, 1], ["crosswalk", 1, 1, 1, 2]])"));
}

TEST(Player, HasEventsWithTheirActorsIfTheyConcernOne) {
  Recording recording = drive(1, {{{1, 2}, {1, 4}}, {{3, 3}, {3, 3}}});
  recording.add(RecordedEvent{.tick = 1, .actor = 1, .kind = "collision", .text = "2 m/s"});
  recording.add(RecordedEvent{.tick = 1, .kind = "end"});
  const auto events = played(recording)["events"];
  EXPECT_EQ(events[0],
            nlohmann::json::parse(R"({"tick":1,"kind":"collision","text":"2 m/s","actor":1})"));
  EXPECT_FALSE(events[1].contains("actor"));
}

TEST(Player, ShowsTheTwinBehind) {
  const Recording recording = drive(1, {{{1, 2}, {1, 4}}});
  const Recording twin = drive(1, {{{1, 2}, {1, 3}}});
  EXPECT_EQ(played(recording, small_plan(), twin)["twin"][1][0][1], 3.0);
  EXPECT_TRUE(played(recording)["twin"].empty());
}

TEST(Player, KeepsTextsFromEndingTheScript) {
  const std::string page = render_player("</script><script>alert(1)</script>", small_plan(),
                                         drive(1, {{{1, 2}}}), MindRecorder());
  EXPECT_THAT(page, Not(HasSubstr("</script><script>alert")));
  EXPECT_EQ(data_of(page)["title"], "</script><script>alert(1)</script>");
}

TEST(Player, IsWrittenOfTitlesThatAreNoUnicode) {
  const std::string page =
      render_player("test \xff", small_plan(), drive(1, {{{1, 2}}}), MindRecorder());
  EXPECT_EQ(data_of(page)["title"], "test \xef\xbf\xbd");
}

}  // namespace
}  // namespace jaywalk
