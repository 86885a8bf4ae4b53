// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/assertions/assertion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/metrics/drives.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Result<std::vector<Assertion>> parsed(const std::string& text) {
  return parse_assertions(std::make_shared<const Source>("rules.yaml", text));
}

std::string errors_of(const std::string& text) {
  const auto result = parsed(text);
  return result ? "" : result.diagnostics().render();
}

Assertion assertion(const std::string& keys) {
  auto result = parsed("assertions:\n  - {id: rule, source: test, " + keys + "}\n");
  if (!result) ADD_FAILURE() << result.diagnostics().render();
  return result ? result.value().front() : Assertion{};
}

Judgement judged(const std::string& keys, const Recording& recording) {
  const Ground ground = road();
  return judge(assertion(keys), TestView(recording, ground));
}

/// Two pedestrians at 3.25 m and 10.25 m from the middle of the AV's way, which it passes at
/// tick 1.
Recording passing() {
  return drive(
      1, {steps({0, 0}, {0, 10}, 3), steps({3.25, 10}, {0, 0}, 3), steps({10.25, 10}, {0, 0}, 3)});
}

TEST(Judge, FindsTheRoadUserWhoSuffersAndTheTick) {
  const Judgement fail = judged("precondition: true, requirement: always distance > 3", passing());
  EXPECT_EQ(fail.verdict, Verdict::fail);
  EXPECT_DOUBLE_EQ(*fail.robustness, -1);
  EXPECT_EQ(fail.tick, 1U);
  EXPECT_THAT(fail.witnesses, ElementsAre(1));
}

TEST(Judge, LeavesOutThoseForWhomThePreconditionIsNotMet) {
  const Judgement pass =
      judged("precondition: distance > 10, requirement: always distance > 3", passing());
  EXPECT_EQ(pass.verdict, Verdict::pass);
  EXPECT_DOUBLE_EQ(*pass.robustness, 6) << "of the second alone";
  EXPECT_EQ(pass.tick, std::nullopt);
  EXPECT_THAT(pass.witnesses, ElementsAre(2));
}

TEST(Judge, SaysHowNearATestCameToThePrecondition) {
  const Judgement vacuous =
      judged("precondition: eventually distance < 1.5, requirement: 'false'", passing());
  EXPECT_EQ(vacuous.verdict, Verdict::vacuous);
  EXPECT_EQ(vacuous.robustness, std::nullopt);
  EXPECT_DOUBLE_EQ(vacuous.exercised, -0.5);
  EXPECT_THAT(vacuous.witnesses, IsEmpty());
}

TEST(Judge, ADistanceOfZeroIsACollision) {
  const Recording touching = drive(1, {steps({0, 0}, {0, 10}, 2), steps({1.25, 10}, {0, 0}, 2)});
  const Judgement fail = judged("precondition: true, requirement: always closest > 0", touching);
  EXPECT_EQ(fail.verdict, Verdict::fail);
  EXPECT_EQ(*fail.robustness, 0);
}

TEST(Judge, TellsApartWhatCouldNotBeHelped) {
  const std::string rule =
      "precondition: true, requirement: always distance > 100, unavoidable: x > 5";
  const Judgement both = judged(rule, passing());
  EXPECT_EQ(both.verdict, Verdict::fail) << "the first could be helped";
  EXPECT_THAT(both.witnesses, ElementsAre(1));
  const Judgement second = judged(
      "precondition: x > 5, requirement: always distance > 100, unavoidable: x > 5", passing());
  EXPECT_EQ(second.verdict, Verdict::unavoidable);
  EXPECT_THAT(second.witnesses, ElementsAre(2));
  EXPECT_EQ(second.tick, 0U);
}

TEST(Judge, CallsNothingUnavoidableThatDidNotHappen) {
  const Judgement kept = judged(
      "precondition: x > 5, requirement: always distance > 1, unavoidable: x > 5", passing());
  EXPECT_EQ(kept.verdict, Verdict::pass);
  EXPECT_TRUE(kept.excused) << "no driver could have kept it, but this AV did";
}

TEST(Judge, AnAssertionAboutTheAvNeedsNoRoadUsers) {
  const Recording alone = drive(1, {steps({0, 0}, {0, 10}, 3)});
  EXPECT_EQ(judged("precondition: true, requirement: always av.speed <= 10", alone).verdict,
            Verdict::pass);
  EXPECT_EQ(judged("precondition: true, requirement: always distance > 0", alone).verdict,
            Verdict::vacuous);
  EXPECT_EQ(judged("precondition: true, requirement: nearest.distance > 0", alone).verdict,
            Verdict::vacuous);
  EXPECT_EQ(judged("precondition: true, requirement: forall distance > 0", alone).verdict,
            Verdict::pass);
}

TEST(Judge, NamesRoadUsersAndTheNearest) {
  EXPECT_EQ(judged("precondition: true, requirement: p2.x > 10", passing()).verdict, Verdict::pass);
  EXPECT_EQ(judged("precondition: true, requirement: p3.x > 10", passing()).verdict,
            Verdict::vacuous)
      << "there is no p3";
  EXPECT_EQ(judged("precondition: true, requirement: always nearest.x < 4", passing()).verdict,
            Verdict::pass);
}

TEST(Judge, HearsOfEvents) {
  Recording recording = passing();
  recording.add({.tick = 2, .actor = 2, .kind = "precondition", .text = {}});
  const Judgement judgement =
      judged("precondition: eventually happens(precondition), requirement: 'true'", recording);
  EXPECT_THAT(judgement.witnesses, ElementsAre(2));
  recording.add({.tick = 1, .actor = {}, .kind = "precondition", .text = {}});
  EXPECT_THAT(
      judged("precondition: eventually happens(precondition), requirement: 'true'", recording)
          .witnesses,
      ElementsAre(1, 2))
      << "what concerns the whole test concerns everybody";
}

TEST(AssertionFile, ReportsEveryMistakeWithItsPlace) {
  EXPECT_EQ(errors_of("assertions:\n"
                      "  - id: Collision\n"
                      "    source: test\n"
                      "    severity: sever\n"
                      "    precondition: >\n"
                      "      eventually in_zone\n"
                      "      and ttcc < 1\n"
                      "    requirement: \"always closest\"\n"
                      "  - id: second\n"
                      "    sauce: test\n"
                      "    precondition: true\n"),
            "rules.yaml:2:9: error: 'Collision' cannot be the id of an assertion\n"
            "    - id: Collision\n"
            "          ^~~~~~~~~\n"
            "  hint: ids are atoms, so that agents can believe them: a lower-case letter, then "
            "letters, digits and _\n"
            "rules.yaml:4:15: error: expected minor or major or critical, found 'sever'\n"
            "      severity: sever\n"
            "                ^~~~~\n"
            "rules.yaml:7:11: error: unknown signal 'ttcc'\n"
            "        and ttcc < 1\n"
            "            ^~~~\n"
            "  hint: did you mean 'ttc'?\n"
            "rules.yaml:8:26: error: expected a condition, found a number\n"
            "      requirement: \"always closest\"\n"
            "                           ^~~~~~~\n"
            "  hint: compare it with something, as in ttc <= 1\n"
            "rules.yaml:9:5: error: an assertion without 'source'\n"
            "    - id: second\n"
            "      ^\n"
            "rules.yaml:9:5: error: an assertion without 'requirement'\n"
            "    - id: second\n"
            "      ^\n"
            "rules.yaml:10:5: error: unknown key 'sauce'\n"
            "      sauce: test\n"
            "      ^~~~~\n"
            "  hint: did you mean 'source'?\n");
}

TEST(AssertionFile, RefusesWhatCannotBeMeant) {
  EXPECT_THAT(errors_of(""), HasSubstr("the file is empty"));
  EXPECT_THAT(errors_of("rules: []"), HasSubstr("unknown key 'rules'"));
  EXPECT_THAT(errors_of("assertions: []"), HasSubstr("a list of 1 to 200 assertions"));
  std::string many = "assertions:\n";
  for (int i = 0; i < 300; ++i) many += "  - {}\n";
  EXPECT_THAT(errors_of(many), HasSubstr("expected at most 200 assertions, found 300"));
  EXPECT_THAT(errors_of(many), HasSubstr("--assertions takes several files"));
  EXPECT_THAT(errors_of("assertions:\n  - id: a\n"), HasSubstr("an assertion without 'source'"));
  const std::string one = "  - {id: a, source: s, precondition: true, requirement: true}\n";
  EXPECT_THAT(errors_of("assertions:\n" + one + one),
              HasSubstr("rules.yaml:3:10: error: a second"));
  EXPECT_THAT(errors_of("assertions:\n  - {id: a, source: s, parameters: {ttc: 3}, precondition: "
                        "true, requirement: true}"),
              HasSubstr("'ttc' is a signal already"));
}

/// The examples of the reference: what stands in the first column of the section's table.
std::vector<std::string> documented_examples() {
  const auto source =
      read_source(std::string(JAYWALK_SOURCE_DIR) + "/docs/reference/assertions.md");
  std::string_view text = source.value()->text();
  text = text.substr(text.find("\n## Examples\n") + 1);
  text = text.substr(0, text.find("\n## "));
  std::vector<std::string> examples;
  for (std::size_t at = text.find("\n| `"); at != std::string_view::npos;
       at = text.find("\n| `", at + 1)) {
    const std::size_t begin = at + 4;
    examples.emplace_back(text.substr(begin, text.find('`', begin) - begin));
  }
  return examples;
}

TEST(AssertionReference, TellsWhatItsExamplesMean) {
  // At 9 m/s the AV hits a pedestrian who has come into its zone and stands there.
  const Recording hit =
      drive(1, {steps({0, 0}, {0, 9}, 4), {{-4, 11}, {-0.5, 11}, {-0.5, 11}, {-0.5, 11}}});
  // It passes one who stands on the pavement.
  const Recording passed = drive(1, {steps({0, 0}, {0, 9}, 4), steps({4, 11}, {0, 0}, 4)});
  const std::vector<std::array<Verdict, 2>> expected = {
      {Verdict::fail, Verdict::pass}, {Verdict::fail, Verdict::pass},
      {Verdict::fail, Verdict::fail}, {Verdict::pass, Verdict::pass},
      {Verdict::pass, Verdict::pass}, {Verdict::fail, Verdict::pass}};
  const std::vector<std::string> examples = documented_examples();
  ASSERT_EQ(examples.size(), expected.size());
  for (std::size_t i = 0; i < examples.size(); ++i) {
    const std::string keys = "precondition: true, requirement: '" + examples[i] + "'";
    EXPECT_EQ(judged(keys, hit).verdict, expected[i][0]) << examples[i];
    EXPECT_EQ(judged(keys, passed).verdict, expected[i][1]) << examples[i];
  }
}

/// The verdict of a shipped assertion.
Judgement shipped(std::string_view id, const Recording& recording) {
  const auto all =
      read_assertions(std::string(JAYWALK_SOURCE_DIR) + "/scenarios/assertions/crossing.yaml");
  if (!all) {
    ADD_FAILURE() << all.diagnostics().render();
    return {};
  }
  const auto found = std::ranges::find(all.value(), id, &Assertion::id);
  if (found == all.value().end()) {
    ADD_FAILURE() << "no " << id;
    return {};
  }
  const Ground ground = road();
  return judge(*found, TestView(recording, ground));
}

/// The AV at these places along the road with these speeds; a pedestrian at these places.
Recording braking(std::vector<double> y, std::vector<double> speeds, std::vector<Place> other,
                  double tick_s = 1) {
  Recording recording(tick_s,
                      {{"av", ActorKind::vehicle, 4, 2}, {"p1", ActorKind::pedestrian, 0.5, 0.5}});
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Place from = other[i == 0 ? 0 : i - 1];
    const double speed = std::hypot(other[i].x - from.x, other[i].y - from.y) / tick_s;
    recording.add(
        Scene{{0, y[i], speeds[i], std::numbers::pi / 2}, {other[i].x, other[i].y, speed, 0}});
  }
  return recording;
}

TEST(ShippedAssertions, CollisionAvoidance) {
  const Recording hit = drive(1, {steps({0, 0}, {0, 9}, 3), {{-4, 11}, {-0.5, 11}, {-0.5, 11}}});
  EXPECT_EQ(shipped("collision_avoidance", hit).verdict, Verdict::fail);
  const Recording near = drive(1, {steps({0, 0}, {0, 9}, 3), {{-4, 9}, {-2.5, 9}, {-2.5, 9}}});
  EXPECT_EQ(shipped("collision_avoidance", near).verdict, Verdict::pass);
  EXPECT_NEAR(*shipped("collision_avoidance", near).robustness, 1.25, 1e-9);
  const Recording away = drive(1, {steps({0, 0}, {0, 9}, 3), steps({-4, 9}, {0, 0}, 3)});
  EXPECT_EQ(shipped("collision_avoidance", away).verdict, Verdict::vacuous);
}

TEST(ShippedAssertions, Mitigation) {
  const std::vector<Place> standing = steps({0, 12}, {0, 0}, 3);
  EXPECT_EQ(shipped("mitigation", braking({0, 9, 11}, {9, 4, 0}, standing)).verdict, Verdict::pass);
  EXPECT_EQ(shipped("mitigation", braking({0, 9, 18}, {9, 9, 9}, standing)).verdict, Verdict::fail);
  EXPECT_EQ(shipped("mitigation", braking({0, 5, 5}, {9, 1, 0}, standing)).verdict,
            Verdict::vacuous);
}

TEST(ShippedAssertions, EmergencyBraking) {
  // Crossing at 1.39 m/s, seen 5 s before it would be hit.
  const auto crossing = [](double tick_s, std::size_t count) {
    return steps({-6.5, 47}, {1.39 * tick_s, 0}, count);
  };
  Recording driving = drive(1, {steps({0, 0}, {0, 9}, 7), crossing(1, 7)});
  EXPECT_EQ(shipped("emergency_braking", driving).verdict, Verdict::fail);
  const Recording stopping =
      braking({0, 9, 18, 27, 32, 32, 32}, {9, 9, 9, 6, 0, 0, 0}, crossing(1, 7));
  EXPECT_NE(shipped("emergency_braking", stopping).verdict, Verdict::fail);
  const Recording late = drive(1, {steps({0, 0}, {0, 9}, 3), steps({-2, 12}, {1.39, 0}, 3)});
  EXPECT_EQ(shipped("emergency_braking", late).verdict, Verdict::vacuous) << "1.1 s are too short";
}

TEST(ShippedAssertions, Avoidability) {
  const auto surprise = [](double y) {
    return drive(1,
                 {steps({0, 0}, {0, 10}, 6), {{-4, y}, {-4, y}, {0, y}, {0, y}, {0, y}, {0, y}}});
  };
  EXPECT_EQ(shipped("avoidability", surprise(40)).verdict, Verdict::fail);
  EXPECT_EQ(shipped("avoidability", surprise(24)).verdict, Verdict::unavoidable);
  EXPECT_EQ(shipped("avoidability", surprise(90)).verdict, Verdict::pass);
  // It brakes harder than that driver, and earlier.
  const Recording stops = braking({0, 10, 16, 18, 18, 18}, {10, 10, 4, 0, 0, 0},
                                  {{-4, 24}, {-4, 24}, {0, 24}, {0, 24}, {0, 24}, {0, 24}});
  EXPECT_EQ(shipped("avoidability", stops).verdict, Verdict::pass);
  EXPECT_EQ(shipped("avoidability", drive(1, {steps({0, 0}, {0, 9}, 3), steps({-4, 9}, {0, 0}, 3)}))
                .verdict,
            Verdict::vacuous);
}

TEST(ShippedAssertions, StoppingDistance) {
  // At 9 m/s it takes 12.1 m.
  EXPECT_EQ(shipped("stopping_distance", moment(9, {0, 24}, {0, 0})).verdict, Verdict::pass);
  const Recording closing = drive(1, {steps({0, 0}, {0, 9}, 3), steps({0, 31}, {0, 0}, 3)});
  EXPECT_EQ(shipped("stopping_distance", closing).verdict, Verdict::fail);
  EXPECT_EQ(shipped("stopping_distance", closing).tick, 2U) << "10.75 m are left";
}

TEST(ShippedAssertions, Comfort) {
  const std::vector<Place> aside = steps({8, 12}, {0, 0}, 3);
  EXPECT_EQ(shipped("comfort", braking({0, 9, 14}, {9, 9, 3}, aside)).verdict, Verdict::fail);
  EXPECT_EQ(shipped("comfort", braking({0, 9, 14}, {9, 9, 6}, aside)).verdict, Verdict::pass);
  const std::vector<Place> ahead = steps({0, 20}, {0, 0}, 3);
  EXPECT_EQ(shipped("comfort", braking({0, 9, 14}, {9, 9, 3}, ahead)).verdict, Verdict::vacuous)
      << "in danger it may brake as hard as it can";
}

TEST(ShippedAssertions, Recovery) {
  std::vector<Place> crossing = steps({-2, 30}, {3, 0}, 3);
  for (int i = 0; i < 9; ++i) crossing.push_back({7, 30});
  std::vector<double> y(12, 10);
  std::vector<double> speeds(12, 0.0);
  EXPECT_EQ(shipped("recovery", braking(y, speeds, crossing)).verdict, Verdict::fail);
  speeds[6] = 2;
  speeds[11] = 2;
  EXPECT_EQ(shipped("recovery", braking(y, speeds, crossing)).verdict, Verdict::pass);
  EXPECT_EQ(shipped("recovery", braking(y, speeds, steps({-2, 30}, {0, 0}, 12))).verdict,
            Verdict::vacuous)
      << "it has not left the lane";
}

TEST(ShippedAssertions, SpeedLimitAndLaneKeeping) {
  EXPECT_EQ(shipped("speed_limit", drive(1, {steps({0, 0}, {0, 9}, 3)})).verdict, Verdict::pass);
  const Judgement fast = shipped("speed_limit", drive(1, {steps({0, 0}, {0, 10}, 3)}));
  EXPECT_EQ(fast.verdict, Verdict::fail);
  EXPECT_DOUBLE_EQ(*fast.robustness, -1);
  EXPECT_EQ(shipped("lane_keeping", drive(1, {steps({0, 0}, {0, 9}, 3)})).verdict, Verdict::pass);
  EXPECT_EQ(shipped("lane_keeping", drive(1, {steps({0, 0}, {1.5, 9}, 3)})).tick, 2U);
}

}  // namespace
}  // namespace jaywalk
