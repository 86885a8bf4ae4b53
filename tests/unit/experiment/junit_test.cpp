// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/export/comparison_files.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::Not;

Comparison judged(VerdictCounts counts) {
  Comparison comparison{.assertions = {"away"}};
  comparison.summaries = {{.behaviour = "walk", .agents = 3, .tests = counts.all()}};
  comparison.assessments = {{.verdicts = {counts}}};
  return comparison;
}

TEST(Junit, HasACaseForEachBehaviourOfEachAssertion) {
  EXPECT_EQ(to_junit(judged({.tests = {2, 8, 0, 0}})),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites>\n"
            "  <testsuite name=\"away\" tests=\"1\" failures=\"0\" errors=\"0\" skipped=\"0\">\n"
            "    <testcase classname=\"away\" name=\"walk, 3 agents\"/>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(Junit, FailsIfSomeTestViolatesIt) {
  const std::string xml = to_junit(judged({.tests = {0, 8, 2, 0}}));
  EXPECT_THAT(xml, HasSubstr("failures=\"1\" errors=\"0\" skipped=\"0\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"2 of 10 tests violate it\"/>"));
}

TEST(Junit, SkipsWhatNoTestExercisedOrCouldHaveKept) {
  EXPECT_THAT(to_junit(judged({.tests = {10, 0, 0, 0}})),
              HasSubstr("<skipped message=\"no test exercised it\"/>"));
  const std::string unavoidable = to_junit(judged({.tests = {9, 0, 0, 1}}));
  EXPECT_THAT(unavoidable,
              HasSubstr("<skipped message=\"no test in which it could have been kept\"/>"));
  EXPECT_THAT(unavoidable, HasSubstr("skipped=\"1\""));
}

TEST(Junit, OneTestThatKeptItIsEnough) {
  EXPECT_THAT(to_junit(judged({.tests = {0, 1, 0, 9}})), Not(HasSubstr("<skipped")));
}

TEST(Junit, HasASuiteOfTestsThatEndedErrored) {
  Comparison comparison = judged({.tests = {0, 8, 0, 0}});
  comparison.summaries[0].tests = 10;
  comparison.summaries[0].errored = 2;
  EXPECT_THAT(to_junit(comparison), HasSubstr("<error message=\"2 of 10 tests ended errored\"/>"));
  comparison.troubles.resize(1);
  comparison.troubles[0].errors = {{.message = "the simulator\tdied\nsuddenly", .tests = 2}};
  EXPECT_THAT(to_junit(comparison),
              HasSubstr("2 of 10 tests ended errored: the simulator?died suddenly\"/>"));
}

TEST(Junit, EscapesNames) {
  Comparison comparison = judged({.tests = {0, 8, 0, 0}});
  comparison.summaries[0].behaviour = "a\"<b>&";
  EXPECT_THAT(to_junit(comparison), HasSubstr("name=\"a&quot;&lt;b&gt;&amp;, 3 agents\""));
}

TEST(Junit, OfNothingIsAnEmptyDocument) {
  EXPECT_EQ(to_junit(Comparison{}),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n</testsuites>\n");
}

Criteria rules() {
  auto assertions = parse_assertions(std::make_shared<const Source>(
      "rules.yaml",
      "assertions:\n"
      "  - {id: away, source: s, precondition: true, requirement: always closest > 1}\n"));
  return {.assertions = std::move(assertions.value())};
}

TEST(JunitOfOneTest, SaysWhereItsRequirementWasViolated) {
  const TestAssessment assessment{
      .judgements = {{.verdict = Verdict::fail, .robustness = -0.25, .tick = 4}}};
  const std::string xml = to_junit("drive.csv", rules(), assessment);
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"drive.csv\" tests=\"1\" failures=\"1\""));
  EXPECT_THAT(xml, HasSubstr("name=\"away\""));
  EXPECT_THAT(xml, HasSubstr("violated at tick 4, robustness -0.25: always closest &gt; 1\"/>"));
}

TEST(JunitOfOneTest, SaysWhyItWasSkipped) {
  EXPECT_THAT(to_junit("t", rules(), {.judgements = {{.verdict = Verdict::vacuous}}}),
              HasSubstr("<skipped message=\"the precondition was not met\"/>"));
  EXPECT_THAT(to_junit("t", rules(), {.judgements = {{.verdict = Verdict::unavoidable}}}),
              HasSubstr("<skipped message=\"it could not have been kept\"/>"));
  EXPECT_THAT(to_junit("t", rules(), {.judgements = {{.verdict = Verdict::pass}}}),
              HasSubstr("skipped=\"0\""));
}

}  // namespace
}  // namespace jaywalk
