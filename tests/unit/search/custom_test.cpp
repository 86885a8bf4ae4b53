// SPDX-License-Identifier: Apache-2.0
// Searches that a program describes: systems of its own.

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <jaywalk/search.h>

namespace jaywalk::search {
namespace {

using testing::Each;
using testing::Field;
using testing::HasSubstr;

class Answering final : public SystemExecutor {
 public:
  explicit Answering(SystemOutcome answer) : answer_(std::move(answer)) {}
  [[nodiscard]] SystemOutcome run(std::span<const double> /*input*/,
                                  std::size_t /*test*/) override {
    return answer_;
  }

 private:
  SystemOutcome answer_;
};

// A system of one number that gives the same outcome for each input.
SearchDescription described(const SystemOutcome& outcome) {
  return {.name = "mine",
          .system = {.name = "mine",
                     .measures = {"harm"},
                     .why_invalid = {},
                     .make_executor = [outcome] { return std::make_unique<Answering>(outcome); }},
          .measure = "harm",
          .generators = {"random"},
          .custom_generators = {},
          .tests = 5};
}

std::vector<FoundTest> tests_of(const SystemOutcome& outcome) {
  const auto search = RunnableSearch::make(described(outcome));
  if (!search) return {};
  const auto report = search.value().run();
  return report ? report.value().runs.front().tests : std::vector<FoundTest>{};
}

TEST(SearchOfAProgram, ChargesAndJudgesWhatItsSystemMeasures) {
  const std::vector<FoundTest> tests = tests_of({.simulated_s = 5, .measures = {0.97}});
  ASSERT_EQ(tests.size(), 5U);
  EXPECT_THAT(tests, Each(Field(&FoundTest::fitness, 0.97)));
  EXPECT_THAT(tests, Each(Field(&FoundTest::has_failed, true)));
  EXPECT_THAT(tests, Each(Field(&FoundTest::simulated_s, 5)));
}

TEST(SearchOfAProgram, HasNoResultOfAnAbsurdOutcome) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [outcome, why] : {
           std::pair<SystemOutcome, std::string>{{.simulated_s = nan, .measures = {1}},
                                                 "simulated_s is not a number of seconds"},
           {{.simulated_s = -1, .measures = {1}}, "simulated_s is not a number of seconds"},
           {{.simulated_s = 1e9, .measures = {1}}, "a test of more than"},
           {{.measures = {nan}}, "'harm' is not a number"},
           {{.measures = {1e13}}, "'harm' is beyond 1e+12"},
           {{.measures = {}}, "0 measures instead of 1"},
           {{.measures = {1, 2}}, "2 measures instead of 1"},
           {{.error = "it crashed", .measures = {nan}}, "it crashed"},
       }) {
    const std::vector<FoundTest> tests = tests_of(outcome);
    ASSERT_EQ(tests.size(), 5U) << why;
    EXPECT_THAT(tests, Each(Field(&FoundTest::error, HasSubstr(why))));
    EXPECT_THAT(tests, Each(Field(&FoundTest::has_failed, false)));
  }
}

TEST(SearchOfAProgram, RefusesNumbersOutOfTheirRange) {
  const SearchDescription right = described({.measures = {1}});
  ASSERT_TRUE(RunnableSearch::make(right));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refusal = [&](auto change) {
    SearchDescription wrong = right;
    change(wrong);
    return RunnableSearch::make(wrong).diagnostics().render();
  };
  using D = SearchDescription;
  EXPECT_THAT(refusal([&](D& d) { d.harmless = nan; }), HasSubstr("'harmless' or 'worst'"));
  EXPECT_THAT(refusal([&](D& d) { d.worst = d.harmless; }), HasSubstr("the same value"));
  EXPECT_THAT(refusal([&](D& d) { d.fails_at = 1.1; }), HasSubstr("fails_at: expected above 0"));
  EXPECT_THAT(refusal([&](D& d) { d.fails_at = nan; }), HasSubstr("fails_at"));
  EXPECT_THAT(refusal([&](D& d) { d.overhead_s = -1; }), HasSubstr("overhead_s: expected 0"));
  EXPECT_THAT(refusal([&](D& d) { d.virtual_s = nan; }), HasSubstr("virtual_s: expected 0"));
  EXPECT_THAT(refusal([&](D& d) { d.tests = 0, d.virtual_s = 0; }), HasSubstr("nothing bounds"));
  EXPECT_THAT(refusal([&](D& d) { d.measure = "harn"; }), HasSubstr("'harn' is not one"));
}

TEST(SearchOfAProgram, RefusesOptionsThatMeanNothing) {
  const auto search = RunnableSearch::make(described({.measures = {1}}));
  ASSERT_TRUE(search);
  const auto refusal = [&](const SearchRunOptions& options) {
    return search.value().run(options).diagnostics().render();
  };
  EXPECT_THAT(refusal({.threads = 0}), HasSubstr("threads: error: expected 1 to 1024, found 0"));
  EXPECT_THAT(refusal({.repetitions = 0}), HasSubstr("repetitions: error: expected 1 or more"));
  EXPECT_THAT(refusal({.resume = true}), HasSubstr("there is no store to go on with"));
  EXPECT_THAT(refusal({.store = "x.gpkg"}), HasSubstr("read from a file"));
}

}  // namespace
}  // namespace jaywalk::search
