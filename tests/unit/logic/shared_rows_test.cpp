// SPDX-License-Identifier: Apache-2.0
// The initial beliefs of a program's agents are shared until an agent changes one.

#include "interpreter/logic/beliefs/shared_rows.h"

#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

/// Facts p(1), p(2), … that two belief bases share; the one of `terms` answers queries.
class SharedFacts : public ::testing::Test {
 protected:
  void share(int count) {
    Ring<Row> rows;
    for (int i = 1; i <= count; ++i) {
      const Value fact = terms.term("p(" + std::to_string(i) + ")[source(self)]");
      rows.push_back({.fact = fact, .key = argument_key(fact.structure()->arg(0))});
    }
    shared = std::make_unique<SharedRows>(std::move(rows), nullptr);
    EXPECT_TRUE(terms.beliefs.share(p, *shared));
    EXPECT_TRUE(other.share(p, *shared));
  }
  [[nodiscard]] std::vector<std::string> answers() { return terms.answers("p(X)", "X"); }
  [[nodiscard]] bool is_shared() const { return terms.beliefs.find(p)->is_shared(); }
  [[nodiscard]] std::size_t others() const { return other.find(p)->size(); }

  test::Terms terms;
  BeliefBase other{terms.heap, terms.symbols};
  Predicate p = terms.symbols.predicate("p", 1);
  std::unique_ptr<SharedRows> shared;
};

TEST_F(SharedFacts, AreAskedNewestFirst) {
  share(3);
  EXPECT_THAT(answers(), ElementsAre("3", "2", "1"));
  EXPECT_TRUE(is_shared());
}

TEST_F(SharedFacts, AreFoundByTheirIndexes) {
  share(100);
  EXPECT_EQ(terms.answers("p(77)", "yes").size(), 1U);
  EXPECT_EQ(terms.answers("p(101)", "yes").size(), 0U);
  EXPECT_TRUE(is_shared());
}

TEST_F(SharedFacts, AreNotSharedWhereSomethingIsBelieved) {
  (void)terms.beliefs.add(terms.term("p(7)"));
  shared = std::make_unique<SharedRows>(Ring<Row>(), nullptr);
  EXPECT_FALSE(terms.beliefs.share(p, *shared));
  EXPECT_THAT(answers(), ElementsAre("7"));
}

TEST_F(SharedFacts, BecomeOnesOwnWithANewBelief) {
  share(100);
  (void)terms.beliefs.add(terms.term("p(new)[source(self)]"));
  EXPECT_FALSE(is_shared());
  EXPECT_EQ(answers().front(), "new");
  EXPECT_EQ(answers().size(), 101U);
  EXPECT_EQ(others(), 100U);
}

TEST_F(SharedFacts, BecomeOnesOwnWhenOneGoes) {
  share(100);
  EXPECT_TRUE(terms.beliefs.remove(terms.term("p(50)[source(self)]"), terms.unifier()));
  terms.beliefs.compact();
  EXPECT_FALSE(is_shared());
  EXPECT_THAT(answers(), Not(Contains("50")));
  EXPECT_EQ(answers().size(), 99U);
  EXPECT_EQ(others(), 100U);
}

TEST_F(SharedFacts, BecomeOnesOwnWithAnotherSource) {
  share(3);
  (void)terms.beliefs.add(terms.term("p(2)[source(bob)]"));
  EXPECT_FALSE(is_shared());
  EXPECT_EQ(terms.answers("p(2)[source(bob)]", "yes").size(), 1U);
  EXPECT_EQ(others(), 3U);
  EXPECT_TRUE(other.find(p)->is_shared());
}

TEST_F(SharedFacts, BecomeOnesOwnWhenOneIsPerceived) {
  share(3);
  BeliefBase::PerceptChange change;
  terms.beliefs.begin_percepts();
  const Value percept = terms.term("p(2)");
  EXPECT_TRUE(terms.beliefs.perceive(p, literal_parts(percept).args, change));
  EXPECT_FALSE(is_shared());
  EXPECT_EQ(terms.answers("p(2)[source(percept)]", "yes").size(), 1U);
}

TEST_F(SharedFacts, StaySharedIfNothingIsNew) {
  share(3);
  EXPECT_FALSE(terms.beliefs.add(terms.term("p(2)[source(self)]")));
  EXPECT_FALSE(terms.beliefs.remove(terms.term("p(9)[source(self)]"), terms.unifier()));
  EXPECT_TRUE(is_shared());
}

TEST_F(SharedFacts, LetAWalkGoOnThatBeganBeforeTheyWereChanged) {
  Ring<Row> rows;
  for (int i = 0; i < 40; ++i) {
    const Value fact =
        terms.term("p(a" + std::to_string(i % 2) + ")[n(" + std::to_string(i) + ")]");
    rows.push_back({.fact = fact, .key = argument_key(fact.structure()->arg(0))});
  }
  shared = std::make_unique<SharedRows>(std::move(rows), nullptr);
  ASSERT_TRUE(terms.beliefs.share(p, *shared));
  Relation& relation = *terms.beliefs.find(p);
  const std::vector<Value> args{terms.term("a1")};
  Relation::Cursor cursor = relation.open(args);
  std::int64_t seq = 0;
  std::vector<std::int64_t> met;
  while (relation.advance(cursor, seq, args.data()) != nullptr) {
    met.push_back(seq);
    if (seq == 39) terms.beliefs.erase(relation, 33);  // and 37 is found already
    if (seq == 35) terms.beliefs.erase(relation, 31);
  }
  EXPECT_FALSE(relation.is_shared());
  EXPECT_THAT(met, Not(Contains(33)));
  EXPECT_THAT(met, Contains(1));
  EXPECT_EQ(shared->index_of(0).count(argument_key(args[0])), 20U) << "the index is as it was";
}

TEST_F(SharedFacts, HaveIndexesThatThreadsMakeOnce) {
  share(1000);
  std::vector<RowIndex*> found(4);
  std::vector<std::thread> threads;
  for (RowIndex*& each : found) {
    threads.emplace_back([&] { each = &shared->index_of(0); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(found, ::testing::Each(found.front()));
}

}  // namespace
}  // namespace jaywalk
