// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/trace_file.h"

#include <numbers>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/judge/csv_line.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

Result<Recording> parsed(const std::string& text, Diagnostics& warnings) {
  return parse_trace(std::make_shared<const Source>("drive.csv", text), warnings);
}

Recording trace(const std::string& text) {
  Diagnostics warnings;
  auto result = parsed(text, warnings);
  if (!result) ADD_FAILURE() << result.diagnostics().render();
  return result ? std::move(result.value()) : Recording{};
}

std::string errors_of(const std::string& text) {
  Diagnostics warnings;
  const auto result = parsed(text, warnings);
  return result ? "" : result.diagnostics().render();
}

const std::string kHeader = "time,actor,kind,x,y\n";
/// An AV and a pedestrian at two times.
const std::string kRows =
    "0,av,vehicle,0,0\n"
    "0,p,pedestrian,4,10\n"
    "0.5,av,vehicle,0,5\n"
    "0.5,p,pedestrian,3,10\n";

TEST(Trace, HasAStateForEachActorAtEachTime) {
  const Recording recording = trace(kHeader + kRows);
  EXPECT_DOUBLE_EQ(recording.tick_s(), 0.5);
  ASSERT_EQ(recording.scenes(), 2U);
  ASSERT_EQ(recording.actors().size(), 2U);
  EXPECT_EQ(recording.actors()[1].name, "p");
  EXPECT_EQ(recording.actors()[1].kind, ActorKind::pedestrian);
  EXPECT_EQ(recording.scene(1)[0].y_m, 5);
  EXPECT_EQ(recording.scene(1)[1].x_m, 3);
}

TEST(Trace, TakesSpeedsAndHeadingsFromThePlaces) {
  const Recording recording = trace(kHeader + kRows);
  EXPECT_DOUBLE_EQ(recording.scene(1)[0].speed_mps, 10);
  EXPECT_DOUBLE_EQ(recording.scene(0)[0].speed_mps, 10) << "of the step that leads on";
  EXPECT_NEAR(recording.scene(1)[0].heading_rad, kPi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(recording.scene(1)[1].speed_mps, 2);
  EXPECT_GT(recording.tolerance(), 0) << "since places and times are rounded";
  EXPECT_NEAR(recording.scene(1)[1].heading_rad, kPi, 1e-12);
}

TEST(Trace, WhoStandsLooksWhereTheyLookedBefore) {
  const Recording recording = trace(kHeader +
                                    "0,av,vehicle,0,0\n"
                                    "1,av,vehicle,3,0\n"
                                    "2,av,vehicle,3,0\n");
  EXPECT_NEAR(recording.scene(2)[0].heading_rad, 0, 1e-12);
  EXPECT_EQ(recording.scene(2)[0].speed_mps, 0);
  const Recording still = trace(kHeader + "0,av,vehicle,0,0\n1,av,vehicle,0,0\n");
  EXPECT_NEAR(still.scene(0)[0].heading_rad, kPi / 2, 1e-12) << "along the road";
}

TEST(Trace, TakesSpeedsAndHeadingsOfTheFileWhereItHasThem) {
  const Recording recording = trace(
      "time,actor,kind,x,y,heading,speed\n"
      "0,av,vehicle,0,0,1,7\n"
      "1,av,vehicle,0,9,2,8\n");
  EXPECT_EQ(recording.scene(0)[0].heading_rad, 1);
  EXPECT_EQ(recording.scene(1)[0].speed_mps, 8);
}

TEST(Trace, HasColumnsInAnyOrderWithUnitsToo) {
  const Recording recording = trace(
      "y_m,x_m,speed_mps,kind,actor,time_s,length_m,width_m\n"
      "1,2,3,vehicle,av,0,4.5,1.8\n"
      "4,2,3,vehicle,av,1,4.5,1.8\n");
  EXPECT_EQ(recording.scene(0)[0].x_m, 2);
  EXPECT_EQ(recording.scene(0)[0].y_m, 1);
  EXPECT_EQ(recording.scene(1)[0].speed_mps, 3);
  EXPECT_EQ(recording.actors()[0].length_m, 4.5);
  EXPECT_EQ(recording.actors()[0].width_m, 1.8);
}

TEST(Trace, GivesActorsTheUsualSizeOfTheirKind) {
  const Recording recording = trace(kHeader + kRows);
  EXPECT_EQ(recording.actors()[0].length_m, size_of(ActorKind::vehicle).length_m);
  EXPECT_EQ(recording.actors()[1].width_m, kPedestrianSizeM);
}

TEST(Trace, GivesActorsTheUsualSizeWhereTheirFieldsAreEmpty) {
  const Recording recording = trace(
      "time,actor,kind,x,y,length,width,event\n"
      "0,av,vehicle,0,0,4.5,1.8,\n0,p,pedestrian,4,0,,,\n"
      "1,av,vehicle,0,1,4.5,1.8,\n1,p,pedestrian,4,0,,,\n");
  EXPECT_EQ(recording.actors()[0].length_m, 4.5);
  EXPECT_EQ(recording.actors()[1].width_m, kPedestrianSizeM);
}

TEST(Trace, PutsTheAvFirst) {
  const Recording named = trace(kHeader +
                                "0,c,vehicle,0,0\n0,av,vehicle,5,0\n"
                                "1,c,vehicle,0,1\n1,av,vehicle,5,1\n");
  EXPECT_EQ(named.actors()[0].name, "av");
  EXPECT_EQ(named.actors()[1].name, "c");
  EXPECT_EQ(named.scene(0)[0].x_m, 5);
  const Recording first_vehicle = trace(kHeader +
                                        "0,p,pedestrian,1,0\n0,c,vehicle,2,0\n0,d,vehicle,3,0\n"
                                        "1,p,pedestrian,1,1\n1,c,vehicle,2,1\n1,d,vehicle,3,1\n");
  EXPECT_EQ(first_vehicle.actors()[0].name, "c");
  EXPECT_EQ(first_vehicle.actors()[1].name, "p");
}

TEST(Trace, APedestrianCalledAvIsNotTheVehicle) {
  const Recording recording = trace(kHeader +
                                    "0,av,pedestrian,1,0\n0,c,vehicle,2,0\n"
                                    "1,av,pedestrian,1,1\n1,c,vehicle,2,1\n");
  EXPECT_EQ(recording.actors()[0].name, "c");
}

TEST(Trace, HasSeveralEventsInOneStep) {
  const Recording recording = trace(
      "time,actor,kind,x,y,event\n"
      "0,av,vehicle,0,0,\n"
      "0,p,pedestrian,4,0,\n"
      "1,av,vehicle,0,1,\n"
      "1,p,pedestrian,4,0,precondition; collision;\n");
  ASSERT_EQ(recording.events().size(), 2U);
  EXPECT_EQ(recording.events()[0].kind, "precondition");
  EXPECT_EQ(recording.events()[0].tick, 1U);
  EXPECT_EQ(recording.events()[0].actor, 1U);
  EXPECT_EQ(recording.events()[1].kind, "collision");
}

TEST(Trace, ReadsQuotesBlankLinesAndCarriageReturns) {
  const Recording recording = trace(
      "time,actor,kind,x,y\r\n"
      "\r\n"
      "0,\"a, b\",vehicle,0,0\r\n"
      "1,\"a, b\",vehicle,0,1\r\n");
  EXPECT_EQ(recording.actors()[0].name, "a, b");
  EXPECT_EQ(recording.scenes(), 2U);
}

TEST(Trace, NamesActorsAsOtherProgramsQuoteThem) {
  const Recording recording =
      trace(kHeader + "0,\"a \"\"b\"\"\",vehicle,0,0\n1,\"a \"\"b\"\"\",vehicle,0,1\n");
  EXPECT_EQ(recording.actors()[0].name, "a \"b\"");
}

TEST(Trace, DoesNotMindRoundedTimes) {
  const Recording recording = trace(kHeader +
                                    "0,av,vehicle,0,0\n0.0333,av,vehicle,0,1\n"
                                    "0.0667,av,vehicle,0,2\n0.1,av,vehicle,0,3\n");
  EXPECT_EQ(recording.scenes(), 4U);
  EXPECT_NEAR(recording.tick_s(), 0.1 / 3, 1e-9) << "of the whole drive";
}

TEST(Trace, IsReadAgainAsItWasPrinted) {
  Recording recording(0.25, {{"av", ActorKind::vehicle, 4.5, 1.75},
                             {"p1, \"walker\"", ActorKind::pedestrian, 0.5, 0.5},
                             {"s", ActorKind::signal, 0.25, 0.25}});
  recording.add(Scene{{0.1, 0, 9.7, kPi / 2}, {-3, 20, 1.39, 0.1}, {4, 30, 0, 0}});
  recording.add(Scene{{0.1, 2.4, 9.6, kPi / 2}, {-2.7, 20, 1.39, 0.1}, {4, 30, 0, 0}});
  recording.add(RecordedEvent{.tick = 1, .actor = 1, .kind = "collision", .text = {}});
  recording.add(RecordedEvent{.tick = 1, .actor = 1, .kind = "precondition", .text = {}});
  EXPECT_EQ(trace(print_trace(recording)), recording);
}

TEST(Trace, WarnsOfColumnsThatAreNotRead) {
  Diagnostics warnings;
  const auto result =
      parsed("time,actor,kind,x,y,heding\n0,av,vehicle,0,0,1\n1,av,vehicle,0,1,1\n", warnings);
  ASSERT_TRUE(result);
  EXPECT_EQ(warnings.render(),
            "drive.csv:1:21: warning: column 'heding' is not read [unknown-column]\n"
            "  time,actor,kind,x,y,heding\n"
            "                      ^~~~~~\n"
            "  hint: did you mean 'heading'?\n");
}

TEST(TraceErrors, PointAtTheField) {
  EXPECT_EQ(errors_of(kHeader + "0,av,vehicle,0,zero\n0,p,person,1,1\n"),
            "drive.csv:2:16: error: expected a number for y, found 'zero'\n"
            "  0,av,vehicle,0,zero\n"
            "                 ^~~~\n"
            "drive.csv:3:5: error: unknown kind 'person', expected vehicle, pedestrian, cyclist or "
            "signal\n"
            "  0,p,person,1,1\n"
            "      ^~~~~~\n");
}

struct Mistake {
  std::string text;
  std::string message;

  friend std::ostream& operator<<(std::ostream& out, const Mistake& mistake) {
    return out << mistake.message;
  }
};

class TraceMistakes : public testing::TestWithParam<Mistake> {};

TEST_P(TraceMistakes, AreNamed) {
  EXPECT_THAT(errors_of(GetParam().text), HasSubstr(GetParam().message)) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Each, TraceMistakes,
    testing::Values(
        Mistake{"", "drive.csv: error: is empty"}, Mistake{"\n \n", "is empty"},
        Mistake{"time,actor,kind,x,y\n", "has no row below its header"},
        Mistake{"time,actor,x\n0,av,0\n", "1:1: error: the header has no column kind, y"},
        Mistake{"time,actor,kind,x,y,x_m\n", "1:21: error: a second column 'x'"},
        Mistake{kHeader + "0,av,vehicle,0\n", "2:1: error: the row has 4 fields, the header 5"},
        Mistake{kHeader + "0,,vehicle,0,0\n", "2:3: error: '' cannot be the name of an actor"},
        Mistake{kHeader + "0,=HYPERLINK(1),vehicle,0,0\n",
                "2:3: error: '=HYPERLINK(1)' cannot be the name of an actor"},
        Mistake{kHeader + "0,a\x1b[2J,vehicle,0,0\n",
                "2:3: error: 'a\\x1b[2J' cannot be the name of an actor"},
        Mistake{"time,actor,kind,x,y,event\n0,av,vehicle,0,0,hit;@SUM(1)\n",
                "2:18: error: '@SUM(1)' cannot be the name of an event"},
        Mistake{kHeader + "x,av,vehicle,0,0\n", "expected a number for time, found 'x'"},
        Mistake{kHeader + "0,av,vehicle,1e10,0\n", "x 1e10 is not between"},
        Mistake{kHeader + "0,av,vehicle,nan,0\n", "expected a number for x, found 'nan'"},
        Mistake{kHeader + "0,av,vehicle,inf,0\n", "expected a number for x, found 'inf'"},
        Mistake{kHeader + "0,av,vehicle,1m,0\n", "expected a number for x, found '1m'"},
        Mistake{"time,actor,kind,x,y,speed\n0,av,vehicle,0,0,-1\n", "speed -1 is not between 0"},
        Mistake{"time,actor,kind,x,y,width\n0,av,vehicle,0,0,0\n", "width 0 is not between 0.001"},
        Mistake{"time,actor,kind,x,y,heading\n0,av,vehicle,0,0,\n",
                "2:18: error: expected a number for heading, found ''"},
        Mistake{"time,actor,kind,x,y,speed,event\n0,av,vehicle,0,0,,\n",
                "2:18: error: expected a number for speed, found ''"},
        Mistake{kHeader + "1,av,vehicle,0,0\n0,av,vehicle,0,0\n",
                "3:1: error: time 0 after time 1"},
        Mistake{kHeader + "0,av,vehicle,0,0\n1,av,vehicle,0,1\n3,av,vehicle,0,2\n",
                "4:1: error: the times are not evenly spaced: 2 s here, 1 s at first"},
        Mistake{kHeader + "0,av,vehicle,0,0\n0,av,vehicle,0,0\n",
                "3:3: error: a second row of av at time 0"},
        Mistake{kHeader + "0,av,vehicle,0,0\n1,av,cyclist,0,0\n",
                "3:3: error: av had another kind or size before"},
        Mistake{kHeader + "0,av,vehicle,0,0\n", "has rows of one time only"},
        Mistake{kHeader + "0,av,vehicle,0,0\n0,p,pedestrian,0,0\n1,av,vehicle,0,1\n",
                "p has no row at time 1"},
        Mistake{kHeader + "0,p,pedestrian,0,0\n1,p,pedestrian,0,1\n",
                "has no vehicle that could be the automated one"}));

std::vector<std::string> texts(std::string_view line) {
  std::vector<std::string> result;
  for (const CsvField& each : csv_fields(line)) result.push_back(each.text);
  return result;
}

TEST(CsvFields, LieBetweenCommas) {
  EXPECT_THAT(texts("a,b,,c"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(texts(""), ElementsAre(""));
  EXPECT_THAT(texts("a,"), ElementsAre("a", ""));
  EXPECT_THAT(texts(","), ElementsAre("", ""));
}

TEST(CsvFields, AreHeldTogetherByQuotes) {
  EXPECT_THAT(texts("\"a,b\",c"), ElementsAre("a,b", "c"));
  EXPECT_THAT(texts("\"say \"\"no\"\"\""), ElementsAre("say \"no\""));
  EXPECT_THAT(texts("\"open,a"), ElementsAre("open,a")) << "quotes that do not close hold the rest";
}

TEST(CsvFields, KnowWhereTheyStand) {
  const std::string_view line = "ab,\"c,d\",e";
  const auto fields = csv_fields(line);
  EXPECT_EQ(fields[1].where, "\"c,d\"");
  EXPECT_EQ(fields[1].where.data(), line.data() + 3);
  EXPECT_EQ(fields[2].where.data(), line.data() + 9);
}

}  // namespace
}  // namespace jaywalk
