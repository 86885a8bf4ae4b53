// SPDX-License-Identifier: Apache-2.0
// `run --trace`: what a run leaves in its file, line by line.

#include <set>
#include <sstream>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/helpers/folder.h"
#include "tests/helpers/run_command.h"

namespace jaywalk {
namespace {

using nlohmann::json;
using test::CommandRun;
using test::run_command;
using testing::HasSubstr;

constexpr const char* kTraced = JAYWALK_SOURCE_DIR "/scenarios/paper.yaml";

class Trace : public FolderTest {
 protected:
  /// The lines of the trace of a run of the program, which ends well.
  [[nodiscard]] std::vector<json> of_program(const std::string& program,
                                             std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"run", file("a.asl", program), "--no-check", "--trace",
                                   path("t.jsonl")};
    words.insert(words.end(), more.begin(), more.end());
    code_ = run_command(words).code;
    return lines();
  }
  [[nodiscard]] std::vector<json> of_test(std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"run", kTraced, "--trace", path("t.jsonl")};
    words.insert(words.end(), more.begin(), more.end());
    code_ = run_command(words).code;
    return lines();
  }
  [[nodiscard]] static std::vector<json> of_kind(const std::vector<json>& all,
                                                 const std::string& kind) {
    std::vector<json> found;
    for (const json& each : all) {
      if (each["kind"] == kind) found.push_back(each);
    }
    return found;
  }
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  [[nodiscard]] std::vector<json> lines() const {
    std::vector<json> all;
    std::istringstream text(this->text("t.jsonl"));
    for (std::string line; std::getline(text, line);) all.push_back(json::parse(line));
    return all;
  }

  mutable ExitCode code_ = ExitCode::internal;
};

TEST_F(Trace, BeginsWithTheProgramAndEndsWithHowItEnded) {
  const auto all = of_program("!g. +!g <- .stopMAS.", {"--seed", "7"});
  EXPECT_EQ(code(), ExitCode::success);
  EXPECT_EQ(all.front()["kind"], "run");
  EXPECT_EQ(all.front()["program"], path("a.asl"));
  EXPECT_EQ(all.front()["agents"], 1);
  EXPECT_EQ(all.front()["seed"], 7);
  EXPECT_EQ(all.back()["kind"], "end");
  EXPECT_EQ(all.back()["ended"], "stopped");
  EXPECT_EQ(all.back()["exit_code"], 0);
}

TEST_F(Trace, SaysAtWhichLimitARunEnded) {
  const auto all = of_program("!g. +!g <- !g.", {"--max-cycles", "20"});
  EXPECT_EQ(code(), ExitCode::failed);
  EXPECT_EQ(all.back()["ended"], "limit");
  EXPECT_EQ(all.back()["exit_code"], 1);
  EXPECT_THAT(all.back()["reason"].get<std::string>(), HasSubstr("20 cycles"));
}

TEST_F(Trace, OfIdleAgentsSaysSo) {
  EXPECT_EQ(of_program("b.").back()["ended"], "idle");
  EXPECT_EQ(code(), ExitCode::success);
}

TEST_F(Trace, NamesThePlanByItsLabelOrItsPlace) {
  const auto all = of_program("!g. @named +!g <- !h.\n+!h.");
  const auto plans = of_kind(all, "plan");
  ASSERT_EQ(plans.size(), 2U);
  EXPECT_EQ(plans[0]["event"], "+!g[source(self)]");
  EXPECT_THAT(plans[0]["plan"].get<std::string>(), HasSubstr("named"));
  EXPECT_EQ(plans[1]["plan"], "the plan at " + path("a.asl") + ":2");
}

TEST_F(Trace, HasMessagesWithWhatIsBoundByThen) {
  const auto all =
      of_program("v(3). !g. +!g : v(X) <- .send(a, tell, got(X)); .broadcast(tell, all(X)).");
  const auto messages = of_kind(all, "message");
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0]["to"], "a");
  EXPECT_EQ(messages[0]["performative"], "tell");
  EXPECT_EQ(messages[0]["content"], "got(3)");
  EXPECT_EQ(messages[1]["to"], "all");
  EXPECT_EQ(messages[1]["content"], "all(3)");
}

TEST_F(Trace, HasFailuresWithTheirReasons) {
  const auto failures = of_kind(of_program("!g. +!g <- .nth(5, [a], _).\n-!g."), "failure");
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_EQ(failures[0]["agent"], "a");
  EXPECT_FALSE(failures[0]["error"].get<std::string>().empty());
  EXPECT_FALSE(failures[0]["reason"].get<std::string>().empty());
}

TEST_F(Trace, CountsCyclesFromOne) {
  const auto cycles = of_kind(of_program("!g. +!g <- +a; +b."), "cycle");
  ASSERT_GE(cycles.size(), 2U);
  for (std::size_t i = 0; i < cycles.size(); ++i) EXPECT_EQ(cycles[i]["cycle"], i + 1);
}

TEST_F(Trace, IsNotWrittenWhereTheFolderIsMissing) {
  const CommandRun run =
      run_command({"run", file("a.asl", "!g. +!g <- .print(ran)."), "--trace", path("no/t.jsonl")});
  EXPECT_NE(run.code, ExitCode::success);
  EXPECT_EQ(run.output, "") << "nothing runs whose trace is lost";
  EXPECT_THAT(run.errors, HasSubstr("no/t.jsonl"));
}

TEST_F(Trace, OfATestBeginsWithTheTestAndEndsWithItsOutcome) {
  const auto all =
      of_test({"--agents", "2", "--seed", "5", "--test", "3", "--behaviour", "proximity"});
  EXPECT_EQ(code(), ExitCode::success);
  EXPECT_EQ(
      all.front(),
      json(
          {{"kind", "test"}, {"behaviour", "proximity"}, {"agents", 2}, {"test", 3}, {"seed", 5}}));
  EXPECT_EQ(all.back()["kind"], "end");
  EXPECT_TRUE(all.back()["completed"].get<bool>());
  EXPECT_EQ(all.back()["ticks"], of_kind(all, "tick").back()["tick"]);
}

TEST_F(Trace, HasEachTickOfATestOnce) {
  const auto ticks = of_kind(of_test(), "tick");
  ASSERT_GE(ticks.size(), 3U);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    EXPECT_EQ(ticks[i]["tick"].get<int>(), ticks[i - 1]["tick"].get<int>() + 1);
    EXPECT_GT(ticks[i]["time_s"].get<double>(), ticks[i - 1]["time_s"].get<double>());
  }
}

TEST_F(Trace, HasAnActionOfEachAgentThatActsInATick) {
  const auto all = of_test({"--agents", "2", "--behaviour", "random_action"});
  const auto actions = of_kind(all, "action");
  ASSERT_FALSE(actions.empty());
  std::set<std::pair<int, std::string>> seen;
  for (const json& each : actions) {
    EXPECT_TRUE(seen.emplace(each["tick"].get<int>(), each["agent"].get<std::string>()).second)
        << "an agent acts once a tick: " << each;
    EXPECT_TRUE(each["outcome"] == "done" || each["outcome"] == "failed") << each;
    EXPECT_EQ(each.contains("reason"), each["outcome"] == "failed") << each;
  }
}

TEST_F(Trace, TellsPerceptsFromOtherEvents) {
  const auto all = of_test({"--agents", "1", "--behaviour", "proximity"});
  EXPECT_FALSE(of_kind(all, "percept").empty());
  for (const json& each : of_kind(all, "percept")) {
    EXPECT_THAT(each["change"].get<std::string>(), HasSubstr("source(percept)"));
  }
  for (const json& each : of_kind(all, "event")) {
    EXPECT_THAT(each["event"].get<std::string>(), testing::Not(HasSubstr("source(percept)")));
  }
}

TEST_F(Trace, OfATestThatEndsErroredSaysWhy) {
  const auto all = of_test({"--max-cycles", "2"});
  EXPECT_EQ(code(), ExitCode::failed);
  EXPECT_FALSE(all.back()["completed"].get<bool>());
  EXPECT_THAT(all.back()["reason"].get<std::string>(), HasSubstr("2 cycles"));
}

TEST_F(Trace, IsTheSameOfTheSameSeed) {
  (void)of_test({"--seed", "4", "--agents", "3"});
  const std::string first = text("t.jsonl");
  (void)of_test({"--seed", "4", "--agents", "3"});
  EXPECT_EQ(text("t.jsonl"), first);
  (void)of_test({"--seed", "5", "--agents", "3"});
  EXPECT_NE(text("t.jsonl"), first);
}

}  // namespace
}  // namespace jaywalk
