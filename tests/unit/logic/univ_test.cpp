// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Univ, TakesALiteralApart) {
  test::Terms terms;
  EXPECT_THAT(terms.answers("p(1,a)[k] =.. L", "L"), ElementsAre("[default,p,[1,a],[k]]"));
  EXPECT_THAT(terms.answers("p =.. L", "L"), ElementsAre("[default,p,[],[]]"));
  EXPECT_THAT(terms.answers("shop::p(1) =.. L", "L"), ElementsAre("[shop,p,[1],[]]"));
  EXPECT_THAT(terms.answers("~p(1) =.. [N,F,A,An]", "F"), ElementsAre("~p"));
}

TEST(Univ, TakesALiteralApartIntoThree) {
  test::Terms terms;
  EXPECT_THAT(terms.answers("p(1)[k] =.. [F,A,An]", "r(F,A,An)"), ElementsAre("r(p,[1],[k])"));
}

TEST(Univ, MakesALiteral) {
  test::Terms terms;
  EXPECT_THAT(terms.answers("X =.. [p,[1,a],[]]", "X"), ElementsAre("p(1,a)"));
  EXPECT_THAT(terms.answers("X =.. [p,[],[k]]", "X"), ElementsAre("p[k]"));
  EXPECT_THAT(terms.answers("X =.. [\"p\",[1],[]]", "X"), ElementsAre("p(1)"));
  EXPECT_THAT(terms.answers("X =.. [~p,[1],[]]", "X"), ElementsAre("~p(1)"));
  EXPECT_THAT(terms.answers("X =.. [default,p,[1],[]]", "X"), ElementsAre("p(1)"));
}

TEST(Univ, FailsForWhatIsNoLiteral) {
  test::Terms terms;
  EXPECT_THAT(terms.answers("X =.. [1,[],[]]", "X"), IsEmpty());
  EXPECT_THAT(terms.answers("X =.. [p]", "X"), IsEmpty());
  EXPECT_THAT(terms.answers("X =.. L", "X"), IsEmpty());
  EXPECT_THAT(terms.answers("3 =.. L", "L"), IsEmpty());
}

}  // namespace
}  // namespace jaywalk
