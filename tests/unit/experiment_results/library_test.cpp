// SPDX-License-Identifier: Apache-2.0
// The errors that <jaywalk/comparison.h> and <jaywalk/store.h> report.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/experiment_results/experiment_runs.h"
#include <jaywalk/comparison.h>
#include <jaywalk/store.h>

namespace jaywalk {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Library : public StoreTest {
 protected:
  RunnableScenario scenario_ = RunnableScenario::read(JAYWALK_SOURCE_DIR "/scenarios/paper.yaml",
                                                      {.behaviours = {"proximity", "election"}})
                                   .value();

  [[nodiscard]] std::string refusal(const ComparisonOptions& options) const {
    return compare(scenario_, options).diagnostics().render();
  }
};

TEST_F(Library, RefusesAComparisonWithoutTestsAgentsOrThreads) {
  EXPECT_THAT(refusal({.tests = 0}), HasSubstr("tests: error: expected 1 to "));
  EXPECT_THAT(refusal({.agents = std::vector<std::uint32_t>{}}), HasSubstr("agents: error:"));
  EXPECT_THAT(refusal({.agents = std::vector<std::uint32_t>{2, 0}}), HasSubstr("agents: error:"));
  EXPECT_THAT(refusal({.threads = 0}), HasSubstr("threads: error: expected 1 to 1024, found 0"));
  EXPECT_THAT(refusal({.threads = 100'000}), HasSubstr("threads: error:"));
  EXPECT_THAT(
      refusal({.agents = std::vector<std::uint32_t>{1'000'000'000}}),
      HasSubstr("agents: error: expected one number of agents or more, each from 1 to 10000"));
  EXPECT_THAT(refusal({.resume = true}), HasSubstr("there is no store to go on with"));
}

TEST_F(Library, RefusesTestsThatAreTooGreat) {
  const auto why = [&](const TestChoice& choice) {
    return scenario_.run(choice).diagnostics().render();
  };
  EXPECT_THAT(why({.agents = 0}), HasSubstr("a test needs at least one agent"));
  EXPECT_THAT(why({.agents = 1'000'000'000}), HasSubstr("a test has at most 10000 agents"));
  EXPECT_THAT(why({.test = 10'000'000}), HasSubstr("test: expected 0 to 9999999"));
}

TEST_F(Library, ListsTheTestsOfABehaviourThatTheStoreHas) {
  const std::string path = file("paper.gpkg");
  ASSERT_TRUE(
      compare(scenario_, {.tests = 3, .agents = std::vector<std::uint32_t>{1}, .store = path}));
  const auto store = ResultsStore::open(path);
  ASSERT_TRUE(store);
  std::size_t tests = 0;
  const auto count = [&](const TestLine& line) {
    EXPECT_EQ(line.behaviour, "election");
    ++tests;
    return true;
  };
  EXPECT_FALSE(store.value().for_each_test({.behaviour = "election"}, count));
  EXPECT_EQ(tests, 3U);
  const auto mistake = store.value().for_each_test({.behaviour = "elction"}, count);
  ASSERT_TRUE(mistake);
  EXPECT_THAT(mistake->render(), AllOf(HasSubstr("the store has no behaviour 'elction'"),
                                       HasSubstr("did you mean 'election'?")));
  EXPECT_EQ(tests, 3U);
}

}  // namespace
}  // namespace jaywalk
