// SPDX-License-Identifier: Apache-2.0
// The plans that patterns of commitment stand for, as the paper of Huebner, Bordini and Wooldridge
// (2006) and Jason's directives have them.

#include "interpreter/compile/goal_patterns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/parser.h"

namespace jaywalk {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Expanded {
  std::string text;
  std::string problem;
};

/// What `{begin DIRECTIVE} PLANS {end}` stands for.
Expanded expand(const std::string& directive, const std::string& plans) {
  Diagnostics diagnostics;
  const auto source =
      std::make_shared<const Source>("t", "{begin " + directive + "} " + plans + " {end}");
  const ast::File file = parse_agent(source, diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << diagnostics.render();
  Expanded expanded;
  expanded.text = expand_goal_pattern(file.components.front(), *source, expanded.problem);
  if (!expanded.problem.empty()) return expanded;
  Diagnostics own;
  (void)parse_agent(std::make_shared<const Source>("expanded", expanded.text), own);
  EXPECT_TRUE(own.empty()) << own.render();
  return expanded;
}

TEST(GoalPattern, OfADeclarativeGoalTestsWhatEachPlanHasAchieved) {
  EXPECT_EQ(expand("dg(g(X))", "+!g(X) : c & d <- a; b. +!g(X).").text,
            "+!g(X) : g(X).\n"
            "+!g(X) : .intend(g(X)).\n"
            "+!g(X) : c & d <- a; b; ?g(X).\n"
            "+!g(X) <- ?g(X).\n"
            "+g(X) <- .succeed_goal(g(X)).\n");
}

TEST(GoalPattern, TestsThePlansOwnTermsOfTheGoal) {
  EXPECT_THAT(expand("dg(g(X))", "+!g(Y) <- a(Y).").text, HasSubstr("+!g(Y) <- a(Y); ?g(Y).\n"));
}

TEST(GoalPattern, LeavesPlansForOtherEventsAsTheyAre) {
  EXPECT_THAT(expand("dg(g)", "@l[atomic] +!h : c <- a. -!g <- b. +!g(1) <- d. +g <- e.").text,
              HasSubstr("@l[atomic] +!h : c <- a.\n-!g <- b.\n+!g(1) <- d.\n+g <- e.\n"));
}

TEST(GoalPattern, KeepsWhatIsNoPlan) {
  EXPECT_THAT(expand("dg(g)", "b(1). +!g <- a. r(X) :- b(X). !g.").text,
              HasSubstr("b(1).\nr(X) :- b(X).\n!g.\n+!g <- a; ?g.\n"));
}

TEST(GoalPattern, OfABacktrackingGoalTriesAgainWhereItFails) {
  EXPECT_EQ(expand("bdg(g)", "+!g <- a.").text, expand("dg(g)", "+!g <- a.").text + "-!g <- !g.\n");
}

TEST(GoalPattern, OfAnExclusiveBacktrackingGoalTriesEachPlanOnce) {
  EXPECT_EQ(expand("ebdg(g)", "+!g : c | d <- a. +!g.").text,
            "+!g : g.\n"
            "+!g : not p__f(1,g) & (c | d) <- +p__f(1,g); a; ?g.\n"
            "+!g : not p__f(2,g) <- +p__f(2,g); ?g.\n"
            "-!g <- !g.\n"
            "+g <- .abolish(p__f(_,g)); .succeed_goal(g).\n"
            "-g <- .abolish(p__f(_,g)).\n");
}

TEST(GoalPattern, OfABlindCommitmentTriesForEver) {
  EXPECT_EQ(expand("bc(g)", "+!g <- a.").text, expand("bdg(g)", "+!g <- a.").text + "+!g <- !g.\n");
}

TEST(GoalPattern, MayNameAnotherPatternThatItBuildsUpon) {
  EXPECT_EQ(expand("bc(g, ebdg(g))", "+!g <- a.").text,
            expand("ebdg(g)", "+!g <- a.").text + "+!g <- !g.\n");
  EXPECT_EQ(expand("bc(g, dg)", "+!g <- a.").text,
            expand("dg(g)", "+!g <- a.").text + "+!g <- !g.\n");
  EXPECT_EQ(expand("mg(g, dg)", "+!g <- a.").text,
            "g.\n" + expand("dg(g)", "+!g <- a.").text + "-g <- !g.\n");
}

TEST(GoalPattern, OfASingleMindedCommitmentFailsTheGoalWhereItIsHopeless) {
  EXPECT_EQ(expand("smc(g, hopeless)", "+!g <- a.").text,
            expand("bc(g)", "+!g <- a.").text + "+hopeless <- .fail_goal(g).\n");
}

TEST(GoalPattern, OfARelativisedCommitmentEndsTheGoalWithItsMotive) {
  EXPECT_EQ(expand("rc(g, motive)", "+!g <- a.").text,
            expand("bc(g)", "+!g <- a.").text + "-motive <- .succeed_goal(g).\n");
}

TEST(GoalPattern, OfAnOpenMindedCommitmentHasBothEnds) {
  const std::string text = expand("omc(g, hopeless, motive)", "+!g <- a.").text;
  EXPECT_THAT(text, StartsWith(expand("bc(g)", "+!g <- a.").text));
  EXPECT_THAT(text, HasSubstr("+hopeless <- .drop_intention(g).\n"));
  EXPECT_THAT(text, HasSubstr("-motive <- .succeed_goal(g).\n"));
}

TEST(GoalPattern, OfAMaintenanceGoalPursuesWhatIsNoLongerSo) {
  EXPECT_EQ(expand("mg(g)", "+!g <- a.").text,
            "g.\n" + expand("bc(g)", "+!g <- a.").text + "-g <- !g.\n");
}

TEST(GoalPattern, OfASequencedAdoptionTakesOneGoalAtATime) {
  EXPECT_EQ(expand("sga(\"+t(X)\", \"c(X)\", g(X))", "").text,
            "+t(X) : not f__l(_) & c(X) <- !f__g(g(X)).\n"
            "+t(X) : f__l(_) & (c(X)) <- +f__l(g(X)).\n"
            "+!f__g(g(X)) <- +f__l(g(X)); !g(X); -f__l(g(X)).\n"
            "-!f__g(g(X)) <- -f__l(g(X)).\n"
            "-f__l(g(X)) : f__l(g(X)) <- !f__g(g(X)).\n");
  EXPECT_THAT(expand("sga(\"+t\", \"\", g)", "").text,
              StartsWith("+t : not f__l(_) & true <- !f__g(g).\n"));
}

TEST(GoalPattern, GivesUnnamedVariablesANameThatTheTextDoesNotHave) {
  // One variable throughout each plan that is made; `_1` is taken.
  EXPECT_EQ(expand("dg(g(_, [_|_]))", "+!g(_1, _) <- a.").text,
            "+!g(_4, [_3|_2]) : g(_4, [_3|_2]).\n"
            "+!g(_4, [_3|_2]) : .intend(g(_4, [_3|_2])).\n"
            "+!g(_1, _5) <- a; ?g(_1, _5).\n"
            "+g(_4, [_3|_2]) <- .succeed_goal(g(_4, [_3|_2])).\n");
}

TEST(GoalPattern, SaysHowManyArgumentsItNeeds) {
  EXPECT_EQ(expand("bdg", "+!g.").problem, "directive 'bdg' needs 1 argument");
  EXPECT_EQ(expand("smc(g)", "+!g.").problem, "directive 'smc' needs 2 arguments");
  EXPECT_EQ(expand("rc(g)", "+!g.").problem, "directive 'rc' needs 2 arguments");
  EXPECT_EQ(expand("omc(g, f)", "+!g.").problem, "directive 'omc' needs 3 arguments");
  EXPECT_EQ(expand("sga(\"+t\")", "+!g.").problem, "directive 'sga' needs 3 arguments");
}

TEST(GoalPattern, IsOneOfTheDirectivesThatAreSuggested) {
  for (const std::string& name : directive_names()) {
    const bool is_other = name == "include" || name == "namespace" || name == "register_function";
    EXPECT_NE(is_goal_pattern(name), is_other) << name;
  }
  EXPECT_FALSE(is_goal_pattern("end"));
}

}  // namespace
}  // namespace jaywalk
