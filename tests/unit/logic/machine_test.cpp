// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/machine.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/generate.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct QueryRow {
  std::string formula;
  std::string shown;
  std::vector<std::string> answers;
};

void expect_answers(std::string_view program, const std::vector<QueryRow>& rows) {
  for (const QueryRow& row : rows) {
    test::Terms terms;
    terms.believe(program);
    EXPECT_EQ(terms.answers(row.formula, row.shown), row.answers) << row.formula;
  }
}

TEST(Machine, AnswersFromFactsInTheirOrder) {
  expect_answers("p(3). p(1). p(2). q(2). q(3). r.", {
                                                         {"p(X)", "X", {"3", "1", "2"}},
                                                         {"p(X) & q(X)", "X", {"3", "2"}},
                                                         {"q(X) & p(X)", "X", {"2", "3"}},
                                                         {"r", "yes", {"yes"}},
                                                         {"s", "yes", {}},
                                                         {"p(4)", "yes", {}},
                                                     });
}

TEST(Machine, TriesTheLeftOfADisjunctionFirst) {
  expect_answers("p(1). p(2). q(3).", {
                                          {"p(X) | q(X)", "X", {"1", "2", "3"}},
                                          {"q(X) | p(X)", "X", {"3", "1", "2"}},
                                          {"(p(X) | q(X)) & X > 1", "X", {"2", "3"}},
                                          {"p(X) & (X = 2 | X = 1)", "X", {"1", "2"}},
                                          {"false | true", "yes", {"yes"}},
                                          {"true | true", "yes", {"yes", "yes"}},
                                      });
}

TEST(Machine, NegatesWithoutBinding) {
  expect_answers("p(1). p(2). q(2).", {
                                          {"p(X) & not q(X)", "X", {"1"}},
                                          {"not p(3)", "yes", {"yes"}},
                                          {"not p(1)", "yes", {}},
                                          {"not p(X)", "X", {}},
                                          {"not (not p(X))", "X", {"X"}},
                                          {"not (p(X) & q(X)) | p(X)", "X", {"1", "2"}},
                                          {"not false & p(X)", "X", {"1", "2"}},
                                          {"not (X = 1 & false) & p(X)", "X", {"1", "2"}},
                                      });
}

TEST(Machine, SolvesRelations) {
  expect_answers("", {
                         {"X = 1 & X == 1", "X", {"1"}},
                         {"1 == 1.0", "yes", {"yes"}},
                         {"1 \\== 2", "yes", {"yes"}},
                         {"a < b", "yes", {"yes"}},
                         {"10 < 9", "yes", {}},
                         {"\"10\" < \"9\"", "yes", {"yes"}},
                         {"1 < a", "yes", {"yes"}},
                         {"f(2) > f(1,0)", "yes", {"yes"}},
                         {"X == Y", "yes", {}},
                         {"X == X", "yes", {"yes"}},
                         {"3 >= 3 & 3 <= 3", "yes", {"yes"}},
                         {"[1,2] = [H|T]", "f(H,T)", {"f(1,[2])"}},
                         {"X = Y & Y = 3", "X", {"3"}},
                     });
}

TEST(Machine, AnswersFromRulesAndFactsInTheirOrder) {
  expect_answers("p(1). p(X) :- q(X). p(2). q(8). q(9).", {
                                                              {"p(X)", "X", {"1", "8", "9", "2"}},
                                                              {"p(9)", "yes", {"yes"}},
                                                              {"p(7)", "yes", {}},
                                                          });
}

TEST(Machine, GoesBackIntoRules) {
  expect_answers(R"(
      edge(a,b). edge(b,c). edge(c,d). edge(b,e).
      path(X,Y) :- edge(X,Y).
      path(X,Y) :- edge(X,Z) & path(Z,Y).
      app([],L,L).
      app([H|T],L,[H|R]) :- app(T,L,R).
      )",
                 {
                     {"path(a,X)", "X", {"b", "c", "e", "d"}},
                     {"path(X,d)", "X", {"c", "a", "b"}},
                     {"app(A,B,[1,2])", "f(A,B)", {"f([],[1,2])", "f([1],[2])", "f([1,2],[])"}},
                     {"app([1],[2],R)", "R", {"[1,2]"}},
                     {"app(A,[X],[1,2,3])", "X", {"3"}},
                 });
}

TEST(Machine, DoesNotLetARuleSeeItsCaller) {
  expect_answers("r(Y) :- Y = X. s(X,Z) :- X = 1 & Z = 2.",
                 {{"X = 5 & r(Y)", "X", {"5"}}, {"X = 1 & s(A,B)", "f(X,A,B)", {"f(1,1,2)"}}});
}

TEST(Machine, EvaluatesTheArithmeticOfAHeadAfterTheBody) {
  expect_answers("double(X, X * 2). next(X + 1) :- at(X). at(4).", {{"double(4,R)", "R", {"8"}},
                                                                    {"next(N)", "N", {"5"}},
                                                                    {"next(5)", "yes", {"yes"}},
                                                                    {"next(4)", "yes", {}}});
}

TEST(Machine, AsksForAnnotationsThatAreThere) {
  expect_answers("p(1)[a,b]. p(2)[b]. p(3).", {
                                                  {"p(X)[b]", "X", {"1", "2"}},
                                                  {"p(X)[a,b]", "X", {"1"}},
                                                  {"p(X)[source(self)]", "X", {"1", "2", "3"}},
                                                  {"p(X)[source(bob)]", "X", {}},
                                                  {"p(X)[c]", "X", {}},
                                              });
}

TEST(Machine, EnumeratesTheSubsetsOfAnnotations) {
  expect_answers(
      "p[a,b,c].",
      {
          {"p[X]", "X", {"a", "b", "c", "source(self)"}},
          {"p[X,Y] & X \\== source(S) & Y \\== source(S)", "X", {"a", "a", "a", "b", "b", "c"}},
          {"p[a|T]", "T", {"[b,c,source(self)]"}},
          {"p[X|T]", "X", {"a"}},
          {"p[|T]", "T", {"[a,b,c,source(self)]"}},
      });
}

TEST(Machine, GivesRulesTheSourceSelf) {
  expect_answers(
      "p(X) :- q(X). q(1).",
      {{"p(X)[source(self)]", "X", {"1"}}, {"p(X)[source(bob)]", "X", {}}, {"p(X)[k]", "X", {}}});
}

TEST(Machine, SolvesAVariableThatIsBoundToAFormula) {
  expect_answers("p(1). p(2).", {{"F = p(X) & F", "X", {"1", "2"}},
                                 {"F = (p(X) & X > 1) & F", "X", {"2"}},
                                 {"F = p(3) & not F", "yes", {"yes"}}});
}

TEST(Machine, LetsAFreeVariableStandForEveryBelief) {
  test::Terms terms;
  terms.believe("p(1). q(2). r(X) :- p(X).");
  EXPECT_THAT(terms.answers("B", "B"),
              ::testing::UnorderedElementsAre("p(1)[source(self)]", "q(2)[source(self)]",
                                              "r(1)[source(self)]"));
}

TEST(Machine, AsksForStrongNegationSeparately) {
  expect_answers("p(1). ~p(2).", {{"p(X)", "X", {"1"}}, {"~p(X)", "X", {"2"}}});
}

TEST(Machine, RunsThroughAllSolutionsOfAnInternalAction) {
  expect_answers("big(2). big(3).",
                 {{".member(X,[1,2,3])", "X", {"1", "2", "3"}},
                  {".member(X,[1,2,3]) & big(X)", "X", {"2", "3"}},
                  {".range(X,1,2) & .range(Y,X,2)", "f(X,Y)", {"f(1,1)", "f(1,2)", "f(2,2)"}},
                  {"not .member(4,[1,2,3])", "yes", {"yes"}}});
}

TEST(Machine, NestsQueries) {
  expect_answers("p(1). p(2). p(3). n(N) :- .count(p(_),N).",
                 {{".findall(X,p(X),L)", "L", {"[1,2,3]"}},
                  {"p(X) & .findall(Y,p(Y) & Y > X,L)", "L", {"[2,3]", "[3]", "[]"}},
                  {".findall(N,n(N),L)", "L", {"[3]"}},
                  {"n(N) & p(N)", "N", {"3"}}});
}

TEST(Machine, FailsWhereAnInternalActionIsUnknownAndWarns) {
  test::Terms terms;
  EXPECT_THAT(terms.answers(".no_such_action(1)", "yes"), IsEmpty());
  EXPECT_FALSE(terms.warnings.empty());
}

TEST(Machine, KeepsTheBindingsOfTheFirstSolutionOnly) {
  test::Terms terms;
  terms.believe("p(1). p(2).");
  EXPECT_TRUE(terms.holds("p(X) & X > 1"));
  EXPECT_EQ(terms.text("X"), "2");
}

TEST(Machine, LeavesNoBindingBehindWhenItFails) {
  test::Terms terms;
  terms.believe("p(1). p(2).");
  EXPECT_FALSE(terms.holds("p(X) & X > 2"));
  EXPECT_EQ(terms.text("X"), "X");
  EXPECT_EQ(terms.answers("p(X)", "X").size(), 2U);
  EXPECT_EQ(terms.text("X"), "X");
}

TEST(Machine, StopsWhenItIsToldTo) {
  test::Terms terms;
  terms.believe("p(1). p(2). p(3).");
  int seen = 0;
  terms.machine.solve_all_terms(terms.term("p(X)"), [&] { return ++seen < 2; });
  EXPECT_EQ(seen, 2);
  EXPECT_TRUE(terms.holds("p(3)"));
}

// f has facts alone; g has a rule, too, and so another way is taken.
TEST(Machine, AnswersFromAFewFactsAsFromAnyRows) {
  const std::string facts[] = {"(1,a)", "(2,b)", "(1,b)",        "(3,[1,2])",
                               "(2,a)", "(1,1)", "(a,\"text\")", "(b,s(1))"};
  std::string program = "g(none,none) :- false. h(1). h(b). k([1,2]). k(s(X)).";
  for (const std::string& fact : facts) program += " f" + fact + ". g" + fact + ".";
  const std::string bodies[] = {"f(X,Y)",
                                "f(1,Y)",
                                "f(X,b)",
                                "f(X,Y) & f(Y,Z)",
                                "f(X,X) & Y = 0",
                                "h(X) & f(X,Y)",
                                "f(X,Y) & h(Y)",
                                "k(Y) & f(X,Y)",
                                "f(X,Y) & not f(Y,X)",
                                "f(X,Y) & X < 2",
                                "(f(X,a) | f(X,b)) & Y = 1",
                                "f(X,_) & not (f(X,Z) & Z = b) & Y = 2",
                                "f(X,[Y|_])"};
  for (const std::string& body : bodies) {
    std::string other = body;
    for (char& letter : other) letter = letter == 'f' ? 'g' : letter;
    test::Terms terms;
    terms.believe(program + " few(X,Y) :- " + body + ". any(X,Y) :- " + other + ".");
    const auto answers = terms.answers("few(X,Y)", "a(X,Y)");
    EXPECT_EQ(answers, terms.answers("any(X,Y)", "a(X,Y)")) << body;
    EXPECT_FALSE(answers.empty() && body != "f(X,[Y|_])") << body;
    EXPECT_EQ(terms.answers("few(1,Y)", "Y"), terms.answers("any(1,Y)", "Y")) << body;
  }
}

// The frame of a context is not put back where it has no solution: the next row, the other side and
// what comes after a negation must find it as it was all the same.
TEST(Machine, FindsInAContextWhatItFindsElsewhere) {
  const std::string bodies[] = {"f(X) & g(X,Y)",
                                "f(X) & not g(X,_) & Y = X",
                                "not g(X,none) & f(X) & X > 2 & Y = 1",
                                "not (f(X) & X > 3) & Y = 1 & f(X)",
                                "(f(X) & X > 7 | g(X,Y)) & Y = b",
                                "r(X) & g(X,Y) & Y = c",
                                "not r(9) & r(X) & g(X,Y)",
                                "f(X) & .member(Y,[X,2]) & g(Y,Z) & Z = b",
                                "f(X) & X > 3 & Y = 1",
                                "g(X,Y) & r(X) & Y = d"};
  for (const std::string& body : bodies) {
    test::Terms terms;
    terms.believe("f(1). f(2). f(3). g(2,a). g(2,b). g(3,c). r(X) :- f(X) & X > 1. both(X,Y) :- " +
                  body + ".");
    const Relation& both = *terms.beliefs.find(terms.symbols.predicate("both", 2));
    const RuleCode& rule = *both.row(both.first_seq()).rule;
    const std::vector<std::string> answers = terms.answers("both(X,Y)", "both(X,Y)[source(self)]");
    std::vector<Value> slots(rule.slot_count);
    terms.unifier().set_slot_names(rule.slot_names);
    const bool holds = terms.machine.solve_context(rule.body.entry, slots.data());
    ASSERT_EQ(holds, !answers.empty()) << body;
    if (!holds) continue;
    EXPECT_EQ(terms.text(terms.unifier().instantiate(rule.head, slots.data())), answers.front())
        << body;
  }
}

// Counting without a look at each fact gives the number found by looking.
TEST(Machine, CountsFactsAsItFindsThem) {
  const std::vector<std::string> values = {"0",    "-0",    "1",   "1.5",  "a", "b",
                                           "a[k]", "\"a\"", "[1]", "s(1)", "W", "100000000000"};
  const std::vector<std::string> queries = {
      "f(_,_)", "f(1,_)", "f(a,_)", "f(_,0)", "f(_,b)", "f(_,_)[source(ann)]", "f(1,_)[k]"};
  const std::vector<std::string> annotations = {"source(self)", "source(ann)", "k,source(self)"};
  test::Choices choices(7);
  for (int round = 0; round < 40; ++round) {
    test::Terms terms;
    const std::size_t kinds = 1 + choices.below(values.size());
    for (int i = 0; i < 40; ++i) {
      (void)terms.beliefs.add(terms.term("f(" + values[choices.below(kinds)] + "," +
                                         values[choices.below(values.size())] + ")[" +
                                         annotations[choices.below(annotations.size())] + "]"),
                              Place::front);
      Relation& relation = *terms.beliefs.relations().front();
      const std::int64_t place =
          relation.first_seq() + static_cast<std::int64_t>(choices.below(relation.size()));
      if (i % 3 == 2 && !relation.row(place).is_hole()) terms.beliefs.erase(relation, place);
      if (choices.once_in(4)) terms.beliefs.compact();
    }
    std::string rules;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const std::string number = std::to_string(i);
      rules += "counted(" + number + ",N) :- .count(" + queries[i] + ",N). found(" + number +
               ",N) :- .findall(x," + queries[i] + ",L) & .length(L,N). ";
    }
    terms.believe(rules);
    const auto counted = terms.answers("counted(Query,N)", "Query=N");
    EXPECT_EQ(counted, terms.answers("found(Query,N)", "Query=N"));
    EXPECT_EQ(counted.size(), queries.size());
  }
}

TEST(Machine, CountsFactsOfOneArgumentWithoutALookAtEach) {
  test::Terms terms;
  std::string program;
  for (int i = 0; i < 1000; ++i) program += "bid(7," + std::to_string(i) + "). ";
  terms.believe(program + "bids(T,N) :- .count(bid(T,_),N).");
  EXPECT_THAT(terms.answers("bids(7,N)", "N"), ElementsAre("1000"));
  EXPECT_LT(terms.machine.inferences(), 10);
}

TEST(Machine, FindsTheRuleByTheKindOfTheFirstArgument) {
  const std::string program =
      "kind([], empty). kind([_|_], list). kind(X, number) :- X = 1. kind(a, atom). "
      "kind(s(_), structure). kind(\"t\", text). "
      "one([], empty) :- true. one([_|_], list) :- true. one(\"t\", text) :- true. "
      "name(a, bare) :- true. name(s(_), structure) :- true.";
  expect_answers(program, {{"kind([],K)", "K", {"empty"}},
                           {"kind([1],K)", "K", {"list"}},
                           {"kind(1,K)", "K", {"number"}},
                           {"kind(a,K)", "K", {"atom"}},
                           {"kind(b,K)", "K", {}},
                           {"kind(s(2),K)", "K", {"structure"}},
                           {"kind(\"t\",K)", "K", {"text"}},
                           {"one([],K)", "K", {"empty"}},
                           {"one([2],K)", "K", {"list"}},
                           {"one(\"t\",K)", "K", {"text"}},
                           {"one(\"u\",K)", "K", {}},
                           {"one(1,K)", "K", {}},
                           {"one(X,K)", "K", {"empty", "list", "text"}},
                           {"name(a,K)", "K", {"bare"}},
                           {"name(b,K)", "K", {}},
                           {"name(s(1),K)", "K", {"structure"}}});
}

TEST(Machine, GivesOpenFactsFreshVariablesEachTime) {
  test::Terms terms;
  (void)terms.beliefs.add(terms.term("p(Z,Z)[source(self)]"), Place::front);
  EXPECT_THAT(terms.answers("p(1,A) & p(2,B)", "f(A,B)"), ElementsAre("f(1,2)"));
  EXPECT_THAT(terms.answers("p(1,2)", "yes"), IsEmpty());
}

}  // namespace
}  // namespace jaywalk
