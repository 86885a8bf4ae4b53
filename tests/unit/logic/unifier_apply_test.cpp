// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/compile/translator.h"
#include "interpreter/logic/unifier/unifier.h"
#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

TEST(UnifierApply, LeavesClosedTermsAsTheyAre) {
  test::Terms terms;
  const Value closed = terms.term("f(1,[a,\"s\"])[k]");
  EXPECT_TRUE(terms.unifier().apply(closed).same_as(closed));
}

TEST(UnifierApply, FollowsChainsOfVariables) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("f(A,B,C)", "f(B,C,[D])"));
  ASSERT_TRUE(terms.unify("D", "1 + 1"));
  EXPECT_EQ(terms.text("g(A,C)"), "g([2],[2])");
}

TEST(UnifierApply, FillsTheTailsOfLists) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("f(T,U)", "f([2|U],[3])"));
  EXPECT_EQ(terms.text("[1|T]"), "[1,2,3]");
}

TEST(UnifierApply, GivesUnsetSlotsVariablesOfTheirName) {
  test::Terms terms;
  const std::vector<Symbol> slot_names{terms.symbols.symbol("Speed")};
  terms.unifier().set_slot_names(slot_names);
  Value slot;
  const Value pattern = terms.heap.pair(Value::slot(0), Value::empty_list());
  const Value made = terms.unifier().instantiate(pattern, &slot);
  EXPECT_EQ(term_text(made, terms.symbols), "[Speed]");
  ASSERT_FALSE(slot.is_unset());
  // The slot and the term share the variable.
  ASSERT_TRUE(terms.unifier().unify(slot, Value::number(3)));
  EXPECT_EQ(term_text(made, terms.symbols), "[3]");
}

TEST(UnifierApply, UnsetsSlotsThatAreUndone) {
  test::Terms terms;
  Value slots[2];
  const std::size_t mark = terms.unifier().mark();
  const Value parts[]{Value::slot(0), Value::slot(1)};
  const Value pattern = terms.heap.list(parts);
  ASSERT_TRUE(terms.unifier().match(pattern, slots, terms.term("[1,[2]]"),
                                    Unifier::Direction::template_first));
  EXPECT_EQ(term_text(slots[0], terms.symbols), "1");
  EXPECT_EQ(term_text(slots[1], terms.symbols), "[2]");
  terms.unifier().undo(mark);
  EXPECT_TRUE(slots[0].is_unset());
  EXPECT_TRUE(slots[1].is_unset());
}

TEST(UnifierApply, MatchesASlotTwiceAgainstTheSameValue) {
  test::Terms terms;
  Value slot;
  const Value parts[]{Value::slot(0), Value::slot(0)};
  const Value pattern = terms.heap.list(parts);
  const std::size_t mark = terms.unifier().mark();
  EXPECT_TRUE(terms.unifier().match(pattern, &slot, terms.term("[a,a]"),
                                    Unifier::Direction::template_first));
  terms.unifier().undo(mark);
  EXPECT_FALSE(terms.unifier().match(pattern, &slot, terms.term("[a,b]"),
                                     Unifier::Direction::template_first));
  terms.unifier().undo(mark);
  EXPECT_TRUE(slot.is_unset());
}

TEST(UnifierApply, CopiesWithFreshVariables) {
  test::Terms terms;
  const Value original = terms.term("f(X,Y,X,[Y|Z])");
  const Value copy = terms.unifier().fresh_copy(original);
  ASSERT_TRUE(terms.unifier().unify(copy, terms.term("f(1,2,1,[2,3])")));
  EXPECT_EQ(terms.text(original), "f(X,Y,X,[Y|Z])");
  EXPECT_EQ(terms.text(copy), "f(1,2,1,[2,3])");
}

TEST(UnifierApply, CopiesKeepSharedVariablesShared) {
  test::Terms terms;
  const Value copy = terms.unifier().fresh_copy(terms.term("f(X,X)"));
  EXPECT_FALSE(terms.unifier().unify(copy, terms.term("f(1,2)")));
}

TEST(UnifierApply, TellsWhichVariablesItRenamed) {
  test::Terms terms;
  std::vector<std::pair<Value, Value>> renamed;
  ASSERT_TRUE(terms.unify("B", "7"));
  const Value copy = terms.unifier().rename(terms.term("f(A,B,g(C,A))"), &renamed);
  ASSERT_EQ(renamed.size(), 2U);
  EXPECT_TRUE(deref(renamed[0].first).same_as(deref(terms.term("A"))));
  EXPECT_TRUE(deref(renamed[1].first).same_as(deref(terms.term("C"))));
  EXPECT_FALSE(equal_terms(renamed[0].second, terms.term("A")));
  ASSERT_TRUE(terms.unifier().unify(renamed[0].second, terms.term("1")));
  EXPECT_EQ(terms.text(copy), "f(1,7,g(C,1))");
  EXPECT_EQ(terms.text("A"), "A");
}

TEST(UnifierApply, RefusesTermsThatAreNestedTooDeeply) {
  test::Terms terms;
  Value term = terms.term("X");
  for (int i = 0; i < 100'000; ++i) {
    term = terms.heap.structure(predicates::source, std::span(&term, 1));
  }
  EXPECT_THROW((void)terms.unifier().apply(term), TermTooDeep);
  EXPECT_THROW((void)terms.unifier().fresh_copy(term), TermTooDeep);
}

TEST(UnifierApply, GoesOnAfterATermThatWasTooDeep) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "f(X)"));
  for (int i = 0; i < 3; ++i) EXPECT_THROW((void)terms.text("X"), TermTooDeep);
  EXPECT_TRUE(terms.unify("g(Y)", "g(h(1))"));
  EXPECT_EQ(terms.text("Y"), "h(1)");
}

}  // namespace
}  // namespace jaywalk
