// SPDX-License-Identifier: Apache-2.0
#include "interpreter/logic/beliefs/belief_base.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/term/print.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class BeliefBaseTest : public ::testing::Test {
 protected:
  /// The literal of the event; empty if nothing was new.
  std::string add(std::string_view literal, Place place = Place::front) {
    const auto added = terms.beliefs.add(terms.term(literal), place);
    return added ? term_text(*added, terms.symbols) : "";
  }
  bool remove(std::string_view literal) {
    return terms.beliefs.remove(terms.term(literal), terms.unifier());
  }
  std::vector<std::string> facts(std::string_view functor, int arity) {
    return terms.facts(functor, arity);
  }

  test::Terms terms;
};

TEST_F(BeliefBaseTest, AsksNewBeliefsFirst) {
  add("p(1)[source(self)]");
  add("p(2)[source(self)]");
  add("p(3)[source(self)]", Place::back);
  EXPECT_THAT(facts("p", 1),
              ElementsAre("p(2)[source(self)]", "p(1)[source(self)]", "p(3)[source(self)]"));
}

TEST_F(BeliefBaseTest, SaysNothingNewOfWhatIsBelieved) {
  EXPECT_EQ(add("p(1)[source(self)]"), "p(1)[source(self)]");
  EXPECT_EQ(add("p(1)[source(self)]"), "");
  EXPECT_EQ(add("p(1.0)[source(self)]"), "");
}

TEST_F(BeliefBaseTest, SaysOnlyWhichAnnotationsAreNew) {
  add("p(1)[source(bob)]");
  EXPECT_EQ(add("p(1)[source(self)]"), "p(1)[source(self)]");
  EXPECT_EQ(add("p(1)[k,source(self)]"), "p(1)[k]");
  EXPECT_THAT(facts("p", 1), ElementsAre("p(1)[k,source(bob),source(self)]"));
}

TEST_F(BeliefBaseTest, KeepsThePlaceOfABeliefThatGetsAnnotations) {
  add("p(1)[source(self)]");
  add("p(2)[source(self)]");
  add("p(1)[source(bob)]");
  EXPECT_THAT(facts("p", 1), ElementsAre("p(2)[source(self)]", "p(1)[source(bob),source(self)]"));
}

TEST_F(BeliefBaseTest, TellsPredicatesApart) {
  add("p(1)[source(self)]");
  add("~p(1)[source(self)]");
  add("n::p(1)[source(self)]");
  add("p(1,2)[source(self)]");
  EXPECT_THAT(facts("p", 1), ElementsAre("p(1)[source(self)]"));
  EXPECT_THAT(facts("~p", 1), ElementsAre("~p(1)[source(self)]"));
  EXPECT_THAT(facts("p", 2), ElementsAre("p(1,2)[source(self)]"));
}

TEST_F(BeliefBaseTest, RemovesTheBeliefWithItsLastSource) {
  add("p(1)[source(bob),source(self)]");
  EXPECT_TRUE(remove("p(1)[source(self)]"));
  EXPECT_THAT(facts("p", 1), ElementsAre("p(1)[source(bob)]"));
  EXPECT_TRUE(remove("p(1)[source(bob)]"));
  EXPECT_THAT(facts("p", 1), IsEmpty());
}

TEST_F(BeliefBaseTest, RemovesAnnotationsAlone) {
  add("p(1)[k,m,source(self)]");
  EXPECT_TRUE(remove("p(1)[k]"));
  EXPECT_THAT(facts("p", 1), ElementsAre("p(1)[m,source(self)]"));
}

TEST_F(BeliefBaseTest, RemovesNothingWithoutAllTheAnnotations) {
  add("p(1)[k,source(self)]");
  EXPECT_FALSE(remove("p(1)[k,m]"));
  EXPECT_FALSE(remove("p(1)[source(bob)]"));
  EXPECT_FALSE(remove("p(2)[source(self)]"));
  EXPECT_FALSE(remove("q[source(self)]"));
  EXPECT_THAT(facts("p", 1), ElementsAre("p(1)[k,source(self)]"));
}

TEST_F(BeliefBaseTest, RemovesOneBeliefThatUnifiesAndBindsIt) {
  add("p(1,a)[source(self)]");
  add("p(2,a)[source(self)]");
  EXPECT_TRUE(remove("p(X,a)[source(self)]"));
  EXPECT_EQ(terms.text("X"), "2");
  EXPECT_THAT(facts("p", 2), ElementsAre("p(1,a)[source(self)]"));
}

TEST_F(BeliefBaseTest, RemovesAGroundFactByAnnotationsWithVariables) {
  add("p(1)[source(bob),t(5)]");
  EXPECT_TRUE(remove("p(1)[source(X),t(Y)]"));
  EXPECT_EQ(terms.text("X"), "bob");
  EXPECT_EQ(terms.text("Y"), "5");
  EXPECT_THAT(facts("p", 1), IsEmpty());
}

TEST_F(BeliefBaseTest, LeavesNoBindingWhenTheBeliefStays) {
  add("p(1)[source(ann),source(bob)]");
  EXPECT_FALSE(remove("p(1)[source(X)]"));
  EXPECT_EQ(terms.text("X"), "X");
  EXPECT_THAT(facts("p", 1), ElementsAre("p(1)[source(bob)]"));
}

TEST_F(BeliefBaseTest, LeavesNoBindingWhenNothingUnifies) {
  add("p(1,a)[source(self)]");
  EXPECT_FALSE(remove("p(X,b)[source(self)]"));
  EXPECT_EQ(terms.text("X"), "X");
}

TEST_F(BeliefBaseTest, MayRemoveARule) {
  terms.believe("p(X) :- q(X). p(7).");
  EXPECT_TRUE(remove("p(X)[source(self)]"));
  terms.new_scope();
  EXPECT_THAT(facts("p", 1), ElementsAre("p(7)[source(self)]"));
  EXPECT_TRUE(terms.answers("q(9) | p(X)", "X").size() == 1U);
}

TEST_F(BeliefBaseTest, LeavesNoTraceOfRulesThatDoNotUnify) {
  terms.believe("p(a,X) :- q(X). p(Y,c) :- q(Y).");
  const std::size_t mark = terms.unifier().mark();
  EXPECT_FALSE(remove("p(b,X)[source(bob)]"));
  EXPECT_EQ(terms.unifier().mark(), mark);
}

TEST_F(BeliefBaseTest, FindsFactsAmongManyAfterRemovals) {
  for (int i = 0; i < 2000; ++i) add("p(" + std::to_string(i) + ")[source(self)]");
  for (int i = 0; i < 2000; i += 2) {
    ASSERT_TRUE(remove("p(" + std::to_string(i) + ")[source(self)]"));
    if (i % 100 == 0) terms.beliefs.compact();
  }
  terms.beliefs.compact();
  EXPECT_EQ(facts("p", 1).size(), 1000U);
  EXPECT_THAT(terms.answers("p(1001)", "yes"), ElementsAre("yes"));
  EXPECT_THAT(terms.answers("p(1000)", "yes"), IsEmpty());
  EXPECT_EQ(add("p(1001)[source(self)]"), "");
  EXPECT_EQ(add("p(1000)[source(self)]"), "p(1000)[source(self)]");
  EXPECT_EQ(facts("p", 1).front(), "p(1000)[source(self)]");
}

TEST_F(BeliefBaseTest, KeepsTheOrderOfEqualKeysInItsIndexes) {
  for (int i = 0; i < 50; ++i) {
    add("p(k" + std::to_string(i % 3) + "," + std::to_string(i) + ")[source(self)]",
        i % 5 == 0 ? Place::back : Place::front);
  }
  EXPECT_THAT(terms.answers("p(k1,X) & X < 20", "X"),
              ElementsAre("19", "16", "13", "7", "4", "1", "10"));
  terms.new_scope();
  EXPECT_THAT(terms.answers("p(K,13)", "K"), ElementsAre("k1"));
}

TEST_F(BeliefBaseTest, TakesRemovedFactsOutOfItsIndexes) {
  for (int i = 0; i < 40; ++i) {
    add("p(" + std::to_string(i) + ",a)[source(self)]", i % 2 == 0 ? Place::front : Place::back);
  }
  EXPECT_EQ(terms.answers("p(X,a)", "X").size(), 40U);
  for (const int i : {38, 36, 39, 37}) {  // at both ends: their places are given to others
    ASSERT_TRUE(remove("p(" + std::to_string(i) + ",a)[source(self)]"));
  }
  terms.beliefs.compact();
  add("p(50,b)[source(self)]");
  add("p(51,b)[source(self)]", Place::back);
  EXPECT_EQ(terms.answers("p(X,a)", "X").size(), 36U);
  EXPECT_THAT(terms.answers("p(X,b)", "X"), ElementsAre("50", "51"));
  EXPECT_THAT(terms.answers("p(38,X)", "X"), IsEmpty());
}

TEST_F(BeliefBaseTest, AsksOpenFactsAmongTheIndexedOnesInTheirPlace) {
  for (int i = 0; i < 20; ++i) add("p(" + std::to_string(i) + ")[source(self)]");
  (void)terms.beliefs.add(terms.term("p(_)[source(self)]"), Place::front);
  for (int i = 20; i < 30; ++i) add("p(" + std::to_string(i) + ")[source(self)]");
  EXPECT_EQ(terms.answers("p(5)", "yes").size(), 2U);
  EXPECT_EQ(terms.answers("p(99)", "yes").size(), 1U);
}

TEST_F(BeliefBaseTest, LeavesNothingThatWasBelieved) {
  add("p(2)");
  BeliefBase next(terms.heap, terms.symbols);
  next.use(terms.beliefs.leave_remains());
  EXPECT_EQ(next.find(terms.symbols.predicate("p", 1)), nullptr);
  (void)next.add(terms.term("p(3)"));
  EXPECT_EQ(next.find(terms.symbols.predicate("p", 1))->size(), 1U);
}

class PerceptsTest : public BeliefBaseTest {
 protected:
  /// The changes, `+p(1)` and `-p(1)`, that these percepts make, removals first.
  std::vector<std::string> perceive(const std::vector<std::string>& percepts) {
    terms.beliefs.begin_percepts();
    std::vector<std::string> added;
    for (const std::string& percept : percepts) {
      const LiteralParts parts = literal_parts(terms.term(percept));
      BeliefBase::PerceptChange change;
      if (terms.beliefs.perceive(parts.predicate, parts.args, change)) {
        added.push_back("+" + term_text(change.literal, terms.symbols));
      }
    }
    std::vector<BeliefBase::PerceptChange> removed;
    terms.beliefs.end_percepts(removed);
    std::vector<std::string> changes;
    for (const auto& change : removed) {
      changes.push_back("-" + term_text(change.literal, terms.symbols));
    }
    changes.insert(changes.end(), added.begin(), added.end());
    return changes;
  }
};

TEST_F(PerceptsTest, ReportTheDifference) {
  EXPECT_THAT(perceive({"at(1)", "wet"}),
              ElementsAre("+at(1)[source(percept)]", "+wet[source(percept)]"));
  EXPECT_THAT(perceive({"at(1)", "wet"}), IsEmpty());
  EXPECT_THAT(perceive({"at(2)", "wet"}),
              ElementsAre("-at(1)[source(percept)]", "+at(2)[source(percept)]"));
  EXPECT_THAT(perceive({}),
              ::testing::UnorderedElementsAre("-at(2)[source(percept)]", "-wet[source(percept)]"));
  EXPECT_THAT(perceive({}), IsEmpty());
  EXPECT_THAT(facts("at", 1), IsEmpty());
}

TEST_F(PerceptsTest, DoNotRemoveWhatAnotherSourceSays) {
  add("at(1)[source(bob)]");
  EXPECT_THAT(perceive({"at(1)"}), ElementsAre("+at(1)[source(percept)]"));
  EXPECT_THAT(facts("at", 1), ElementsAre("at(1)[source(bob),source(percept)]"));
  EXPECT_THAT(perceive({}), ElementsAre("-at(1)[source(percept)]"));
  EXPECT_THAT(facts("at", 1), ElementsAre("at(1)[source(bob)]"));
}

TEST_F(PerceptsTest, ComeBackAfterTheAgentHasDeletedThem) {
  (void)perceive({"at(1)"});
  EXPECT_TRUE(remove("at(1)[source(percept)]"));
  EXPECT_THAT(perceive({"at(1)"}), ElementsAre("+at(1)[source(percept)]"));
}

TEST_F(PerceptsTest, ComeBackWhenOnlyTheirSourceWasDeleted) {
  add("at(1)[source(bob)]");
  (void)perceive({"at(1)"});
  EXPECT_TRUE(remove("at(1)[source(percept)]"));
  EXPECT_THAT(perceive({"at(1)"}), ElementsAre("+at(1)[source(percept)]"));
}

TEST_F(PerceptsTest, CountOnceIfPerceivedTwice) {
  EXPECT_EQ(perceive({"at(1)", "at(1)"}).size(), 1U);
  EXPECT_THAT(perceive({"at(1)"}), IsEmpty());
}

TEST_F(PerceptsTest, AreComparedAsValues) {
  (void)perceive({"speed(1)"});
  EXPECT_THAT(perceive({"speed(1.0)"}), IsEmpty());
}

}  // namespace
}  // namespace jaywalk
