// SPDX-License-Identifier: Apache-2.0
#include "interpreter/coverage/coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/coverage/observed.h"

namespace jaywalk {
namespace {

using test::Observed;
using testing::HasSubstr;

constexpr const char* kProgram = R"(near(3).
far(X) :- near(Y) & X > Y.
!go(1).
+!go(X) : far(X) <- .print(a).
+!go(X) : not far(X) & X < 5
   <- !go(9);
      if (X > 0) { .print(b) } else { .print(c) }.
+!never <- .print(n).
)";

SourceCoverage covered(Observed& observed) {
  CoverageObserver observer(*observed.probes);
  observed.run(observer);
  return locate(*observed.probes, observer.counts(), observed.texts);
}

SourceCoverage covered(const std::string& program) {
  Observed observed(program);
  return covered(observed);
}

std::vector<CoveredPlan> plans(const SourceCoverage& coverage) {
  std::vector<CoveredPlan> plans;
  for (const auto& [place, plan] : coverage.files.at("agent.asl").plans) plans.push_back(plan);
  return plans;
}

std::string text(const std::vector<CoveredCondition>& conditions) {
  std::string text;
  for (const CoveredCondition& each : conditions) {
    text += each.text + " " + std::to_string(each.counts.asked) + "/" +
            std::to_string(each.counts.held) + "; ";
  }
  return text;
}

/// Counts calls, and gives no contexts or rules.
class Onlooker final : public ReasoningObserver {
 public:
  void plan_chosen(Agent&, const Plan&, const Event&, const Intention&) override { ++chosen; }
  void formula_executes(Agent&, const Intention&, const Step&) override { ++executed; }
  void event_posted(Agent&, const Event&) override { ++posted; }
  int chosen = 0;
  int executed = 0;
  int posted = 0;
};

TEST(Observers, EachSeesWhatItSeesAlone) {
  for (const bool first : {true, false}) {
    Observed alone(kProgram);
    Onlooker lonely;
    alone.run(lonely);
    Observed together(kProgram);
    Onlooker onlooker;
    CoverageObserver coverage(*together.probes);
    Observers observers;
    if (first) observers.add(onlooker);
    observers.add(coverage);
    if (!first) observers.add(onlooker);
    together.run(*observers.get());
    Observed counted(kProgram);
    const std::string expected = coverage_text(covered(counted));
    EXPECT_EQ(coverage_text(locate(*together.probes, coverage.counts(), together.texts)), expected);
    EXPECT_GT(lonely.executed, 0);
    EXPECT_EQ(onlooker.executed, lonely.executed);
    EXPECT_EQ(onlooker.chosen, lonely.chosen);
    EXPECT_EQ(onlooker.posted, lonely.posted);
  }
}

TEST(Observers, OfNobodyAreNone) {
  Observers observers;
  EXPECT_EQ(observers.get(), nullptr);
  Onlooker onlooker;
  observers.add(onlooker);
  EXPECT_EQ(observers.get(), &onlooker);
}

TEST(PlanCoverage, CountsHowOftenPlansWereRelevantApplicableAndChosen) {
  const auto found = plans(covered(kProgram));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].trigger, "+!go(X)");
  EXPECT_EQ(found[0].counts.relevant, 2U);
  EXPECT_EQ(found[0].counts.applicable, 1U);
  EXPECT_EQ(found[0].counts.chosen, 1U);
  EXPECT_EQ(found[1].counts.relevant, 1U);
  EXPECT_EQ(found[1].counts.chosen, 1U);
  EXPECT_EQ(found[2].counts.relevant, 0U);
}

TEST(PlanCoverage, TellsEachConditionOfContextsAndRulesApart) {
  const SourceCoverage coverage = covered(kProgram);
  const auto found = plans(coverage);
  EXPECT_EQ(text(found[0].conditions), "far(X) 2/1; ");
  EXPECT_EQ(text(found[1].conditions), "far(X) 1/0; X < 5 1/1; ");
  const auto& rules = coverage.files.at("agent.asl").rules;
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules.begin()->second.head, "far(X)");
  EXPECT_EQ(text(rules.begin()->second.conditions), "near(Y) 3/3; X > Y 3/1; ");
}

TEST(PlanCoverage, CountsFormulasWithinStatements) {
  const auto found = plans(covered(kProgram));
  std::string seen;
  for (const CoveredFormula& formula : found[1].formulas) {
    seen +=
        std::to_string(formula.where.line) + ":" + std::to_string(formula.counts.executed) + " ";
  }
  EXPECT_EQ(seen, "6:1 7:1 7:1 7:0 ");
  EXPECT_EQ(found[2].formulas.at(0).counts.executed, 0U);
}

// A context begins without a frame, and goes on with one at the first query that leaves a choice.
TEST(PlanCoverage, CountsOnceWhatWasAskedBeforeAChoice) {
  const auto found = plans(
      covered("ready. few(1). few(2). few(3).\n"
              "!go.\n"
              "+!go : ready & few(X) & X > 2 & not (ready & few(Y) & Y > 3) <- .print(X).\n"));
  EXPECT_EQ(text(found[0].conditions),
            "ready 1/1; few(X) 1/1; X > 2 3/1; ready 1/1; few(Y) 1/1; Y > 3 3/0; ");
}

TEST(PlanCoverage, TakesNoInferences) {
  const std::string program =
      "few(1). few(2). near(X) :- few(X) & X > 1.\n"
      "!go(5). +!go(0). +!go(N) : near(X) & few(X) <- !go(N - 1).\n";
  Observed plain(program);
  Onlooker onlooker;
  Observed covered(program);
  CoverageObserver coverage(*covered.probes);
  const std::uint64_t inferences = plain.run(onlooker).inferences;
  EXPECT_GT(inferences, 15U);  // three at least for each of the five goals
  EXPECT_EQ(covered.run(coverage).inferences, inferences);
}

TEST(PlanCoverage, CountsARuleThatAsksItselfAskingByAsking) {
  const SourceCoverage coverage = covered(
      "above(0).\n"
      "sum(0, 0) :- true.\n"
      "sum(N, S) :- N > 0 & sum(N - 1, T) & S = T + N.\n"
      "!go.\n"
      "+!go : sum(3, S) & S > 5 <- .print(S).\n");
  const auto& rules = coverage.files.at("agent.asl").rules;
  // Asked for 3, 2, 1 and 0, which is not above 0.
  EXPECT_EQ(text(std::next(rules.begin())->second.conditions),
            "N > 0 3/3; sum(N - 1, T) 3/3; S = T + N 3/3; ");
}

TEST(PlanCoverage, CountsAConditionThatFailsOnlyAfterBacktrackingAsHeld) {
  const auto found =
      plans(covered("p(1). p(2). p(3).\n"
                    "!go.\n"
                    "+!go : p(X) & X > 2 <- .print(X).\n"));
  EXPECT_EQ(text(found[0].conditions), "p(X) 1/1; X > 2 3/1; ");
}

TEST(PlanCoverage, CountsFormulasThatFail) {
  const auto found =
      plans(covered("!go.\n"
                    "+!go <- ?unknown; .print(never).\n"
                    "-!go <- .print(failed).\n"));
  EXPECT_EQ(found[0].formulas.at(0).counts.executed, 1U);
  EXPECT_EQ(found[0].formulas.at(0).counts.failed, 1U);
  EXPECT_EQ(found[0].formulas.at(1).counts.executed, 0U);
  EXPECT_EQ(found[1].counts.chosen, 1U);
}

TEST(PlanCoverage, LooksIntoBranchesOfForks) {
  const auto found =
      plans(covered("!go.\n"
                    "+!go <- { .print(a) } |&| { .print(b); .print(c) }; .print(d).\n"));
  ASSERT_EQ(found[0].formulas.size(), 5U);
  for (const CoveredFormula& formula : found[0].formulas) {
    EXPECT_EQ(formula.counts.executed, 1U) << formula.text;
  }
}

TEST(PlanCoverage, ChangesNothing) {
  // Contexts that draw random numbers, print, bind what events ask for, and go back.
  const std::string program =
      "lot(a). lot(b). lot(c).\n"
      "drawn(L) :- lot(L) & .random(R) & .print(L, R) & R > 0.6.\n"
      "!go(8).\n"
      "+!go(N) : N > 0 & drawn(L) & not L = b <- !ask(L, W); .print(N, L, W); !go(N - 1).\n"
      "+!go(N) : N > 0 <- .print(none); !go(N - 1).\n"
      "+!go(_).\n"
      "+!ask(L, W) : lot(W) & W \\== L & math.random(2) > 1 <- .print(asked).\n"
      "+!ask(_, W) <- W = nothing.\n";
  Observed looked_at(program);
  CoverageObserver observer(*looked_at.probes);
  looked_at.run(observer);
  test::System alone;
  alone.add("agent", program);
  (void)alone.run();
  EXPECT_GT(alone.printed.size(), 8U);
  EXPECT_EQ(looked_at.system.printed, alone.printed);
  EXPECT_EQ(looked_at.system.mas->outcome().cycles, alone.mas->outcome().cycles);
}

TEST(PlanCoverage, LeavesRulesAsDataAsTheyAreWritten) {
  Observed observed(
      "far(X) :- near(Y) & X > Y.\n"
      "!go.\n"
      "+!go <- .relevant_rules(far(_), Rules); .print(Rules).\n");
  (void)covered(observed);
  ASSERT_EQ(observed.system.printed.size(), 1U);
  EXPECT_THAT(observed.system.printed[0], testing::Not(HasSubstr("condition_")));
}

TEST(PlanCoverage, AddsReportsUpByPlace) {
  SourceCoverage sum = covered(kProgram);
  sum.add(covered(kProgram));
  EXPECT_EQ(plans(sum)[0].counts.relevant, 4U);
  EXPECT_EQ(text(plans(sum)[0].conditions), "far(X) 4/2; ");
  EXPECT_EQ(sum.totals().plans.covered, 2U);
  EXPECT_EQ(sum.totals().plans.of, 3U);
}

TEST(ACoverageListing, ShowsCountsBeforeLinesAndGapsBelow) {
  const std::string listing = coverage_text(covered(kProgram));
  EXPECT_THAT(listing, HasSubstr("          2:    4:+!go(X) : far(X) <- .print(a).\n"));
  EXPECT_THAT(listing, HasSubstr("^ never true: far(X)\n"));
  EXPECT_THAT(listing, HasSubstr("^ never false: X < 5\n"));
  EXPECT_THAT(listing, HasSubstr("^ never executed: .print(c)\n"));
  EXPECT_THAT(listing, HasSubstr("      #####:    8:+!never <- .print(n).\n"
                                 "                 ^ no such event: +!never\n"));
}

TEST(ATracefile, HasPlansAsFunctionsConditionsAsBranchesAndFormulasAsLines) {
  const std::string info = coverage_lcov(covered(kProgram));
  EXPECT_THAT(info, HasSubstr("SF:agent.asl\n"));
  EXPECT_THAT(info, HasSubstr("FN:4,+!go(X):4:1\n"));
  EXPECT_THAT(info, HasSubstr("FNDA:0,+!never:8:1\n"));
  EXPECT_THAT(info, HasSubstr("FNF:3\nFNH:2\n"));
  EXPECT_THAT(info, HasSubstr("BRDA:4,0,0,1\nBRDA:4,0,1,1\n"));
  EXPECT_THAT(info, HasSubstr("DA:8,0\n"));
  EXPECT_THAT(info, HasSubstr("end_of_record\n"));
}

TEST(ACoveragePage, EscapesWhatProgramsSay) {
  const std::string page = coverage_html(covered("!a.\n+!a <- .print(\"<script>\").\n"), "a & b");
  EXPECT_THAT(page, HasSubstr("<title>Coverage of a &amp; b</title>"));
  EXPECT_THAT(page, HasSubstr(".print(&quot;&lt;script&gt;&quot;)"));
  EXPECT_THAT(page, testing::Not(HasSubstr("<script>")));
}

TEST(ACoveragePage, SaysWhatRan) {
  const std::string page = coverage_html(covered("!a.\n+!a.\n"), "paper.gpkg: election; 3 agents");
  EXPECT_THAT(page, HasSubstr("<p class=\"subject\">paper.gpkg: election; 3 agents</p>"));
}

TEST(ACoveragePage, KeepsItsColoursInPrint) {
  EXPECT_THAT(coverage_html(covered("!a.\n+!a.\n"), "a"), HasSubstr("print-color-adjust: exact"));
}

}  // namespace
}  // namespace jaywalk
