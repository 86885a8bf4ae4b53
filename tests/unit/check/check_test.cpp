// SPDX-License-Identifier: Apache-2.0
#include "interpreter/check/check.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

const Vocabulary kRoad = {
    .environment_known = true,
    .percepts = {{.name = "position", .least_args = 2, .most_args = 2, .summary = {}}},
    .actions = {{.name = "move", .least_args = 1, .most_args = 1, .summary = {}}},
    .internal_actions = {
        {.name = ".print", .least_args = 0, .most_args = -1, .summary = {}},
        {.name = ".findall", .least_args = 3, .most_args = 3, .summary = "collects"},
        {.name = ".send", .least_args = 3, .most_args = 5, .summary = {}},
        {.name = "math.abs", .least_args = 1, .most_args = 1, .summary = {}}}};

TEST(Check, WarnsOfGoalsWithoutPlans) {
  for (const auto& [text, warnings] : {
           Row{"!strat. +!start.",
               "1: unknown-goal: no plan for the goal 'strat' (did you mean 'start'?)\n"},
           Row{"+!go <- !wlak. +!walk.",
               "1: unknown-goal: no plan for the goal 'wlak' (did you mean 'walk'?)\n"},
           Row{"+!go <- if (a) { !!none }.", "1: unknown-goal: no plan for the goal 'none'\n"},
           Row{"+!go <- a ||| (b; !none).", "1: unknown-goal: no plan for the goal 'none'\n"},
           Row{"!go(1). +!go.",
               "1: wrong-arity: no plan for the goal 'go' with 1 argument (there are plans for it "
               "with 0 arguments)\n"},
           Row{"+!go. { +!sub <- !none. }", "1: unknown-goal: no plan for the goal 'none'\n"},
       }) {
    EXPECT_EQ(warnings_of(text), warnings) << text;
  }
}

TEST(Check, IsSilentWhereAPlanMayExist) {
  for (const char* text : {
           "!go. +!go. +!gone. +!x <- !gone.",
           "!go. +!G.",
           "!go(1). { begin bdg(go(X)) } +!go(X) <- a. { end }",
           "+!a <- .add_plan(P); !b.",
           "+!a <- .add_plan({+!b}); !b.",
           "+!a <- +{+!b <- c}; !b.",
           "+!a <- .send(x, tellHow, {+!b <- !nowhere}).",
           "+!a <- !kqml_received(a,b,c,d).",
           "+!a(X) <- !X.",
           "!n::go. { begin namespace(n) } +!go. { end }",
       }) {
    EXPECT_EQ(warnings_of(text), "") << text;
  }
}

TEST(Check, KnowsThatPlansMayBeInFilesThatAreMissing) {
  Diagnostics diagnostics;
  const auto source =
      std::make_shared<const Source>("test", "{ include(\"none.asl\") } !go. +!a : counterr(_).");
  const SourceTree program = load_agent(source, {}, diagnostics);
  ASSERT_EQ(diagnostics.warning_count(), 1U);
  check_program(program, kRoad, diagnostics);
  EXPECT_EQ(diagnostics.warning_count(), 1U) << diagnostics.render();
}

TEST(Check, WarnsOfPlansWhoseGoalIsMisspelt) {
  EXPECT_EQ(warnings_of("!cross. +!cross : a <- b. +!corss <- c."),
            "1: unused-plan: nobody posts the goal 'corss' (did you mean 'cross'?)\n");
  EXPECT_EQ(warnings_of("!cross. +!cross. +!crossing. +!another."), "")
      << "they may be asked for by others";
  EXPECT_EQ(warnings_of("!cross. +!cross <- .send(x, achieve, corss). +!corss."), "");
}

TEST(Check, WarnsOfBeliefsWhoseNameIsAlmostAnother) {
  for (const auto& [text, warnings] : {
           Row{"counter(0). +!go : conuter(X) <- a.",
               "1: unknown-belief: 'conuter' is neither a belief nor a percept (did you mean "
               "'counter'?)\n"},
           Row{"counter(0). h :- not conuter(_).",
               "1: unknown-belief: 'conuter' is neither a belief nor a percept (did you mean "
               "'counter'?)\n"},
           Row{"+!go <- +counter(0); ?conuter(X).",
               "1: unknown-belief: 'conuter' is neither a belief nor a percept (did you mean "
               "'counter'?)\n"},
           Row{"counter(0). +!go <- while (conuter(X)) { a }.",
               "1: unknown-belief: 'conuter' is neither a belief nor a percept (did you mean "
               "'counter'?)\n"},
           Row{"counter(0). +!go <- .findall(X, a(X) & conuter(X), L).",
               "1: unknown-belief: 'conuter' is neither a belief nor a percept (did you mean "
               "'counter'?)\n"},
       }) {
    EXPECT_EQ(warnings_of(text), warnings) << text;
  }
}

TEST(Check, IsSilentWhereABeliefMayComeFromElsewhere) {
  for (const char* text : {
           "+!go : anything(X) <- a.",
           "counter(0). +!go : counter(X,Y) <- a.",
           "pos_x(0). +!go : pos_y(X) <- a.",
           "speed1(0). +!go : speed2(X) <- a.",
           "bid(1). +!go : bids(X) <- a.",
           "counter(0). +conuter(X). +!go : conuter(X) <- a.",
           "counter(0). +!go : conuter(X) <- .send(x, tell, conuter(1)).",
           "counter(0). +!go : conuter(X) <- +X.",
           "counter(0). +?conuter(X). +!go <- ?conuter(X).",
           "+!go : ~counter(X) & counter(X) <- a.",
       }) {
    EXPECT_EQ(warnings_of(text), "") << text;
  }
}

TEST(Check, KnowsTheEnvironmentsPercepts) {
  for (const auto& [text, warnings] : {
           Row{"+!go : position(X,Y) <- move(X).", ""},
           Row{"+!go : postion(X,Y) <- move(X).",
               "1: unknown-belief: 'postion' is neither a belief nor a percept (did you mean "
               "'position'?)\n"},
           Row{"+!go : nothing_like_it <- move(X).",
               "1: unknown-belief: 'nothing_like_it' is neither a belief nor a percept\n"},
           Row{"+!go : position(X) <- move(X).",
               "1: wrong-arity: nothing is known of 'position' with 1 argument (it is known "
               "with "
               "2 arguments)\n"},
           Row{"+!go : nothing_like_it <- .send(a, tell, b).", ""},
       }) {
    EXPECT_EQ(warnings_of(text, kRoad), warnings) << text;
  }
}

TEST(Check, KnowsTheEnvironmentsActions) {
  for (const auto& [text, warnings] : {
           Row{"+!go <- move(left).", ""},
           Row{"+!go <- X.", ""},
           Row{"+!go <- mvoe(left).",
               "1: unknown-action: the environment has no action 'mvoe' (did you mean 'move'?)\n"},
           Row{"+!go <- move(left,1).",
               "1: wrong-arity: the action 'move' has 1 argument, not 2\n"},
           Row{"+!go <- walk. +!walk.",
               "1: unknown-action: the environment has no action 'walk' (there are plans for it: "
               "write '!walk')\n"},
           Row{"counter(0). +!go <- counter(X).",
               "1: unknown-action: the environment has no action 'counter' (to ask for a belief, "
               "write '?counter')\n"},
       }) {
    EXPECT_EQ(warnings_of(text, kRoad), warnings) << text;
  }
  EXPECT_EQ(warnings_of("+!go <- anything(1)."), "");
}

TEST(Check, KnowsActionsOfOneNameByAllTheirNumbersOfArguments) {
  Vocabulary road = kRoad;
  road.actions.push_back(
      {.name = "move", .least_args = 2, .most_args = 2, .summary = {}, .values = {}});
  EXPECT_EQ(warnings_of("+!go <- move(left); move(left,1).", road), "");
  EXPECT_EQ(warnings_of("+!go <- move.", road),
            "1: wrong-arity: the action 'move' has 1 or 2 arguments, not 0\n");
}

TEST(Check, KnowsInternalActionsAndFunctions) {
  for (const auto& [text, warnings] : {
           Row{"+!go <- .print(1); X = math.abs(-1) + 1.", ""},
           Row{"+!go <- .prnit(1).",
               "1: unknown-internal-action: there is no internal action '.prnit' (did you mean "
               "'.print'?)\n"},
           Row{"+!go : .findall(X,Y) <- .print.",
               "1: wrong-arity: '.findall' has 3 arguments, not 2 (collects)\n"},
           Row{"+!go <- .send(a).", "1: wrong-arity: '.send' has 3 to 5 arguments, not 1\n"},
           Row{"+!go <- X = math.asb(1).",
               "1: unknown-internal-action: there is no internal action 'math.asb' (did you mean "
               "'math.abs'?)\n"},
           Row{"{ register_function(\"my.f\",1,\"p\") } +!go <- X = my.f(1).", ""},
       }) {
    EXPECT_EQ(warnings_of(text, kRoad), warnings) << text;
  }
  EXPECT_EQ(warnings_of("+!go <- .anything."), "");
}

TEST(Check, FindsInternalActionsWithoutTheirDot) {
  Vocabulary known;
  known.internal_actions = {{".wait", 1, 4, "waits"}, {".print", 0, -1, "prints"}};
  EXPECT_EQ(
      warnings_of("!g. +!g <- wait(500); print(a).", known),
      "1: unknown-action: 'wait' is an action of an environment (internal actions begin with a "
      "dot: '.wait')\n"
      "1: unknown-action: 'print' is an action of an environment (internal actions begin with "
      "a dot: '.print')\n");
  EXPECT_EQ(warnings_of("!g. +!g <- wait; .print(a).", known), "") << "another action";
  EXPECT_EQ(warnings_of("!g. +!g <- walk(1); wait(500).", known), "")
      << "there is an environment, which may have it";
  known.environment_known = true;
  known.actions = {{"walk", 1, 1, ""}};
  EXPECT_EQ(
      warnings_of("!g. +!g <- walk(1); wait(500).", known),
      "1: unknown-action: the environment has no action 'wait' (internal actions begin with a "
      "dot: '.wait')\n");
}

TEST(Check, IsSilencedByAComment) {
  EXPECT_EQ(warnings_of("!go. // jaywalk: allow unknown-goal"), "");
  EXPECT_EQ(warnings_of("// jaywalk: allow unused-plan, unknown-goal\n!go."), "");
  EXPECT_NE(warnings_of("!go. // jaywalk: allow unknown-belief"), "");
  EXPECT_NE(warnings_of("!go. // jaywalk: allow unknown-goals"), "");
  EXPECT_NE(warnings_of("// jaywalk: allow unknown-goal\n\n!go."), "");
  EXPECT_EQ(warnings_of("!go.\n\n!come.\n// jaywalk: allow-file unknown-belief, unknown-goal"), "");
  EXPECT_NE(warnings_of("!go.\n\n// jaywalk: allow-file unknown-belief"), "");
}

TEST(Check, WarnsInTheOrderOfTheText) {
  EXPECT_EQ(warnings_of("+!go\n <- !a;\n .prnit(1);\n !b.", kRoad),
            "2: unknown-goal: no plan for the goal 'a'\n"
            "3: unknown-internal-action: there is no internal action '.prnit' (did you mean "
            "'.print'?)\n"
            "4: unknown-goal: no plan for the goal 'b'\n");
}

}  // namespace
}  // namespace jaywalk
