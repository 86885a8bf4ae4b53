// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/value.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/term/heap.h"

namespace jaywalk {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Value, KeepsEveryNumber) {
  for (const double number : {0.0, 1.0, -1.0, 0.1, 1e308, -1e308, 5e-324, kInfinity, -kInfinity}) {
    const Value value = Value::number(number);
    EXPECT_EQ(value.kind(), Value::Kind::number) << number;
    EXPECT_TRUE(value.is_number()) << number;
    EXPECT_EQ(value.as_number(), number);
  }
}

TEST(Value, KeepsTheSignOfZero) {
  EXPECT_TRUE(std::signbit(Value::number(-0.0).as_number()));
  EXPECT_FALSE(std::signbit(Value::number(0.0).as_number()));
}

TEST(Value, TakesEveryNotANumberForANumber) {
  const double quiet = std::numeric_limits<double>::quiet_NaN();
  // The bit patterns of the other kinds are not-a-numbers, too; none of them may leak through.
  for (const double nan : {quiet, -quiet, std::nan("1"), std::nan("4096"), std::sqrt(-1.0)}) {
    const Value value = Value::number(nan);
    EXPECT_TRUE(value.is_number());
    EXPECT_TRUE(std::isnan(value.as_number()));
    EXPECT_TRUE(value.same_as(Value::number(quiet)));
  }
}

TEST(Value, IsUnsetAtFirst) {
  EXPECT_TRUE(Value().is_unset());
  EXPECT_EQ(Value().kind(), Value::Kind::special);
  EXPECT_FALSE(Value().is_empty_list());
  EXPECT_FALSE(Value().is_slot());
}

TEST(Value, TellsTheEmptyListFromASlot) {
  EXPECT_TRUE(Value::empty_list().is_list());
  EXPECT_FALSE(Value::empty_list().is_slot());
  EXPECT_FALSE(Value::empty_list().is_pair());
  for (const std::uint32_t index : {0U, 1U, 2U, 65'535U, 1U << 28U}) {
    const Value slot = Value::slot(index);
    EXPECT_TRUE(slot.is_slot()) << index;
    EXPECT_FALSE(slot.is_unset()) << index;
    EXPECT_FALSE(slot.is_empty_list()) << index;
    EXPECT_EQ(slot.slot_index(), index);
  }
}

TEST(Value, KeepsTheNumberOfAnAtom) {
  for (const std::uint32_t id : {0U, 1U, 7U, 4'294'967'295U}) {
    const Value atom = Value::atom(Predicate{id});
    EXPECT_EQ(atom.kind(), Value::Kind::atom);
    EXPECT_EQ(atom.atom_id(), Predicate{id});
  }
}

TEST(Value, KnowsTheKindOfEveryCell) {
  Heap heap;
  const Value one = Value::number(1);
  const std::vector<std::pair<Value, Value::Kind>> cells{
      {heap.text("t"), Value::Kind::text},
      {heap.pair(one, Value::empty_list()), Value::Kind::pair},
      {heap.variable(), Value::Kind::variable},
      {heap.structure(predicates::source, std::span(&one, 1)), Value::Kind::structure},
  };
  for (const auto& [value, kind] : cells) {
    EXPECT_EQ(value.kind(), kind);
    EXPECT_FALSE(value.is_number());
    EXPECT_FALSE(value.is_unset());
  }
}

TEST(Value, IsClosedUnlessItHasVariables) {
  Heap heap;
  const Value variable = heap.variable();
  const Value closed = heap.pair(Value::number(1), Value::empty_list());
  const Value open = heap.pair(variable, Value::empty_list());
  EXPECT_TRUE(closed.is_closed());
  EXPECT_FALSE(variable.is_closed());
  EXPECT_FALSE(open.is_closed());
  EXPECT_FALSE(heap.structure(predicates::source, std::span(&open, 1)).is_closed());
  EXPECT_TRUE(heap.structure(predicates::source, std::span(&closed, 1)).is_closed());
  EXPECT_FALSE(heap.pair(Value::slot(0), Value::empty_list()).is_closed());
}

TEST(Value, IsOpenWhileAnExpressionIsNotEvaluated) {
  Heap heap;
  const Value sides[]{Value::number(1), Value::number(2)};
  const Value sum = heap.structure(predicates::add, sides, Value::empty_list(), Form::expression);
  EXPECT_FALSE(sum.is_closed());
  EXPECT_FALSE(heap.pair(sum, Value::empty_list()).is_closed());
}

}  // namespace
}  // namespace jaywalk
