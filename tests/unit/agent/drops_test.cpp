// SPDX-License-Identifier: Apache-2.0
// An agent's record of the intentions that it dropped, and their log lines.

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/agent.h"
#include "interpreter/compile/compiler.h"
#include "interpreter/mas/mas.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

struct Dropped {
  std::vector<DropCause> causes;
  std::vector<std::string> logged;
};

/// Runs one agent until it is idle.
Dropped dropped_by(const std::string& program) {
  const auto symbols = std::make_shared<SymbolTable>();
  Diagnostics diagnostics;
  const SourceTree tree =
      load_agent(std::make_shared<const Source>("x.asl", program), {}, diagnostics);
  const auto compiled = compile(tree, *symbols, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
  Dropped dropped;
  MasOptions options;
  options.log = [&](std::string_view line) { dropped.logged.emplace_back(line); };
  Mas mas(symbols, options, nullptr);
  const AgentId id = mas.add_agent({.name = "x", .program = compiled, .parameters = {}});
  mas.run();
  const auto& drops = mas.agent(id).drops();
  dropped.causes.assign(drops.begin(), drops.end());
  return dropped;
}

TEST(Drops, SayWhatFailedWhereAndOnBehalfOfWhichGoals) {
  const Dropped dropped = dropped_by("!go.\n+!go <- !a(1).\n+!a(X) <- .print(X);\n  .fail(no).\n");
  ASSERT_EQ(dropped.causes.size(), 1U);
  const DropCause& cause = dropped.causes.front();
  EXPECT_EQ(describe(cause), "internal_action, x.asl:4:3, .fail(no): fail");
  EXPECT_EQ(cause.goals, "go (x.asl:2) > a(1) (x.asl:4)");
  EXPECT_EQ(cause.times, 1U);
}

TEST(Drops, CountEqualOnesOnce) {
  const Dropped dropped =
      dropped_by("!go.\n+!go <- for (.range(I,1,5)) { !!f(I) }.\n+!f(I) <- ?b(I).\n");
  ASSERT_EQ(dropped.causes.size(), 1U);
  EXPECT_EQ(dropped.causes.front().times, 5U);
  EXPECT_EQ(dropped.causes.front().formula, "b(1)");
}

TEST(Drops, AreToldApartByPlaceAndError) {
  const Dropped dropped = dropped_by("!a. !b. !missing.\n+!a <- .fail; .fail.\n+!b <- !none.\n");
  std::vector<std::string> errors;
  for (const DropCause& cause : dropped.causes) errors.push_back(cause.error);
  EXPECT_THAT(errors, ::testing::UnorderedElementsAre("ia_failed", "no_relevant", "no_relevant"));
}

TEST(Drops, AreNoneWhereAPlanHandlesTheFailure) {
  EXPECT_THAT(dropped_by("!a.\n+!a <- .fail.\n-!a <- .print(well).\n").causes, IsEmpty());
}

TEST(Drops, AreNoneWhereTheProgramItselfDropsAnIntention) {
  EXPECT_THAT(dropped_by("!a.\n+!a <- .drop_intention(a); .print(x).\n").causes, IsEmpty());
}

TEST(Drops, OfAGoalWithoutAPlanForItsFailureThatCanBeUsed) {
  const Dropped dropped = dropped_by("!a.\n+!a <- .fail.\n-!a : false <- .print(x).\n");
  ASSERT_EQ(dropped.causes.size(), 1U);
  EXPECT_EQ(dropped.causes.front().error, "no_applicable");
}

TEST(Drops, OfADeepStackNameItsEnds) {
  const Dropped dropped =
      dropped_by("!c(0).\n+!c(N) : N < 50 <- !c(N+1); .print(N).\n+!c(N) <- .fail.\n");
  ASSERT_EQ(dropped.causes.size(), 1U);
  EXPECT_THAT(dropped.causes.front().goals, StartsWith("c(0) (x.asl:2) > c(1) (x.asl:2) > c(2)"));
  EXPECT_THAT(dropped.causes.front().goals, HasSubstr(" > ... 43 more ... > c(46)"));
  EXPECT_THAT(dropped.causes.front().goals, ::testing::EndsWith("c(50) (x.asl:3)"));
}

TEST(Drops, AreLoggedWithLineCaretAndGoalsTheFirstTime) {
  const Dropped dropped = dropped_by("!go. !go.\n+!go <- !a.\n+!a <- +b; .fail.\n");
  ASSERT_EQ(dropped.logged.size(), 2U);
  EXPECT_EQ(dropped.logged.front(),
            "[x] x.asl:3:12: no failure event was generated: ia_failed in .fail\n"
            "  +!a <- +b; .fail.\n"
            "             ^~~~~\n"
            "  goals: go (x.asl:2) > a (x.asl:3)");
  EXPECT_THAT(dropped.logged.back(), Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace jaywalk
