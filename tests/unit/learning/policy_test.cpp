// SPDX-License-Identifier: Apache-2.0
// Policies and their files.

#include "experiment/policy/policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<LearnedPlans> kPlans{{.policy = "step", .options = {"go", "stay"}}};

Policy learned(std::string_view learner) {
  PolicyOrigin origin{
      .behaviour = "walker", .scenario = "s.yaml", .agents = 2, .seed = 7, .tests = 3};
  origin.spec.learner = learner;
  origin.spec.reward.violation = {{"avoidability", 2.5}};
  origin.curve = {{.tests = 3, .reward = 0.1, .success_pct = 100.0 / 3}};
  Policy policy(std::move(origin), kPlans);
  policy.learn("step", std::vector<Episode>{{{.features = {0.1, 1.0 / 3},
                                              .options = {0, 1},
                                              .chosen = 1,
                                              .probability = 0.5,
                                              .reward = 0.7}}});
  return policy;
}

Result<std::shared_ptr<Policy>> parsed(std::string text) {
  return parse_policy(std::make_shared<const Source>("learned.json", std::move(text)));
}

class Policies : public testing::TestWithParam<std::string_view> {};

TEST_P(Policies, ComeBackFromTheirFileAsTheyWere) {
  const Policy policy = learned(GetParam());
  const auto again = parsed(policy.text());
  ASSERT_TRUE(again.ok()) << again.diagnostics().render();
  EXPECT_EQ(again.value()->text(), policy.text());
  EXPECT_EQ(again.value()->origin().spec, policy.origin().spec);
  const std::vector<double> features{0.1, 1.0 / 3};
  EXPECT_EQ(again.value()->value("step", features), policy.value("step", features));
}

TEST_P(Policies, AreRefusedWhereTheirFileIsDamaged) {
  const std::string text = learned(GetParam()).text();
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"features\":2", "\"features\":3"},
           {"\"features\":2", "\"features\":1e99"},
           {"\"options\":[\"go\",\"stay\"]", "\"options\":[\"go\"]"},
           {"\"hidden\":32", "\"hidden\":4000000000"},
           {"\"bins\":[]", "\"bins\":[0]"},
           {"\"behaviour\":\"", "\"behaviour\":\"../"},
           {"\"options\":[\"", "\"options\":[\"\\u0000"},
           {"\"name\":\"", "\"name\":\"="},
           {"\"seed\":7", "\"seed\":1e999"},
           {"\"seed\":7", "\"seed\":-7"},
           {"\"seed\":7", "\"seed\":7.5"},
           {"\"agents\":2", "\"agents\":4294967298"},
           {"\"tests\":3", "\"tests\":1e300"},
           {"\"passes\":", "\"passes\":-1,\"was\":"},
           {"\"passes\":", "\"passes\":4000000000,\"was\":"},
           {"\"explores\":", "\"explores\":2,\"was\":"},
           {"\"halves_after\":", "\"halves_after\":0,\"was\":"},
           {"\"discount\":", "\"discount\":-1,\"was\":"},
           {"\"learner\":\"", "\"learner\":\"not-"}}) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::string damaged = text;
    damaged.replace(at, from.size(), to);
    EXPECT_FALSE(parsed(damaged).ok()) << to;
  }
  for (std::size_t length = 0; length < text.size(); length += 1 + text.size() / 97) {
    EXPECT_FALSE(parsed(text.substr(0, length)).ok()) << length;
  }
}

INSTANTIATE_TEST_SUITE_P(Learners, Policies, testing::Values("q-table", "actor-critic"),
                         [](const auto& each) {
                           return each.param == "q-table" ? "QTable" : "ActorCritic";
                         });

TEST(PolicyFile, IsPointedAtWhereItIsNoJson) {
  EXPECT_THAT(parsed("{\"jaywalk_policy\": 1,\n  oops}").diagnostics().render(),
              HasSubstr("learned.json:2:3: error: this is no JSON"));
  EXPECT_THAT(parsed("{\"jaywalk_policy\": 1e999}").diagnostics().render(),
              HasSubstr("learned.json: error: the policy has a number that is too large"));
  EXPECT_THAT(parsed("[]").diagnostics().render(), HasSubstr("no policy of version 1"));
}

TEST(PolicyFile, MayBeFromBeforeChanceBecameLessInTime) {
  nlohmann::json document = nlohmann::json::parse(learned("actor-critic").text());
  nlohmann::json& learning = document.at("learning");
  learning.at("settings").at("entropy") = 0.02;
  learning.at("settings").erase("entropy_least");
  for (nlohmann::json& part : document.at("policies")) {
    part.at("learned").erase("episodes");
    part.at("learned").erase("advantages");
  }
  const auto read = parsed(document.dump());
  ASSERT_TRUE(read.ok()) << read.diagnostics().render();
  EXPECT_THAT(read.value()->origin().spec.settings.entropy_least, testing::DoubleEq(0.02));
}

TEST(PolicyFile, HasNoWeightThatIsTooLargeForItsNetworks) {
  std::string text = learned("actor-critic").text();
  const std::size_t digit = text.find("[[[", text.find("\"learned\"")) + 3;
  text.replace(digit, text.find(',', digit) - digit, "1e300");
  EXPECT_THAT(parsed(text).diagnostics().render(), HasSubstr("the policy is damaged"));
}

TEST(Policy, SaysWhatIsNotItsOwn) {
  const Policy policy = learned("q-table");
  EXPECT_EQ(mismatch(policy, kPlans), "");
  const std::vector<LearnedPlans> others{{.policy = "step", .options = {"go", "run"}}};
  EXPECT_EQ(mismatch(policy, others),
            "the program's options are go, run of step, the policy's go, stay of step");
  EXPECT_THAT(mismatch(policy, {}), HasSubstr("the program's options are none"));
}

}  // namespace
}  // namespace jaywalk
