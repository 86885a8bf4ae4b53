// SPDX-License-Identifier: Apache-2.0
#include "experiment/report/explanation_json.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace jaywalk {
namespace {

nlohmann::json json_of(const Deliberation& deliberation) {
  return nlohmann::json::parse(explanation_json({&deliberation, 1}))[0];
}

Deliberation with_plan(TriedPlan plan) {
  Deliberation deliberation{.agent = "p1", .tick = 3, .event = "+!cross[source(self)]"};
  deliberation.plans.push_back(std::move(plan));
  return deliberation;
}

TEST(ExplanationJson, OfNothingIsAnEmptyArray) { EXPECT_EQ(explanation_json({}), "[]\n"); }

TEST(ExplanationJson, SaysWhoDeliberatedWhenAboutWhat) {
  const nlohmann::json json = json_of(with_plan({}));
  EXPECT_EQ(json["tick"], 3);
  EXPECT_EQ(json["agent"], "p1");
  EXPECT_EQ(json["event"], "+!cross[source(self)]");
  EXPECT_FALSE(json.contains("drawn"));
  EXPECT_FALSE(json.contains("hint"));
}

TEST(ExplanationJson, NamesEachStateOfAPlan) {
  using State = TriedPlan::State;
  const std::vector<std::pair<State, std::string>> names{{State::not_matching, "not matching"},
                                                         {State::not_applicable, "not applicable"},
                                                         {State::applicable, "applicable"},
                                                         {State::chosen, "chosen"},
                                                         {State::not_tried, "not tried"}};
  for (const auto& [state, name] : names) {
    const auto json =
        json_of(with_plan({.trigger = "+!cross", .where = "a.asl:4", .state = state}));
    EXPECT_EQ(json["plans"][0]["state"], name);
    EXPECT_EQ(json["plans"][0]["where"], "a.asl:4");
  }
}

TEST(ExplanationJson, SaysWhichConditionFailed) {
  TriedPlan plan{.state = TriedPlan::State::not_applicable};
  plan.asked = {{.text = "at(X,Y)", .held = true, .bindings = {{"X", "1"}, {"Y", "2"}}},
                {.text = "not near(X)", .negated = false, .held = false}};
  plan.failed = 1;
  const auto json = json_of(with_plan(plan))["plans"][0];
  EXPECT_EQ(json["failed"], 1);
  EXPECT_EQ(json["conditions"][0]["condition"], "at(X,Y)");
  EXPECT_EQ(json["conditions"][0]["held"], true);
  EXPECT_EQ(json["conditions"][0]["bindings"], nlohmann::json::parse(R"({"X":"1","Y":"2"})"));
  EXPECT_EQ(json["conditions"][1]["held"], false);
}

TEST(ExplanationJson, LeavesOutAFailureThatCannotBeTold) {
  TriedPlan plan{.state = TriedPlan::State::not_applicable};
  plan.asked = {{.text = "a"}};
  plan.failed = plan.asked.size();
  EXPECT_FALSE(json_of(with_plan(plan))["plans"][0].contains("failed"));
}

TEST(ExplanationJson, OfAPlanThatDidNotFailNamesNoFailure) {
  TriedPlan plan{.state = TriedPlan::State::chosen};
  plan.asked = {{.text = "a", .held = true}};
  plan.failed = 0;
  EXPECT_FALSE(json_of(with_plan(plan))["plans"][0].contains("failed"));
}

TEST(ExplanationJson, NamesTheRuleAndTheHintWhereThereAreAny) {
  TriedPlan plan;
  plan.asked = {{.text = "near(X)", .in_rule = true, .rule = "safe(X)", .hint = "nothing believed"},
                {.text = "b"}};
  const auto json = json_of(with_plan(plan))["plans"][0]["conditions"];
  EXPECT_EQ(json[0]["rule"], "safe(X)");
  EXPECT_EQ(json[0]["hint"], "nothing believed");
  EXPECT_FALSE(json[1].contains("rule"));
  EXPECT_FALSE(json[1].contains("hint"));
}

TEST(ExplanationJson, SaysHowAnOptionWasDrawn) {
  Deliberation deliberation = with_plan({});
  deliberation.drawn = DrawnChoice{.policy = "cross",
                                   .features = {0.5, 2},
                                   .options = {{"go", 0.75}, {"wait", 0.25}},
                                   .chosen = 1};
  const auto json = json_of(deliberation)["drawn"];
  EXPECT_EQ(json["policy"], "cross");
  EXPECT_EQ(json["features"], nlohmann::json::parse("[0.5, 2.0]"));
  EXPECT_EQ(json["options"]["go"], 0.75);
  EXPECT_EQ(json["chosen"], "wait");
}

TEST(ExplanationJson, SaysWhereBeliefsCameFrom) {
  Deliberation deliberation = with_plan({});
  deliberation.beliefs = {{"at(1,2)", "perceived in tick 3"}};
  deliberation.hint = "no plan for +!cros";
  const auto json = json_of(deliberation);
  EXPECT_EQ(json["beliefs"][0]["belief"], "at(1,2)");
  EXPECT_EQ(json["beliefs"][0]["origin"], "perceived in tick 3");
  EXPECT_EQ(json["hint"], "no plan for +!cros");
}

TEST(ExplanationJson, OfAFailureSaysWhatFailedAndWhetherTheGoalIsDropped) {
  Deliberation deliberation{.agent = "p1", .tick = 4};
  deliberation.failure = FailedFormula{.formula = "jump",
                                       .where = "a.asl:7:3",
                                       .error = "action_failed",
                                       .message = "no such action",
                                       .goals = "!cross"};
  auto json = json_of(deliberation);
  EXPECT_EQ(json["failed"], "jump");
  EXPECT_EQ(json["where"], "a.asl:7:3");
  EXPECT_EQ(json["error"], "action_failed");
  EXPECT_EQ(json["goals"], "!cross");
  EXPECT_EQ(json["dropped"], true);
  EXPECT_FALSE(json.contains("plans"));
  deliberation.failure->has_plan = true;
  EXPECT_EQ(json_of(deliberation)["dropped"], false);
}

TEST(ExplanationJson, IsWrittenOfTextsThatAreNoUnicode) {
  const nlohmann::json json = json_of(with_plan({.trigger = "+!a\xff"}));
  EXPECT_EQ(json["plans"][0]["trigger"], "+!a\xef\xbf\xbd");
}

}  // namespace
}  // namespace jaywalk
