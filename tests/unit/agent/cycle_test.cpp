// SPDX-License-Identifier: Apache-2.0
// The reasoning cycle, step by step: what one cycle does, and what it leaves for the next.
// tests/conformance has the results of whole programs.

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
using ::testing::IsEmpty;

/// One agent, run cycle by cycle.
class Stepper {
 public:
  explicit Stepper(const std::string& program) {
    const auto symbols = std::make_shared<SymbolTable>();
    Diagnostics diagnostics;
    const SourceTree tree =
        load_agent(std::make_shared<const Source>("agent.asl", program), {}, diagnostics);
    const auto compiled = compile(tree, *symbols, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
    MasOptions options;
    options.print = [this](std::string_view line) {
      printed_.emplace_back(line.substr(line.find(' ') + 1));
    };
    mas_ = std::make_unique<Mas>(symbols, options, nullptr);
    mas_->add_agent({.name = "agent", .program = compiled, .parameters = {}});
  }

  /// The lines that the next cycle prints.
  std::vector<std::string> cycle() {
    printed_.clear();
    (void)mas_->step();
    return printed_;
  }
  /// The lines that the next cycles print, "-" for one that prints nothing.
  std::vector<std::string> cycles(int count) {
    std::vector<std::string> all;
    for (int i = 0; i < count; ++i) {
      const std::vector<std::string> now = cycle();
      all.push_back(now.empty() ? "-" : now.front());
    }
    return all;
  }
  [[nodiscard]] std::vector<std::string> beliefs() const {
    return mas_->describe_beliefs(AgentId{0});
  }
  [[nodiscard]] std::vector<std::string> intentions() const {
    return mas_->describe_intentions(AgentId{0});
  }
  [[nodiscard]] std::size_t events() const {
    return mas_->agent(AgentId{0}).circumstance().events.size();
  }

 private:
  std::vector<std::string> printed_;
  std::unique_ptr<Mas> mas_;
};

TEST(Cycle, SelectsOneEventAndExecutesOneFormula) {
  Stepper agent("!a. !b. +!a <- .print(1); .print(2). +!b <- .print(3); .print(4).");
  EXPECT_THAT(agent.cycles(5), ElementsAre("1", "2", "3", "4", "-"));
}

TEST(Cycle, TakesTurnsWithTheIntentions) {
  Stepper agent("!a. !b. +!a <- .print(1); .print(2); .print(3). +!b <- .print(4); .print(5).");
  EXPECT_THAT(agent.cycles(5), ElementsAre("1", "2", "4", "3", "5"));
}

TEST(Cycle, NeedsACycleForTheEventOfASubGoal) {
  Stepper agent("!a. +!a <- !b; .print(2). +!b <- .print(1).");
  // The goal is posted in the first cycle and its plan begins in the second.
  EXPECT_THAT(agent.cycles(3), ElementsAre("-", "1", "2"));
}

TEST(Cycle, PutsASubGoalOnTopOfItsIntention) {
  Stepper agent("!a. +!a <- !b. +!b <- .print(1); .print(2).");
  (void)agent.cycles(2);
  EXPECT_THAT(agent.intentions(), ElementsAre("a > b"));
  (void)agent.cycle();
  EXPECT_THAT(agent.intentions(), IsEmpty());
}

TEST(Cycle, WaitsForThePlanOfABeliefThatWasAdded) {
  Stepper agent("!a. +!a <- +b; .print(2). +b <- .print(1).");
  EXPECT_THAT(agent.cycles(3), ElementsAre("-", "1", "2"));
}

TEST(Cycle, NeedsACycleForTheEventOfABeliefWithoutPlan) {
  Stepper agent("!a. +!a <- +b; .print(1).");
  EXPECT_THAT(agent.cycles(2), ElementsAre("-", "1"));
  EXPECT_THAT(agent.beliefs(), ElementsAre("b[source(self)]"));
}

TEST(Cycle, GoesOnAtOnceIfNothingChanged) {
  Stepper agent("b. !a. +!a <- +b; .print(1).");
  EXPECT_THAT(agent.cycles(2), ElementsAre("-", "1"));
  EXPECT_EQ(agent.events(), 0U);
}

TEST(Cycle, DiscardsEventsThatNobodyWantsWithoutCost) {
  Stepper agent("b(1). b(2). b(3). !a. +!a <- .print(1).");
  EXPECT_THAT(agent.cycle(), ElementsAre("1"));
}

TEST(Cycle, TestsAnIfInAStepOfItsOwn) {
  Stepper agent("!a. +!a <- if (true) { .print(1) }; .print(2).");
  EXPECT_THAT(agent.cycles(3), ElementsAre("-", "1", "2"));
}

TEST(Cycle, TestsTheConditionOfALoopBeforeEachRound) {
  Stepper agent("!a. +!a <- for (.member(X, [1, 2])) { .print(X) }; .print(3).");
  EXPECT_THAT(agent.cycles(6), ElementsAre("-", "1", "-", "2", "-", "3"));
}

TEST(Cycle, SelectsNoOtherEventWhileAnAtomicIntentionRuns) {
  Stepper agent("!a. !b. @l[atomic] +!a <- .print(1); .print(2). +!b <- .print(3).");
  EXPECT_EQ(agent.events(), 2U);
  EXPECT_THAT(agent.cycles(2), ElementsAre("1", "2"));
  EXPECT_EQ(agent.events(), 1U);
  EXPECT_THAT(agent.cycle(), ElementsAre("3"));
}

TEST(Cycle, DropsAnIntentionThatIsDone) {
  Stepper agent("!a. +!a <- .print(1).");
  (void)agent.cycle();
  EXPECT_THAT(agent.intentions(), IsEmpty());
}

TEST(Cycle, KeepsTheFailedMeansUntilTheFailurePlanIsDone) {
  Stepper agent("!a. +!a <- !b; .print(2). +!b <- .fail. -!b <- .print(1); .print(9).");
  (void)agent.cycles(3);  // !b posted; .fail, -!b posted; -!b begins
  EXPECT_THAT(agent.intentions(), ElementsAre("a > b > -b"));
  EXPECT_THAT(agent.cycles(2), ElementsAre("9", "2"));
}

}  // namespace
}  // namespace jaywalk
