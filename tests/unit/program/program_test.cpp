// SPDX-License-Identifier: Apache-2.0
// Properties of a program as a whole.

#include "interpreter/program/program.h"

#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

using test::CompiledProgram;

bool can_start_later(const std::string& program) {
  return CompiledProgram(program).program->can_start_later();
}

TEST(Program, CanStartLaterIfItsGoalsAreGround) {
  EXPECT_TRUE(can_start_later("!g(1). b(X) :- c(X). +!g(X) <- a."));
  EXPECT_FALSE(can_start_later("!g(X).")) << "its variable would be another one";
  EXPECT_FALSE(can_start_later("!g(1). !h(1 + 1).")) << "is evaluated";
  EXPECT_FALSE(can_start_later("b(1). +!g."));
}

TEST(Program, StartsAtOnceIfItHasManyBeliefs) {
  std::string beliefs;
  for (int i = 0; i < 1000; ++i) beliefs += "b(" + std::to_string(i) + "). ";
  EXPECT_TRUE(can_start_later("!g. " + beliefs));
  EXPECT_FALSE(can_start_later("!g. c. " + beliefs));
}

TEST(Program, HasATableForEachPredicateOfRulesUnlessTheyAreMany) {
  std::string many;
  for (std::size_t i = 0; i <= RuleTable::kMostRules; ++i) {
    many += "m(" + std::to_string(i) + ") :- b. ";
  }
  const CompiledProgram made("a(1) :- b. c(X) :- b. a(2) :- b. d(1). " + many);
  const auto& tables = made.program->rule_tables();
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].first, made.program->beliefs()[0].predicate);
  EXPECT_EQ(tables[1].first, made.program->beliefs()[1].predicate);
}

}  // namespace
}  // namespace jaywalk
