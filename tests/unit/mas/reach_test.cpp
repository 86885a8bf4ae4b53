// SPDX-License-Identifier: Apache-2.0
#include "interpreter/mas/reach.h"

#include <gtest/gtest.h>

#include "tests/helpers/programs.h"

namespace jaywalk {
namespace {

Reach reach(std::string_view text) {
  const test::CompiledProgram compiled(text);
  EXPECT_EQ(compiled.errors(), "");
  return reach_of(*compiled.program, compiled.symbols);
}

TEST(Reach, OfAProgramThatKeepsToItselfIsNear) {
  const Reach of = reach(
      "b(1). r(X) :- b(X) & X > 0.\n"
      "+!g : r(X) <- +c(X); !!h; .print(X); .send(other, tell, c(X)); act.\n");
  EXPECT_FALSE(of.is_far || of.runs_terms || of.makes_terms || of.sends_plans);
}

TEST(Reach, IsFarWhereAgentsComeAndGo) {
  EXPECT_TRUE(reach("+!g <- .create_agent(bob, \"bob.asl\").\n").is_far);
  EXPECT_TRUE(reach("+!g <- .kill_agent(bob).\n").is_far);
}

TEST(Reach, IsFarWhereTheYellowPagesAreUsed) {
  EXPECT_TRUE(reach("+!g <- .df_register(seller).\n").is_far);
  EXPECT_TRUE(reach("+!g <- .df_search(seller, L).\n").is_far);
}

TEST(Reach, IsFoundWhereverItStands) {
  for (const char* text :
       {"r :- .df_search(a, L).\n", "+!g : .df_search(a, L) <- true.\n",
        "+!g <- if (b) { .df_search(a, L) }.\n", "+!g <- +later({ .df_search(a, L) }).\n",
        "plan({ .df_search(a, L) }).\n", "!g({ .df_search(a, L) }).\n"}) {
    EXPECT_TRUE(reach(text).is_far) << text;
  }
}

TEST(Reach, KnowsProgramsThatExecuteTerms) {
  EXPECT_TRUE(reach("+!g(A) <- A.\n").runs_terms);
  EXPECT_TRUE(reach("+!g(A) <- !A.\n").runs_terms);
  EXPECT_TRUE(reach("+!g(E) <- .wait(E).\n").runs_terms);
  EXPECT_FALSE(reach("+!g(A) <- !h(A).\n").runs_terms);
  EXPECT_FALSE(reach("+!g <- .wait(100).\n").runs_terms);
}

TEST(Reach, KnowsProgramsThatMakeTermsOfTexts) {
  EXPECT_TRUE(reach("+!g <- .term2string(T, \"f(1)\").\n").makes_terms);
  EXPECT_FALSE(reach("+!g <- .concat(\"a\", \"b\", S).\n").makes_terms);
}

TEST(Reach, KnowsWherePlansAreSent) {
  EXPECT_TRUE(reach("+!g <- .send(bob, tellHow, \"+!h.\").\n").sends_plans);
  EXPECT_TRUE(reach("+!g <- .send(bob, \"askHow\", \"+!h\").\n").sends_plans);
  EXPECT_FALSE(reach("+!g <- .send(bob, tell, h).\n").sends_plans);
}

/// Programs of one system.
class ReachesTest : public testing::Test {
 protected:
  const Program& add(std::string_view text) {
    programs_.push_back(std::make_unique<test::CompiledProgram>(text));
    reaches_.add(*programs_.back()->program, programs_.back()->symbols);
    return *programs_.back()->program;
  }
  Reaches reaches_;
  std::vector<std::unique_ptr<test::CompiledProgram>> programs_;
};

TEST_F(ReachesTest, LetWhoKeepsToItselfReasonBesideOthers) {
  const Program& near = add("+!g <- .print(1).\n");
  const Program& far = add("+!g <- .kill_agent(bob).\n");
  EXPECT_TRUE(reaches_.is_near(near));
  EXPECT_FALSE(reaches_.is_near(far));
}

TEST_F(ReachesTest, LetWhoExecutesTermsReasonBesideOthersUntilSomebodyHasAFarReach) {
  const Program& runs = add("+!g(A) <- A.\n");
  EXPECT_TRUE(reaches_.is_near(runs));
  add("+!g <- .kill_agent(bob).\n");
  EXPECT_FALSE(reaches_.is_near(runs)) << "it could be given that action";
}

TEST_F(ReachesTest, AreUnsureOfWhoExecutesTermsWhereTextsBecomeTerms) {
  const Program& runs = add("+!g(A) <- A.\n");
  add("+!g(S) <- .term2string(T, S).\n");
  EXPECT_FALSE(reaches_.is_near(runs));
}

TEST_F(ReachesTest, LetNobodyReasonBesideOthersWherePlansAreSent) {
  const Program& near = add("+!g <- .print(1).\n");
  add("+!g <- .send(bob, tellHow, \"+!h.\").\n");
  EXPECT_FALSE(reaches_.is_near(near));
}

TEST_F(ReachesTest, ChangeTheirVersionWithEachNewProgram) {
  const std::size_t before = reaches_.version();
  const Program& program = add("+!g.\n");
  const std::size_t after = reaches_.version();
  EXPECT_NE(after, before);
  reaches_.add(program, programs_.back()->symbols);
  EXPECT_EQ(reaches_.version(), after) << "it is known";
}

}  // namespace
}  // namespace jaywalk
