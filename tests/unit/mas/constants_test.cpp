// SPDX-License-Identifier: Apache-2.0
// Agents share the percepts that the environment declares constant, and the answers of rules that
// ask nothing else: only time and memory show it.

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/agent.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Agents perceive tick(T), lane(2,5), width(Cells), lane(6,9) and id(N) for three ticks; the lanes
/// and the width are constant.
class Road : public Environment {
 public:
  Road(SymbolTable& symbols, double width, bool says_so)
      : tick_(symbols.predicate("tick", 1)),
        lane_(symbols.predicate("lane", 2)),
        width_(symbols.predicate("width", 1)),
        id_(symbols.predicate("id", 1)),
        cells_(width),
        says_so_(says_so) {}

  void perceive(AgentId agent, Percepts& percepts) const override {
    percepts.add(tick_, {Value::number(now_)});
    add_constants(percepts);
    percepts.add(id_, {Value::number(static_cast<double>(agent) + 1)});
  }
  void constants(Percepts& percepts) const override {
    if (says_so_) add_constants(percepts);
  }
  void execute(std::span<const ActionRequest>, std::span<ActionResult>) override {}
  void advance() override { ++now_; }
  [[nodiscard]] bool finished() const override { return now_ == 4; }
  [[nodiscard]] double tick_ms() const override { return 100; }

 private:
  void add_constants(Percepts& percepts) const {
    percepts.add(lane_, {Value::number(2), Value::number(5)});
    percepts.add(width_, {Value::number(cells_)});
    percepts.add(lane_, {Value::number(6), Value::number(9)});
  }

  Predicate tick_;
  Predicate lane_;
  Predicate width_;
  Predicate id_;
  double cells_;
  bool says_so_;
  int now_ = 1;
};

/// A run of two agents, in a world that says what is constant and in one that does not.
struct Journey {
  explicit Journey(std::string_view program, bool says_so = true, MasOptions options = {})
      : system(std::move(options)), road(*system.symbols, 8, says_so) {
    system.add("a", program);
    system.add("b", program);
    system.agents[1].program = system.agents[0].program;
    outcome = system.run(&road);
  }
  [[nodiscard]] const Relation& relation(std::uint32_t agent, std::string_view name,
                                         std::uint16_t arity) const {
    return *system.mas->agent(AgentId{agent})
                .beliefs()
                .find(system.symbols->predicate(name, arity));
  }
  [[nodiscard]] bool shares(std::uint32_t agent, std::string_view name, std::uint16_t arity) const {
    return relation(agent, name, arity).is_shared();
  }
  [[nodiscard]] bool folds(std::uint32_t agent, std::string_view name, std::uint16_t arity) const {
    return relation(agent, name, arity).is_folded();
  }
  [[nodiscard]] std::vector<std::string> beliefs(std::uint32_t agent) const {
    return system.mas->describe_beliefs(AgentId{agent});
  }

  System system;
  Road road;
  RunOutcome outcome;
};

// Printed, believed and inferred is the same.
void expect_the_same(const Journey& a, const Journey& b) {
  EXPECT_EQ(a.system.printed, b.system.printed);
  EXPECT_EQ(a.system.logged, b.system.logged);
  EXPECT_EQ(a.beliefs(0), b.beliefs(0));
  EXPECT_EQ(a.beliefs(1), b.beliefs(1));
  EXPECT_EQ(a.outcome.inferences, b.outcome.inferences);
  EXPECT_EQ(a.outcome.message, b.outcome.message);
}

TEST(ConstantPercepts, AreShared) {
  const Journey run("!go. +!go.");
  EXPECT_TRUE(run.shares(0, "lane", 2));
  EXPECT_TRUE(run.shares(1, "width", 1));
  EXPECT_FALSE(run.shares(0, "tick", 1));
  EXPECT_FALSE(run.shares(0, "id", 1));
  expect_the_same(run, Journey("!go. +!go.", false));
}

TEST(ConstantPercepts, MakeEventsInTheOrderOfPerception) {
  constexpr std::string_view kProgram =
      "!go. +!go. +lane(X,_)[source(S)] <- .print(lane(X), S). +width(W) <- .print(W). +tick(1) <- "
      ".print(tick).";
  const Journey run(kProgram);
  EXPECT_THAT(run.system.printed,
              ElementsAre("[a] tick", "[a] lane(2)percept", "[a] 8", "[a] lane(6)percept",
                          "[b] tick", "[b] lane(2)percept", "[b] 8", "[b] lane(6)percept"));
  EXPECT_TRUE(run.shares(0, "lane", 2));
  expect_the_same(run, Journey(kProgram, false));
}

TEST(ConstantPercepts, AreTheAgentsOwnWhereItBelievesSomethingThereItself) {
  constexpr std::string_view kProgram =
      "width(3). !go. +!go : .my_name(a) <- +lane(0,1); -lane(2,5)[source(percept)]. "
      "+!go. +tick(3) <- .findall(X, lane(X,_), L); .findall(W, width(W), M); .print(L, M).";
  const Journey run(kProgram);
  EXPECT_THAT(run.system.printed, ElementsAre("[a] [2,0,6][8,3]", "[b] [6,2][8,3]"));
  EXPECT_FALSE(run.shares(0, "lane", 2));
  EXPECT_TRUE(run.shares(1, "lane", 2));
  EXPECT_FALSE(run.shares(1, "width", 1));
  expect_the_same(run, Journey(kProgram, false));
}

constexpr std::string_view kRules =
    "mine(3). "
    "wide(X, W) :- lane(X, To) & W = To - X + 1 & W < 9. "
    "here(X, To) :- mine(Row) & lane(X, To) & X <= Row & Row <= To. "
    "far(W) :- width(W) & here(X, _) & W > X. "
    "far(0) :- wide(6, _). "
    "any :- lane(X, _) & X > 5. "
    "none(X) :- lane(X, _) & X > 6. ";

TEST(FoldedRules, AreThoseOfConstantsAlone) {
  const Journey run(
      std::string(kRules) +
      "now(T, W) :- tick(T) & width(W). up(X) :- lane(X, _) & not tick(X). "
      "open(X, _) :- width(X). less(X, Y) :- X < Y & lane(X, Y). "
      "down(X) :- width(X). down(X) :- down(Y) & X = Y - 1 & X > 0. "
      "odd(X) :- width(W) & .member(X, [W]). gone(X) :- width(X) & nowhere(X). !go. +!go.");
  for (const auto& [name, arity] :
       {std::pair{"wide", 2}, {"here", 2}, {"far", 1}, {"any", 0}, {"none", 1}}) {
    EXPECT_TRUE(run.folds(0, name, static_cast<std::uint16_t>(arity))) << name;
  }
  for (const auto& [name, arity] : {std::pair{"now", 2},
                                    {"up", 1},
                                    {"open", 2},
                                    {"less", 2},
                                    {"down", 1},
                                    {"odd", 1},
                                    {"gone", 1}}) {
    EXPECT_FALSE(run.folds(0, name, static_cast<std::uint16_t>(arity))) << name;
  }
}

TEST(FoldedRules, AnswerAsTheRulesDo) {
  const std::string program =
      std::string(kRules) +
      "!go. +!go <- .findall(v(X,W), wide(X,W), A); .findall(v(X,T), here(X,T), B); .findall(W, "
      "far(W), "
      "C);"
      "  .findall(y, any, D); .findall(X, none(X), E); .print(A, B, C, D, E); ?wide(6,V); "
      "?here(X,5);"
      "  .print(V, X); !find(_). +!find(X) : far(X) & X < 5 <- .print(X). +!find(_) <- .print(no). "
      "+tick(2) : wide(Z,Z) <- .print(Z). +tick(3) : wide(X,W) & far(W + X) <- .print(X).";
  const Journey run(program);
  EXPECT_THAT(run.system.printed,
              ElementsAre("[a] [v(6,4),v(2,4)][v(2,5)][8,0][y][]", "[a] 42", "[a] 0",
                          "[b] [v(6,4),v(2,4)][v(2,5)][8,0][y][]", "[b] 42", "[b] 0"));
  expect_the_same(run, Journey(program, false));
}

TEST(FoldedRules, AreAskedAgainWhenSomethingTheyAreOfChanges) {
  const std::string program =
      std::string(kRules) +
      "!go. +!go : .my_name(a) <- ?here(X,_); .print(X); -+mine(7); ?here(Y,_); .print(Y);"
      "  +lane(7,7); .findall(Z, here(Z,_), L); .print(L); ?far(F); .print(F).  "
      "+!go <- ?here(X,_); .print(X); ?any; .wait(1); not none(_).";
  const Journey run(program);
  EXPECT_THAT(run.system.printed, ElementsAre("[a] 2", "[a] 6", "[a] [7,6]", "[a] 8", "[b] 2"));
  EXPECT_FALSE(run.folds(0, "here", 2));
  EXPECT_FALSE(run.folds(0, "far", 1));
  EXPECT_TRUE(run.folds(1, "here", 2));
  expect_the_same(run, Journey(program, false));
}

TEST(FoldedRules, MeetLimitsWhereTheRulesWould) {
  const std::string program = std::string(kRules) +
                              "pairs(X,Y) :- wide(X,_) & wide(_,Y) & wide(V,_) & V > 9. !go. +!go "
                              "<- ?pairs(_,_). -!go[error_msg(M)] <- .print(M).";
  for (std::uint64_t most = 1; most < 60; ++most) {
    MasOptions options;
    options.max_inferences = most;
    const Journey run(program, true, options);
    EXPECT_TRUE(run.folds(0, "wide", 2));
    expect_the_same(run, Journey(program, false, options));
    if (most == 20) {
      EXPECT_THAT(run.system.printed, ElementsAre(HasSubstr("more than 20 inferences"),
                                                  HasSubstr("more than 20 inferences")));
    }
  }
}

TEST(FoldedRules, AreAskedAnewInARunWithOtherConstants) {
  System system;
  system.add("a", "half(H) :- width(W) & H = W / 2. !go. +!go <- ?half(H); .print(H).");
  Mas mas(system.symbols, system.options, nullptr);
  for (const double width : {8.0, 8.0, 10.0}) {
    Road road(*system.symbols, width, true);
    mas.restart(system.options, &road);
    const AgentId id = mas.add_agent(system.agents.front());
    mas.run();
    EXPECT_TRUE(mas.agent(id).beliefs().find(system.symbols->predicate("half", 1))->is_folded());
  }
  EXPECT_THAT(system.printed, ElementsAre("[a] 4", "[a] 4", "[a] 5"));
}

}  // namespace
}  // namespace jaywalk
