// SPDX-License-Identifier: Apache-2.0
// Programs that misbehave in every way cost one test each, with a message that says where.

#include <chrono>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/search_experiment.h"

namespace jaywalk::search {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Searches with a shell script as the SUT, which reads a line for each test.
class ExternalSut : public testing::Test {
 protected:
  SearchResults run(const std::string& script, std::uint64_t tests = 6, double timeout_s = 5) {
    const std::string text = "sut:\n  kind: external\n  command: [sh, -c, '" + script +
                             "']\n  timeout_s: " + std::to_string(timeout_s) +
                             "\nbudget: {tests: " + std::to_string(tests) +
                             ", virtual_s: 0}\ngenerators: [random]\n";
    Result<SearchExperiment> read =
        parse_search(std::make_shared<const Source>("external.yaml", text));
    if (!read.ok()) {
      ADD_FAILURE() << read.diagnostics().render();
      return {};
    }
    return run_searches(
        read.value().plan, nullptr,
        {.progress = {},
         .error = [&](const auto&, auto, std::size_t test, const std::string& error) {
           errors_.push_back("test " + std::to_string(test) + ": " + error);
         }});
  }

  std::vector<std::string> errors_;
};

constexpr auto kAnswer = R"(echo "{\"max_oob\": 0.5, \"sim_time\": 7}")";

TEST_F(ExternalSut, AnswersTestsInJsonLines) {
  const SearchResults results = run(std::string("while read line; do ") + kAnswer + "; done");
  ASSERT_EQ(results.runs[0].tests.size(), 6U);
  for (const TestRow& row : results.runs[0].tests) {
    EXPECT_DOUBLE_EQ(row.test.fitness, 0.5);
    EXPECT_DOUBLE_EQ(row.test.outcome.simulated_s, 7);
  }
  EXPECT_TRUE(errors_.empty());
}

TEST_F(ExternalSut, MayCrash) {
  const SearchResults results = run("read line; echo out of memory >&2; kill -SEGV $$");
  EXPECT_TRUE(results.complete);
  ASSERT_EQ(errors_.size(), 6U);
  EXPECT_THAT(errors_[3], StartsWith("test 3: "));
  EXPECT_THAT(errors_[3], HasSubstr(": it died of signal 11"));
  EXPECT_THAT(errors_[3], HasSubstr("out of memory"));
}

TEST_F(ExternalSut, MayEndBeforeItAnswers) {
  run("read line; exit 3");
  ASSERT_EQ(errors_.size(), 6U);
  EXPECT_THAT(errors_[0], StartsWith("test 0: "));
  EXPECT_THAT(errors_[0], HasSubstr(": it ended with exit code 3 before it answered"));
}

// Two tests are answered by each process, the third finds it dead.
TEST_F(ExternalSut, IsStartedAnewAfterItDied) {
  const SearchResults results =
      run(std::string("read l; ") + kAnswer + "; read l; " + kAnswer + "; read l", 9);
  EXPECT_EQ(errors_.size(), 3U);
  EXPECT_TRUE(results.runs[0].tests[4].test.outcome.executed());
}

TEST_F(ExternalSut, MayHang) {
  const auto start = std::chrono::steady_clock::now();
  run("while read line; do sleep 100; done", 2, 0.2);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
  ASSERT_EQ(errors_.size(), 2U);
  EXPECT_THAT(errors_[1], StartsWith("test 1: "));
  EXPECT_THAT(errors_[1], HasSubstr(": no answer within 0.2 s"));
}

TEST_F(ExternalSut, MayAnswerNonsense) {
  run(std::string("read line; ") + kAnswer + "; read line; echo 3 bananas", 2);
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_THAT(errors_[0], StartsWith("test 1: "));
  EXPECT_THAT(errors_[0], HasSubstr(": line 2 of its output, '3 bananas': expected a JSON object"));
}

TEST_F(ExternalSut, MayLeaveTheMeasureOut) {
  run(R"(while read line; do echo "{\"max\": 1}"; done)", 1);
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_THAT(errors_[0], HasSubstr("there is no 'max_oob'"));
}

TEST_F(ExternalSut, MayAnswerNumbersThatAreNone) {
  run(R"(while read line; do echo "{\"max_oob\": 1e999}"; done)", 1);
  ASSERT_EQ(errors_.size(), 1U);
}

TEST_F(ExternalSut, MayReportAnErrorOfItsOwn) {
  run(R"(while read line; do echo "{\"error\": \"no licence\"}"; done)", 1);
  ASSERT_EQ(errors_.size(), 1U);
  EXPECT_THAT(errors_[0], HasSubstr("it says 'no licence'"));
}

TEST_F(ExternalSut, MayBeMissing) {
  const std::string text =
      "sut: {kind: external, command: [/no/such/program]}\n"
      "budget: {tests: 2, virtual_s: 0}\ngenerators: [random]\n";
  Result<SearchExperiment> read = parse_search(std::make_shared<const Source>("e.yaml", text));
  ASSERT_TRUE(read.ok());
  std::string last;
  const SearchResults results = run_searches(
      read.value().plan, nullptr,
      {.progress = {},
       .error = [&](const auto&, auto, auto, const std::string& error) { last = error; }});
  EXPECT_TRUE(results.complete);
  EXPECT_THAT(last, HasSubstr("cannot start '/no/such/program'"));
}

// Each test's answer says how many lines were read; one line too many would shift all later ones.
TEST_F(ExternalSut, MaySayMoreThanItWasAsked) {
  const SearchResults results =
      run(R"(i=0; while read line; do i=$((i+1)); echo "{\"max_oob\": 0.$i}"; )"
          R"([ $i = 2 ] && echo "{\"max_oob\": 0.9}"; done)",
          5);
  const auto& tests = results.runs[0].tests;
  ASSERT_EQ(errors_.size(), 2U) << "that of test 1, and of the process after it";
  EXPECT_THAT(errors_[0], StartsWith("test 1: "));
  EXPECT_THAT(errors_[0], HasSubstr(": line 2 of its output"));
  EXPECT_THAT(errors_[0], HasSubstr("but it also wrote '{\"max_oob\": 0.9}'"));
  EXPECT_DOUBLE_EQ(tests[0].test.fitness, 0.1);
  EXPECT_FALSE(tests[1].test.outcome.executed());
  EXPECT_DOUBLE_EQ(tests[2].test.fitness, 0.1) << "it was started anew";
}

TEST_F(ExternalSut, MayAnswerNumbersThatNobodyCanReckonWith) {
  for (const char* answer :
       {R"(\"max_oob\": 1e308)", R"(\"max_oob\": -1e13)", R"(\"max_oob\": 1e999)",
        R"(\"max_oob\": 0, \"sim_time\": 1e300)", R"(\"max_oob\": NaN)"}) {
    const SearchResults results =
        run(std::string("while read line; do echo \"{") + answer + "}\"; done", 2);
    EXPECT_EQ(errors_.size(), 2U) << answer;
    EXPECT_FALSE(results.runs[0].tests[0].test.outcome.executed()) << answer;
    errors_.clear();
  }
}

TEST_F(ExternalSut, MayAnswerAnotherTest) {
  run(R"(while read line; do echo "{\"test\": 7, \"max_oob\": 0.5}"; done)", 2);
  ASSERT_EQ(errors_.size(), 2U);
  EXPECT_THAT(errors_[1], HasSubstr("it answers test 7, expected 1"));
}

TEST_F(ExternalSut, GetsTheTestsNumberOfTheStore) {
  const SearchResults results = run(
      R"(while read line; do n=${line##*\"test\":}; echo "{\"test\": ${n%%[!0-9]*}, \"max_oob\": 0}"; done)",
      3);
  EXPECT_TRUE(errors_.empty()) << errors_.front();
  EXPECT_TRUE(results.runs[0].tests[2].test.outcome.executed());
}

}  // namespace
}  // namespace jaywalk::search
