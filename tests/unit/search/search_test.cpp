// SPDX-License-Identifier: Apache-2.0
#include "search/search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

std::vector<double> fitnesses(const SearchRun& run) {
  std::vector<double> all;
  for (const TestRow& row : run.tests) all.push_back(row.test.fitness);
  return all;
}

TEST(Search, EndsWhenItsTestsAreUsedUp) {
  const SearchResults results = run_searches(corner_plan("random", 17), nullptr);
  ASSERT_EQ(results.runs.size(), 1U);
  EXPECT_TRUE(results.complete);
  EXPECT_EQ(results.runs[0].tests.size(), 17U);
}

TEST(Search, EndsWhenItsFailuresAreFound) {
  SearchPlan plan = corner_plan("random", 10'000);
  plan.budget.failures = 3;
  const SearchResults results = run_searches(plan, nullptr);
  const auto failed = std::ranges::count_if(results.runs[0].tests,
                                            [](const TestRow& row) { return row.test.failed; });
  EXPECT_EQ(failed, 3);
  EXPECT_TRUE(results.runs[0].tests.back().test.failed);
}

// 5 s simulated, 15 s overhead and 2 s for generating: the fifth test would go beyond 100 s.
TEST(Search, ChargesSimulatedTimeOverheadAndAConstantForGenerating) {
  SearchPlan plan = corner_plan("random", 0);
  plan.budget = {.virtual_s = 100, .overhead_s = 15, .generation_s = 2};
  const SearchResults results = run_searches(plan, nullptr);
  EXPECT_EQ(results.runs[0].tests.size(), 4U);
  EXPECT_DOUBLE_EQ(results.runs[0].spent_s, 88);
}

TEST(Search, ChargesEachGeneratorWhatItCosts) {
  SearchPlan plan = corner_plan("random", 0);
  plan.budget = {.virtual_s = 100, .overhead_s = 0, .generation_s = 5};
  plan.generators.push_back(generator_spec("graft"));
  plan.generators[1].generation_s = 15;
  const SearchResults results = run_searches(plan, nullptr);
  EXPECT_EQ(results.runs[0].tests.size(), 10U);
  EXPECT_EQ(results.runs[1].tests.size(), 5U);
}

/// Simulates no time.
class Instant : public CornerSut {
 public:
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    class Run : public Sut {
     public:
      Outcome run(const TestInput&, std::size_t) override { return {.measures = {0.5}}; }
    };
    return std::make_unique<Run>();
  }
};

TEST(Search, EndsWithAMessageIfVirtualTimeStandsStill) {
  SearchPlan plan = corner_plan("random", 0);
  plan.model = std::make_shared<Instant>();
  plan.budget = {.virtual_s = 100, .overhead_s = 0};
  const SearchResults results = run_searches(plan, nullptr);
  EXPECT_FALSE(results.complete);
  EXPECT_THAT(results.trouble.render(), testing::HasSubstr("took no simulated time"));
  plan.budget.tests = 1500;
  EXPECT_TRUE(run_searches(plan, nullptr).complete) << "the number of tests ends it";
}

/// Has no valid test.
class Nowhere : public Square {
 public:
  [[nodiscard]] Validity check(const TestInput&) const override {
    ++checked;
    return {"there is no such place"};
  }
  mutable std::size_t checked = 0;
};

class NowhereSut : public CornerSut {
 public:
  [[nodiscard]] const SearchSpace& space() const override { return space_; }
  [[nodiscard]] std::size_t checked() const { return space_.checked; }

 private:
  Nowhere space_;
};

TEST(Search, EndsWithAMessageIfNoTestIsValid) {
  for (const GeneratorKind& kind : generators()) {
    SearchPlan plan = corner_plan(kind.name, 100);
    const auto model = std::make_shared<NowhereSut>();
    plan.model = model;
    const SearchResults results = run_searches(plan, nullptr);
    EXPECT_FALSE(results.complete) << kind.name;
    EXPECT_THAT(results.trouble.render(), testing::HasSubstr("there is no such place"));
    EXPECT_LT(model->checked(), 12'000U) << kind.name << " draws for too long";
  }
}

TEST(Search, ScalesTheMeasureToTheFitness) {
  const Fitness smaller_is_worse{.measure = 0, .harmless = 20, .worst = 0, .fails_at = 0.95};
  EXPECT_DOUBLE_EQ(smaller_is_worse.of({.measures = {5}}), 0.75);
  EXPECT_DOUBLE_EQ(smaller_is_worse.of({.measures = {30}}), 0);
  EXPECT_DOUBLE_EQ(smaller_is_worse.of({.measures = {-1}}), 1);
  EXPECT_DOUBLE_EQ(smaller_is_worse.of({.error = "crashed", .measures = {0}}), 0);
}

TEST(Search, GivesTheSameResultsOnAnyNumberOfThreads) {
  SearchPlan plan = corner_plan("wogan", 90);
  plan.generators.push_back(generator_spec("graft"));
  plan.repetitions = 2;
  const SearchResults one = run_searches(plan, nullptr);
  plan.threads = 4;
  const SearchResults four = run_searches(plan, nullptr);
  ASSERT_EQ(one.runs.size(), 4U);
  for (std::size_t i = 0; i < one.runs.size(); ++i) {
    EXPECT_EQ(fitnesses(one.runs[i]), fitnesses(four.runs[i])) << i;
  }
  EXPECT_NE(fitnesses(one.runs[0]), fitnesses(one.runs[1]));
}

TEST(Search, DoesNotDependOnTheOtherGenerators) {
  const SearchResults alone = run_searches(corner_plan("graft", 40), nullptr);
  SearchPlan plan = corner_plan("random", 40);
  plan.generators.push_back(generator_spec("graft"));
  const SearchResults both = run_searches(plan, nullptr);
  EXPECT_EQ(fitnesses(alone.runs[0]), fitnesses(both.runs[1]));
}

/// Keeps tests in memory.
class MemoryLog : public TestLog {
 public:
  explicit MemoryLog(std::vector<TestRow> known = {}) : known_(std::move(known)) {}
  [[nodiscard]] const std::vector<TestRow>& finished(std::size_t) const override { return known_; }
  Continue add(std::size_t, std::size_t, const TestRow& row) override {
    added.push_back(row);
    return Continue::yes;
  }
  std::vector<TestRow> added;

 private:
  std::vector<TestRow> known_;
};

class EachGenerator : public testing::TestWithParam<std::string_view> {};

TEST_P(EachGenerator, GoesOnWhereAnEarlierProcessEnded) {
  const SearchPlan plan = corner_plan(GetParam(), 100);
  MemoryLog whole;
  const SearchResults uninterrupted = run_searches(plan, &whole);
  MemoryLog rest({whole.added.begin(), whole.added.begin() + 70});
  const SearchResults resumed = run_searches(plan, &rest);
  EXPECT_EQ(rest.added.size(), 30U);
  EXPECT_EQ(fitnesses(uninterrupted.runs[0]), fitnesses(resumed.runs[0]));
}

TEST_P(EachGenerator, AsksForValidTestsAlone) {
  const SearchPlan plan = corner_plan(GetParam(), 150);
  const SearchResults results = run_searches(plan, nullptr);
  ASSERT_EQ(results.runs[0].tests.size(), 150U);
  for (const TestRow& row : results.runs[0].tests) {
    EXPECT_TRUE(plan.model->space().check(row.test.input).valid());
    EXPECT_GE(row.candidates, 1U);
    EXPECT_LT(row.invalid, row.candidates);
  }
}

INSTANTIATE_TEST_SUITE_P(Generators, EachGenerator,
                         testing::Values("random", "random-sequences", "frenetic", "ogan", "wogan",
                                         "graft"));

TEST(Search, RefusesTestsOfAStoreThatItWouldNotAskFor) {
  MemoryLog log;
  const SearchPlan plan = corner_plan("random", 10);
  (void)run_searches(plan, &log);
  log.added[4].test.input.values[0] += 0.001;
  MemoryLog changed(log.added);
  const SearchResults results = run_searches(plan, &changed);
  EXPECT_FALSE(results.complete);
  EXPECT_THAT(results.trouble.render(), testing::HasSubstr("test 4 is not the one in the store"));
}

TEST(Search, EndsWhenItsObserverSaysSo) {
  SearchPlan plan = corner_plan("random", 5'000'000);
  const SearchResults results = run_searches(
      plan, nullptr, {.progress = [](const SearchProgress&) { return Continue::no; }, .error = {}});
  EXPECT_FALSE(results.complete);
  EXPECT_LT(results.runs[0].tests.size(), 5'000'000U);
}

/// Fails to answer every third test.
class Shaky : public CornerSut {
 public:
  [[nodiscard]] std::unique_ptr<Sut> make() const override {
    class Run : public Sut {
     public:
      Outcome run(const TestInput& input, std::size_t test) override {
        if (++tests_ % 3 == 0) return {.error = "it crashed"};
        return CornerRun().run(input, test);
      }

     private:
      int tests_ = 0;
    };
    return std::make_unique<Run>();
  }
};

TEST(Search, LosesOnlyTheTestsThatHaveNoResult) {
  SearchPlan plan = corner_plan("wogan", 99);
  plan.model = std::make_shared<Shaky>();
  int errors = 0;
  const SearchResults results = run_searches(
      plan, nullptr,
      {.progress = {}, .error = [&](const auto&, auto, auto, const std::string& error) {
         EXPECT_EQ(error, "it crashed");
         ++errors;
       }});
  EXPECT_TRUE(results.complete);
  EXPECT_EQ(results.runs[0].tests.size(), 99U);
  EXPECT_EQ(errors, 33);
}

}  // namespace
}  // namespace jaywalk::search
