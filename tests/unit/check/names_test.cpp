// SPDX-License-Identifier: Apache-2.0
// What editors ask for: where a program uses which name, and as what.

#include <memory>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/check/index/lsp_names.h"

namespace jaywalk::lsp {
namespace {

/// A program of one file and its uses.
struct Named {
  explicit Named(const std::string& text) {
    Diagnostics diagnostics;
    program = load_agent(std::make_shared<const Source>("test", text), {}, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.render();
    uses = uses_of_names(program);
  }

  /// `goal g/0`, a word for each use in their order, those that define with a `!` behind.
  [[nodiscard]] std::string text() const {
    constexpr std::array kWords{"goal", "belief", "action", "internal"};
    std::string all;
    for (const Use& use : uses) {
      all += fmt::format("{}{} {}/{}{}{}", all.empty() ? "" : ", ",
                         kWords[static_cast<std::size_t>(use.what)], use.name, use.arity,
                         use.defines ? "!" : "", use.in_message ? " told" : "");
    }
    return all;
  }

  SourceTree program;
  std::vector<Use> uses;
};

std::string names(const std::string& text) { return Named(text).text(); }

TEST(Names, OfBeliefsAndRulesDefineThem) {
  EXPECT_EQ(names("b(1).\nr(X) :- b(X) & not c.\n"),
            "belief b/1!, belief r/1!, belief b/1, belief c/0");
}

TEST(Names, OfGoalsAreDefinedByTheirPlans) {
  EXPECT_EQ(names("!g.\n+!g <- !h(1); !!h(2).\n-!g.\n"),
            "goal g/0, goal g/0!, goal h/1, goal h/1, goal g/0");
}

TEST(Names, OfBeliefsInBodiesAreReferences) {
  EXPECT_EQ(names("+!g <- +b; -c; -+d(1); ?e(X).\n"),
            "goal g/0!, belief b/0, belief c/0, belief d/1, belief e/1");
}

TEST(Names, OfTriggersOfBeliefsAreReferences) {
  EXPECT_EQ(names("+b(X) : c <- act(X).\n"), "belief b/1, belief c/0, action act/1");
}

TEST(Names, OfActionsAndInternalActionsDiffer) {
  EXPECT_EQ(names("+!g <- move(left); .print(x); my.act(1).\n"),
            "goal g/0!, action move/1, internal .print/1, internal my.act/1");
}

TEST(Names, OfConditionsAreBeliefsInsideConnectivesToo) {
  EXPECT_EQ(names("+!g : a & (b | not c(1)) <- true.\n"),
            "goal g/0!, belief a/0, belief b/0, belief c/1");
}

TEST(Names, OfQueriesInInternalActionsAreBeliefs) {
  EXPECT_EQ(names("+!g <- .findall(X, b(X), L); .count(c, N).\n"),
            "goal g/0!, internal .findall/3, belief b/1, internal .count/2, belief c/0");
}

TEST(Names, OfGoalsInInternalActionsAreGoals) {
  EXPECT_EQ(names("+!g <- .drop_intention(h(1)); .intend(i).\n"),
            "goal g/0!, internal .drop_intention/1, goal h/1, internal .intend/1, goal i/0");
}

TEST(Names, OfMessagesAreWhatTheirPerformativesSay) {
  EXPECT_EQ(names("+!g <- .send(bob, tell, b(1)); .send(bob, achieve, h).\n"),
            "goal g/0!, internal .send/3, belief b/1 told, internal .send/3, goal h/0 told");
  EXPECT_EQ(names("+!g <- .broadcast(untell, b).\n"),
            "goal g/0!, internal .broadcast/2, belief b/0 told");
}

TEST(Names, OfDataAreLeftOut) {
  EXPECT_EQ(names("b(c(d)).\n+!g(e) <- act(f(1)).\n"), "belief b/1!, goal g/1!, action act/1");
}

TEST(Names, OfProgramsAsTermsAreTheirOwn) {
  EXPECT_EQ(names("+!g <- .add_plan({ +!h <- act }).\n"),
            "goal g/0!, internal .add_plan/1, goal h/0!, action act/0");
}

TEST(Names, InStatementsAreFound) {
  EXPECT_EQ(names("+!g <- if (b) { !h } else { act }; while (c(X)) { -c(X) }.\n"),
            "goal g/0!, belief b/0, goal h/0, action act/0, belief c/1, belief c/1");
}

TEST(Names, StandWhereTheyAreWritten) {
  const std::string text = "+!go(1) <- near(x).\n";
  const Named named(text);
  ASSERT_EQ(named.uses.size(), 2U);
  EXPECT_EQ(
      text.substr(named.uses[0].span.begin, named.uses[0].span.end - named.uses[0].span.begin),
      "go");
  EXPECT_EQ(named.uses[1].span.begin, text.find("near"));
  EXPECT_EQ(named.uses[1].span.end, text.find("(x)"));
}

TEST(UseAt, CoversTheNameAndItsEnd) {
  const std::string text = "!go.\n+!go <- walk.\n";
  const Named named(text);
  const ast::File& file = named.program.main();
  EXPECT_EQ(use_at(named.uses, file, 0), nullptr) << "the operator";
  EXPECT_EQ(use_at(named.uses, file, 1), &named.uses[0]);
  EXPECT_EQ(use_at(named.uses, file, 3), &named.uses[0]) << "behind the name";
  EXPECT_EQ(use_at(named.uses, file, 4), nullptr);
  const auto walk = static_cast<std::uint32_t>(text.find("walk"));
  EXPECT_EQ(use_at(named.uses, file, walk + 2)->name, "walk");
  EXPECT_EQ(use_at(named.uses, file, 1000), nullptr);
}

TEST(Uses, AreOfOneNameIfKindAndArgumentsAgree) {
  const Named named("b(1). !b(1). b(1,2).\n+!g : b(X).\n");
  EXPECT_FALSE(named.uses[0].is_same_name(named.uses[1])) << "a goal";
  EXPECT_FALSE(named.uses[0].is_same_name(named.uses[2])) << "two arguments";
  EXPECT_TRUE(named.uses[0].is_same_name(named.uses.back()));
}

TEST(Uses, KnowThePlanOfTheirGoal) {
  const Named named("!g.\n+!g <- true.\n+b.\n");
  EXPECT_EQ(named.uses[0].plan, nullptr);
  EXPECT_NE(named.uses[1].plan, nullptr);
  EXPECT_NE(named.uses[2].plan, nullptr) << "a reaction to a belief, too";
}

}  // namespace
}  // namespace jaywalk::lsp
