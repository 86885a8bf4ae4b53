// SPDX-License-Identifier: Apache-2.0
// Which defects searches kill, counted from runs made by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "search/search_kills.h"
#include "tests/unit/search/toy.h"

namespace jaywalk::search {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// The square, with three defects of whatever drives there.
class Defective : public CornerSut {
 public:
  [[nodiscard]] std::span<const MeasureKind> measures() const override { return kMeasures; }
  [[nodiscard]] std::vector<std::string> defects() const override {
    return {"latency=0.3", "short-range=12", "blind"};
  }
  [[nodiscard]] std::uint32_t agents() const override { return 4; }

  static constexpr std::array kMeasures = {MeasureKind{"kills", ""},
                                           MeasureKind{"healthy_blamed", ""}};
};

/// A test at that place: whether it kills the defect, whether the healthy AV is to blame.
TestRow test(double place, bool kills, bool healthy = false) {
  TestRow row;
  row.test = {.input = {Form::vector, {place, 0}},
              .outcome = {.measures = {kills ? 1.0 : 0.0, healthy ? 1.0 : 0.0}}};
  return row;
}
TestRow without_result() {
  TestRow row;
  row.test.outcome.error = "it hung";
  return row;
}

/// Two generators, `plain` and `clever`, each with three defects, and some repetitions.
class SearchKillsTest : public testing::Test {
 protected:
  explicit SearchKillsTest(std::uint32_t repetitions = 1) {
    experiment_.plan.model = std::make_shared<Defective>();
    experiment_.plan.repetitions = repetitions;
    for (const char* family : {"plain", "clever"}) {
      for (std::size_t defect = 0; defect < 3; ++defect) {
        GeneratorSpec spec = generator_spec("random");
        spec.name = std::string(family) + std::to_string(defect);
        spec.family = family;
        spec.defect = defect;
        experiment_.plan.generators.push_back(spec);
      }
    }
  }
  static SearchRun run(std::vector<TestRow> tests, bool complete = true) {
    return {.tests = std::move(tests), .complete = complete};
  }

  SearchExperiment experiment_;
};

class RepeatedKills : public SearchKillsTest {
 protected:
  RepeatedKills() : SearchKillsTest(3) {}
};

class TwiceRepeatedKills : public SearchKillsTest {
 protected:
  TwiceRepeatedKills() : SearchKillsTest(2) {}
};

TEST_F(SearchKillsTest, HaveARowForEachGeneratorAndACellForEachDefect) {
  SearchKills kills(experiment_);
  for (std::size_t search = 0; search < 6; ++search) {
    kills.add(search, run({test(0.1, search == 4), test(0.2, search >= 4)}));
  }
  const KillMatrix matrix = kills.matrix();
  EXPECT_THAT(matrix.defects, ElementsAre("latency=0.3", "short-range=12", "blind"));
  ASSERT_THAT(matrix.rows, SizeIs(2));
  EXPECT_EQ(matrix.rows[0].behaviour, "plain");
  EXPECT_EQ(matrix.rows[1].behaviour, "clever");
  EXPECT_EQ(matrix.rows[0].agents, 4U);
  ASSERT_THAT(matrix.rows[1].cells, SizeIs(3));
  EXPECT_EQ(matrix.rows[0].killed(), 0U);
  EXPECT_EQ(matrix.rows[1].killed(), 2U);
  EXPECT_EQ(matrix.rows[1].cells[1].kills, 2U);
  EXPECT_EQ(matrix.rows[1].cells[1].tests, 2U);
  EXPECT_EQ(matrix.rows[1].cells[1].first, 1U);
  EXPECT_EQ(matrix.rows[1].cells[2].first, 2U);
}

TEST_F(SearchKillsTest, LeaveOutTestsWithoutAResult) {
  SearchKills kills(experiment_);
  kills.add(0, run({without_result(), test(0.1, false), without_result(), test(0.2, true)}));
  const KillCell cell = kills.matrix().rows[0].cells[0];
  EXPECT_EQ(cell.tests, 2U);
  EXPECT_EQ(cell.first, 2U);
}

TEST_F(SearchKillsTest, CountWhereTheHealthyAvIsToBlame) {
  SearchKills kills(experiment_);
  kills.add(0, run({test(0.1, false, true)}));
  kills.add(2, run({test(0.1, false, true), test(0.2, false, true)}));
  EXPECT_EQ(kills.matrix().rows[0].healthy_failures, 3U);
  EXPECT_EQ(kills.matrix().rows[1].healthy_failures, 0U);
}

TEST_F(SearchKillsTest, HaveNoTestsOfASearchThatIsNotComplete) {
  SearchKills kills(experiment_);
  kills.add(0, run({test(0.1, true)}, false));
  const KillCell cell = kills.matrix().rows[0].cells[0];
  EXPECT_EQ(cell.tests, 0U);
  EXPECT_EQ(cell.kills, 0U);
  EXPECT_FALSE(cell.measured);
}

TEST_F(RepeatedKills, AddUpAllRepetitionsAndHaveTheMedianOfTheFirst) {
  SearchKills kills(experiment_);
  kills.add(0, run({test(0.1, false), test(0.2, false), test(0.3, true)}));
  kills.add(1, run({test(0.4, true), test(0.5, true)}));
  kills.add(2, run({test(0.6, false), test(0.7, true)}));
  const KillCell cell = kills.matrix().rows[0].cells[0];
  EXPECT_EQ(cell.tests, 7U);
  EXPECT_EQ(cell.kills, 4U);
  ASSERT_TRUE(cell.measured);
  EXPECT_EQ(cell.measured->first_median, 2U) << "of 3, 1 and 2";
  EXPECT_EQ(cell.first, 3U) << "of the tests one after another";
}

TEST_F(RepeatedKills, TakeARepetitionThatKillsNothingForTheLongest) {
  SearchKills kills(experiment_);
  kills.add(0, run({test(0.1, false)}));
  kills.add(1, run({test(0.1, true)}));
  kills.add(2, run({test(0.1, false), test(0.2, false), test(0.3, true)}));
  EXPECT_EQ(kills.matrix().rows[0].cells[0].measured->first_median, 3U);
  kills.add(3, run({test(0.1, false)}));
  kills.add(4, run({test(0.1, false)}));
  kills.add(5, run({test(0.1, true)}));
  EXPECT_FALSE(kills.matrix().rows[0].cells[1].measured->first_median) << "two of three never";
}

TEST_F(TwiceRepeatedKills, HaveTheLowerOfTwoInTheMiddle) {
  SearchKills kills(experiment_);
  kills.add(0, run({test(0.1, false), test(0.2, true)}));
  kills.add(1, run({test(0.1, true)}));
  EXPECT_EQ(kills.matrix().rows[0].cells[0].measured->first_median, 1U);
}

TEST_F(SearchKillsTest, KnowTheTestThatKillsMostAndTheTwoThatDoTogether) {
  SearchKills kills(experiment_);
  // 0.1 kills the first two, 0.2 the last, 0.3 the first alone.
  kills.add(3, run({test(0.1, true), test(0.2, false), test(0.3, true)}));
  kills.add(4, run({test(0.1, true), test(0.2, false), test(0.3, false)}));
  kills.add(5, run({test(0.1, false), test(0.2, true)}));
  const auto teams = kills.best_tests(1);
  ASSERT_THAT(teams, SizeIs(2));
  EXPECT_EQ(teams[0].killed, 2U);
  EXPECT_THAT(teams[0].tests[0].values, ElementsAre(0.1, 0));
  EXPECT_EQ(teams[1].killed, 3U);
  EXPECT_THAT(teams[1].tests, SizeIs(2));
  EXPECT_TRUE(kills.best_tests(0).empty()) << "the other generator kills nothing";
}

TEST_F(SearchKillsTest, TakeTheFirstOfTeamsThatKillAsMuch) {
  SearchKills kills(experiment_);
  // Any two of the three kill two defects.
  kills.add(0, run({test(0.1, true)}));
  kills.add(1, run({test(0.2, true)}));
  kills.add(2, run({test(0.3, true)}));
  const auto teams = kills.best_tests(0);
  ASSERT_THAT(teams, SizeIs(2));
  EXPECT_THAT(teams[0].tests[0].values, ElementsAre(0.3, 0)) << "of the last defect";
  EXPECT_THAT(teams[1].tests[0].values, ElementsAre(0.3, 0));
  EXPECT_THAT(teams[1].tests[1].values, ElementsAre(0.2, 0));
}

TEST_F(SearchKillsTest, HaveNoTeamOfTwoWhereOneDoesAsWell) {
  SearchKills kills(experiment_);
  kills.add(0, run({test(0.1, true), test(0.2, true)}));
  kills.add(1, run({test(0.1, true)}));
  const auto teams = kills.best_tests(0);
  ASSERT_THAT(teams, SizeIs(1));
  EXPECT_EQ(teams[0].killed, 2U);
}

}  // namespace
}  // namespace jaywalk::search
