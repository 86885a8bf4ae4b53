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

/// Searches a program with named inputs and signals, which is a shell script.
class ExternalSignals : public testing::Test {
 protected:
  /// `keys` replace or add others.
  static Result<SearchExperiment> read(const std::string& script, std::vector<std::string> sets) {
    const std::string text = "sut:\n  kind: external\n  command: [sh, -c, '" + script +
                             "']\n"
                             "  duration_s: 2\n"
                             "  inputs:\n    gas: {range: [0, 10], pieces: 2}\n    gain: [0, 1]\n"
                             "  signals: {speed: [0, 100], rpm: [0, 1000]}\n"
                             "  requirements:\n    slow: always speed < 50\n"
                             "    calm: always[1, 2] rpm <= 500\n"
                             "budget: {tests: 4, virtual_s: 0}\ngenerators: [random]\n";
    return parse_search(std::make_shared<const Source>("external.yaml", text),
                        {.sets = std::move(sets)});
  }

  SearchResults run(const std::string& script, std::vector<std::string> sets = {}) {
    auto experiment = read(script, std::move(sets));
    if (!experiment.ok()) {
      ADD_FAILURE() << experiment.diagnostics().render();
      return {};
    }
    errors_.clear();
    return run_searches(
        experiment.value().plan, nullptr,
        {.progress = {}, .error = [&](const auto&, auto, auto, const std::string& error) {
           errors_.push_back(error);
         }});
  }

  /// The program answers every test with this object.
  static std::string always(std::string answer) {
    for (std::size_t at = 0; (at = answer.find('"', at)) != std::string::npos; at += 2) {
      answer.insert(at, 1, '\\');
    }
    return "while read line; do echo \"" + answer + "\"; done";
  }

  std::vector<std::string> errors_;
};

TEST_F(ExternalSignals, AreJudgedByEachRequirement) {
  const SearchResults results =
      run(always(R"({"time": [0, 1, 2], "speed": [10, 40, 20], "rpm": [900, 400, 500]})"));
  ASSERT_EQ(results.runs[0].tests.size(), 4U);
  const ExecutedTest& test = results.runs[0].tests[0].test;
  ASSERT_TRUE(test.outcome.executed()) << test.outcome.error;
  // slow: 10 of up to 50; calm: 0 of up to 500, and kept, since 500 <= 500.
  const std::vector<double>& measures = test.outcome.measures;
  ASSERT_EQ(measures.size(), 5U);
  EXPECT_GT(measures[0], 0) << "the least: that of calm, which was only just kept";
  EXPECT_LT(measures[0], 1e-9);
  EXPECT_DOUBLE_EQ(measures[1], 10);
  EXPECT_DOUBLE_EQ(measures[2], 0.2);
  EXPECT_DOUBLE_EQ(measures[3], 0);
  EXPECT_FALSE(test.failed);
  EXPECT_DOUBLE_EQ(test.outcome.simulated_s, 2) << "from the first time to the last";
}

TEST_F(ExternalSignals, FailWhereOneRequirementIsViolated) {
  // speed is 50, which is not less than 50, by nothing.
  const SearchResults results =
      run(always(R"({"time": [0, 1, 2], "speed": [10, 50, 20], "rpm": [0, 0, 0], "sim_time": 7})"));
  const ExecutedTest& test = results.runs[0].tests[0].test;
  EXPECT_TRUE(test.failed);
  EXPECT_EQ(test.fitness, 1);
  EXPECT_LT(test.outcome.measures[1], 0);
  EXPECT_DOUBLE_EQ(test.outcome.measures[3], 500);
  EXPECT_DOUBLE_EQ(test.outcome.simulated_s, 7) << "sim_time counts if it is answered";
}

TEST_F(ExternalSignals, EndASearchAtItsFirstFailure) {
  const SearchResults results =
      run(always(R"({"time": [0, 1, 2], "speed": [99, 99, 99], "rpm": [0, 0, 0]})"),
          {"budget.failures=1"});
  EXPECT_EQ(results.runs[0].tests.size(), 1U);
  EXPECT_TRUE(results.complete);
}

TEST_F(ExternalSignals, AreAskedForWithTheInputsByName) {
  const SearchResults results = run(
      R"(while read line; do case $line in *\"inputs\":{\"gain\":*\"gas\":[*,*]}*\"test\":*) )"
      R"(echo "{\"time\": [0, 1], \"speed\": [0, 0], \"rpm\": [0, 0]}";; *) exit 1;; esac; done)");
  EXPECT_TRUE(errors_.empty()) << errors_.front();
  EXPECT_EQ(results.runs[0].tests.size(), 4U);
}

TEST_F(ExternalSignals, MayBeWrongInEveryWay) {
  struct Wrong {
    const char* answer;
    const char* message;
  };
  for (const Wrong& wrong : {
           Wrong{R"({"speed": [1, 2], "rpm": [1, 2]})", "there is no 'time'"},
           Wrong{R"({"time": [0, 1], "rpm": [1, 2]})", "there is no 'speed'"},
           Wrong{R"({"time": 3, "speed": [1, 2], "rpm": [1, 2]})", "'time' is no list of numbers"},
           Wrong{R"({"time": [0, 1], "speed": [1, 2, 3], "rpm": [1, 2]})",
                 "'speed' has 3 values, 'time' has 2"},
           Wrong{R"({"time": [], "speed": [], "rpm": []})", "'time' has fewer than two values"},
           Wrong{R"({"time": [0], "speed": [1], "rpm": [1]})", "'time' has fewer than two values"},
           Wrong{R"({"time": [0, 1], "speed": [1, null], "rpm": [1, 2]})",
                 "'speed' has null where"},
           Wrong{R"({"time": [0, 1], "speed": [1, true], "rpm": [1, 2]})",
                 "'speed' has true where"},
           Wrong{R"({"time": [0, 1], "speed": [1, 1e999], "rpm": [1, 2]})", ""},
           Wrong{R"({"time": [0, 1], "speed": [1, 1e300], "rpm": [1, 2]})", "'speed' has 1e+300"},
           Wrong{R"({"time": [0, 1], "speed": [1, NaN], "rpm": [1, 2]})", "expected a JSON object"},
           Wrong{R"({"time": [0, 0], "speed": [1, 1], "rpm": [1, 2]})", "'time' does not rise"},
           Wrong{R"({"time": [0, 1, 3], "speed": [1, 1, 1], "rpm": [1, 2, 3]})", "must be equal"},
           Wrong{R"({"time": [0, 1], "speed": [1, 1], "rpm": [1, 2], "sim_time": -1})", "sim_time"},
           Wrong{R"([1, 2])", "expected a JSON object"},
           Wrong{R"({"error": "no licence"})", "it says 'no licence'"},
       }) {
    const SearchResults results = run(always(wrong.answer));
    EXPECT_EQ(errors_.size(), 4U) << wrong.answer;
    if (errors_.empty()) continue;
    EXPECT_THAT(errors_[0], HasSubstr(wrong.message)) << wrong.answer;
    EXPECT_FALSE(results.runs[0].tests[0].test.failed) << wrong.answer;
  }
}

/// Refuses every other test.
constexpr auto kPicky =
    R"(i=0; while read line; do i=$((i+1)); if [ $((i % 2)) = 1 ]; )"
    R"(then echo "{\"invalid\": \"both pedals\"}"; )"
    R"(else echo "{\"time\": [0, 1], \"speed\": [60, 60], \"rpm\": [0, 0]}"; fi; done)";

TEST_F(ExternalSignals, MayRefuseInputsWhichAreNoTests) {
  const SearchResults results = run(kPicky);
  EXPECT_TRUE(errors_.empty()) << errors_.front();
  ASSERT_EQ(results.runs[0].tests.size(), 8U) << "four are executed";
  const TestRow& refused = results.runs[0].tests[0];
  EXPECT_EQ(refused.test.outcome.refused, "both pedals");
  EXPECT_FALSE(refused.test.outcome.executed());
  EXPECT_FALSE(refused.test.failed);
  EXPECT_EQ(refused.invalid, refused.candidates);
  EXPECT_EQ(results.runs[0].tests[1].invalid, 0U);
}

TEST_F(ExternalSignals, MayNotRefuseAllInputs) {
  // With its number, as 20 ms are waited for after each answer without.
  const SearchResults results =
      run(R"(while read line; do n=${line##*\"test\":}; )"
          R"(echo "{\"test\": ${n%%[!0-9]*}, \"invalid\": \"never\"}"; done)");
  EXPECT_FALSE(results.complete);
  EXPECT_THAT(
      results.trouble.render(),
      HasSubstr(
          "random, repetition 0: error: 10000 tests in a row are invalid; the last one: never"));
}

TEST_F(ExternalSignals, CostVirtualTimeUnlessTheyAreRefused) {
  const SearchResults results = run(kPicky, {"budget={tests: 0, virtual_s: 30, overhead_s: 9}"});
  EXPECT_EQ(results.runs[0].spent_s, 30) << "three tests of 1 s";
  EXPECT_TRUE(results.complete);
}

}  // namespace
}  // namespace jaywalk::search
