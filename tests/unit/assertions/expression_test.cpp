// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/assertions/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/assertions/traces.h"

namespace jaywalk::stl {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string errors_of(const std::string& text,
                      const std::map<std::string, double>& parameters = {}) {
  std::string errors;
  const bool valid = expression(text, &errors, parameters).has_value();
  EXPECT_EQ(valid, errors.empty());
  return errors;
}

TEST(Expression, PointsAtWhatItDidNotExpect) {
  EXPECT_EQ(errors_of("x > 1 and\n  and y > 2"),
            "rules.yaml:2:3: error: expected a condition, found 'and'\n"
            "    and y > 2\n"
            "    ^~~\n");
  EXPECT_THAT(errors_of("x > "), StartsWith("rules.yaml:1:5: error: expected a number or a signal, "
                                            "found the end"));
  EXPECT_THAT(errors_of(""), HasSubstr("expected a condition, found the end"));
  EXPECT_THAT(errors_of("(x > 1"), HasSubstr("expected ')', found the end"));
  EXPECT_THAT(errors_of("always[0 3] x > 1"), HasSubstr("expected ',', found '3'"));
  EXPECT_THAT(errors_of("x > 12mph"), HasSubstr("found '12mph'"));
  EXPECT_THAT(errors_of("x > ä"), HasSubstr("found 'ä'"));
}

TEST(Expression, KnowsTheHabitsOfOtherLanguages) {
  EXPECT_THAT(errors_of("x > 1 && y > 1"), HasSubstr("write 'and'"));
  EXPECT_THAT(errors_of("!p"), HasSubstr("write 'not'"));
  EXPECT_THAT(errors_of("p -> x > 1"), HasSubstr("write '=>'"));
  EXPECT_THAT(errors_of("x = 1"), HasSubstr("write '=='"));
  EXPECT_THAT(errors_of("0 < x < 1"), HasSubstr("a < b and b < c"));
  EXPECT_THAT(errors_of("allways (x > 1)"), HasSubstr("did you mean 'always'?"));
}

TEST(Expression, SuggestsTheSignalThatWasMeant) {
  EXPECT_EQ(errors_of("always av.w > 0 and tine > 1"),
            "rules.yaml:1:8: error: unknown signal 'av.w'\n"
            "  always av.w > 0 and tine > 1\n"
            "         ^~~~\n"
            "  hint: did you mean 'av.v'?\n"
            "rules.yaml:1:21: error: unknown signal 'tine'\n"
            "  always av.w > 0 and tine > 1\n"
            "                      ^~~~\n"
            "  hint: did you mean 'time'?\n")
      << "both mistakes are reported";
  EXPECT_THAT(errors_of("v > 1"), HasSubstr("did you mean 'av.v'?"));
  EXPECT_THAT(errors_of("av.x > 1"), HasSubstr("unknown signal 'av.x'"));
  EXPECT_THAT(errors_of("nearest.x > 1 and p12.y > 2"), IsEmpty());
}

TEST(Expression, TellsNumbersFromConditions) {
  EXPECT_THAT(errors_of("x"), HasSubstr("expected a condition, found a number"));
  EXPECT_THAT(errors_of("x + 1"), HasSubstr("expected a condition, found a number"));
  EXPECT_THAT(errors_of("p > 1"), HasSubstr("expected a number, found a condition"));
  EXPECT_THAT(errors_of("always x"), HasSubstr("expected a condition, found a number"));
  EXPECT_THAT(errors_of("x and p"), HasSubstr("rules.yaml:1:1: error: expected a condition"));
}

TEST(Expression, ReadsWindowsFromNumbersAndParameters) {
  const auto read = expression("always[T / 2, T] x > limit", nullptr, {{"T", 4}, {"limit", 1}});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->node(read->root).window.from_s, 2);
  EXPECT_EQ(read->node(read->root).window.to_s, 4);
  EXPECT_THAT(errors_of("always[3, 1] x > 0"), HasSubstr("ends at 1 s, before it begins at 3 s"));
  EXPECT_THAT(errors_of("always[-1, 1] x > 0"), HasSubstr("at least 0 s, found -1"));
  EXPECT_THAT(errors_of("always[0, x] x > 0"), HasSubstr("numbers or parameters"));
}

TEST(Expression, BindsComparisonsTighterThanTemporalOperatorsAndThoseTighterThanAnd) {
  const auto root = [](const std::string& text) {
    const auto read = expression(text);
    return read ? read->node(read->root).kind : NodeKind::number;
  };
  EXPECT_EQ(root("always x > 1 and p"), NodeKind::conjunction);
  EXPECT_EQ(root("p and p or p"), NodeKind::disjunction);
  EXPECT_EQ(root("p or p => p => p"), NodeKind::implication);
  EXPECT_EQ(root("always p until p and p"), NodeKind::conjunction);
  EXPECT_EQ(root("not p until p"), NodeKind::until);
  EXPECT_EQ(root("always (p and p)"), NodeKind::always);
  EXPECT_EQ(root("-x < -(1 - 2)"), NodeKind::less);
}

TEST(Expression, KnowsWhetherItIsAboutOneRoadUser) {
  EXPECT_TRUE(expression("x > 1 and av.v > 1")->is_about_one());
  EXPECT_TRUE(expression("happens(collision)")->is_about_one());
  EXPECT_FALSE(expression("av.v > 1 and nearest.x > 1 and p1.x > 2")->is_about_one());
  EXPECT_FALSE(expression("forall always x > 1")->is_about_one());
}

TEST(Expression, RefusesWhatWouldCostTooMuch) {
  EXPECT_THAT(errors_of(std::string(500, '(') + "p" + std::string(500, ')')),
              HasSubstr("nested more than 100 levels deep"));
  EXPECT_THAT(errors_of(std::string(1000, '-') + "x > 1"), HasSubstr("nested more than"));
  std::string negations;
  for (int i = 0; i < 300; ++i) negations += "not ";
  EXPECT_THAT(errors_of(negations + "p"), HasSubstr("nested more than"));
  EXPECT_THAT(errors_of(std::string(5000, ' ') + "p"), HasSubstr("more than 4000 bytes"));
  EXPECT_THAT(errors_of("forall (p and exists p)"), HasSubstr("within another one"));
}

}  // namespace
}  // namespace jaywalk::stl
