// SPDX-License-Identifier: Apache-2.0
// Formulas that cannot be executed fail with an error that a plan can read.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The error of a body that fails, as the plan for its failure sees it.
std::vector<std::string> error_of(const std::string& body) {
  return test::printed_by("!g. +!g <- " + body + ". -!g[error(E)] <- .print(E).");
}

TEST(Formula, FailsIfAVariablesValueIsNoGoal) {
  EXPECT_THAT(error_of("X = 3; !X"), ElementsAre("body_var_not_literal"));
  EXPECT_THAT(error_of("X = [a]; !!X"), ElementsAre("body_var_not_literal"));
}

TEST(Formula, FailsIfAVariablesValueIsNoBelief) {
  EXPECT_THAT(error_of("X = 3; +X"), ElementsAre("body_var_not_literal"));
  EXPECT_THAT(error_of("X = [a]; -X"), ElementsAre("body_var_not_literal"));
  EXPECT_THAT(error_of("X = \"text\"; -+X"), ElementsAre("body_var_not_literal"));
}

TEST(Formula, FailsIfAVariableWithAnOperatorHasABody) {
  EXPECT_THAT(error_of("X = {a; b}; !X"), ElementsAre("body_var_with_op"));
  EXPECT_THAT(error_of("X = {a; b}; +X"), ElementsAre("body_var_with_op"));
}

TEST(Formula, FailsIfItsVariableHasNoValue) {
  EXPECT_THAT(error_of("!X"), ElementsAre("body_var_without_value"));
  EXPECT_THAT(error_of("X"), ElementsAre("body_var_without_value"));
  EXPECT_THAT(error_of("+X"), ElementsAre("body_var_without_value"));
}

TEST(Formula, FailsIfThereIsNoSuchInternalAction) {
  EXPECT_THAT(error_of(".no_such_action(1)"), ElementsAre("unknown_internal_action"));
  EXPECT_THAT(error_of("my.library.act"), ElementsAre("unknown_internal_action"));
}

TEST(Formula, OfAContextWarnsOfACallThatCannotBe) {
  const auto logged = [](const std::string& context) {
    const auto run = test::run_agents({{"agent", "!g. +!g : " + context + ". -!g."}});
    EXPECT_TRUE(run.errors.empty());
    return run.logged;
  };
  EXPECT_THAT(logged(".length([1])"), ElementsAre(HasSubstr("wrong number of arguments")));
}

TEST(AddPlan, RefusesWhatIsNoPlan) {
  EXPECT_THAT(test::printed_by("!g. +!g <- .add_plan(b(1)). -!g[error_msg(M)] <- .print(M)."),
              ElementsAre(HasSubstr("'b(1)' (LiteralImpl) can not be used as a plan")));
  EXPECT_THAT(test::printed_by("!g. +!g <- .add_plan(\"+!h <- (\"). -!g[error(E)] <- .print(E)."),
              testing::SizeIs(1));
}

}  // namespace
}  // namespace jaywalk
