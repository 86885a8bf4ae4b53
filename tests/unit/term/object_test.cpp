// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/object.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/term/compare.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

/// Collections of terms written as text.
class Objects : public testing::Test {
 protected:
  Value term(std::string_view text) { return terms_.term(text); }
  std::string text(const std::vector<Value>& values) {
    std::string all;
    for (const Value value : values) all += (all.empty() ? "" : " ") + terms_.text(value);
    return all;
  }
  /// The elements taken from a queue, in order.
  std::string taken(QueueObject& queue) {
    std::vector<Value> values;
    while (queue.size() > 0) values.push_back(queue.take(symbols()));
    return text(values);
  }
  QueueObject queue_of(QueueObject::Order order, std::initializer_list<std::string_view> texts) {
    QueueObject queue(order);
    for (const std::string_view each : texts) queue.add(term(each), symbols());
    return queue;
  }
  SetObject set_of(std::initializer_list<std::string_view> texts) {
    SetObject set;
    for (const std::string_view each : texts) set.add(term(each), symbols());
    return set;
  }
  const SymbolTable& symbols() { return terms_.symbols; }

  test::Terms terms_;
};

TEST_F(Objects, ASetHasEachElementOnceInTheOrderOfTerms) {
  const SetObject set = set_of({"b", "3", "a", "1", "b", "\"t\"", "1"});
  EXPECT_EQ(set.size(), 5U);
  std::vector<Value> sorted = set.elements();
  std::ranges::sort(sorted, [&](Value a, Value b) { return compare_terms(a, b, symbols()) < 0; });
  EXPECT_EQ(text(set.elements()), text(sorted));
}

TEST_F(Objects, ASetTakesEqualTermsForOne) {
  const SetObject set = set_of({"f(1)", "f(1.0)", "p[a,b]", "p[b,a]"});
  EXPECT_EQ(set.size(), 2U);
  EXPECT_TRUE(set.contains(term("f(1)"), symbols()));
  EXPECT_FALSE(set.contains(term("f(2)"), symbols()));
}

TEST_F(Objects, ASetGivesUpWhatIsRemoved) {
  SetObject set = set_of({"a", "b", "c"});
  set.remove(term("b"), symbols());
  set.remove(term("z"), symbols());
  EXPECT_EQ(text(set.elements()), "a c");
  set.clear();
  EXPECT_EQ(set.size(), 0U);
}

TEST_F(Objects, ASetKeepsWhatAnotherHasOrHasNot) {
  const SetObject other = set_of({"b", "c", "z"});
  SetObject common = set_of({"a", "b", "c", "d"});
  common.keep(SetObject::Keep::common, other, symbols());
  EXPECT_EQ(text(common.elements()), "b c");
  SetObject others = set_of({"a", "b", "c", "d"});
  others.keep(SetObject::Keep::others, other, symbols());
  EXPECT_EQ(text(others.elements()), "a d");
}

TEST_F(Objects, AMapHasOneValueForAKey) {
  MapObject map;
  map.put(term("k"), term("1"), symbols());
  map.put(term("j"), term("2"), symbols());
  map.put(term("k"), term("3"), symbols());
  EXPECT_EQ(map.size(), 2U);
  ASSERT_NE(map.find(term("k"), symbols()), nullptr);
  EXPECT_EQ(map.find(term("k"), symbols())->as_number(), 3);
  EXPECT_EQ(map.find(term("z"), symbols()), nullptr);
  EXPECT_EQ(text({map.entries()[0].first, map.entries()[1].first}), "j k");
}

TEST_F(Objects, AMapGivesUpWhatIsRemoved) {
  MapObject map;
  map.put(term("k"), term("1"), symbols());
  map.remove(term("z"), symbols());
  EXPECT_EQ(map.size(), 1U);
  map.remove(term("k"), symbols());
  EXPECT_EQ(map.size(), 0U);
  EXPECT_EQ(map.find(term("k"), symbols()), nullptr);
}

TEST_F(Objects, AQueueGivesFirstWhatCameFirst) {
  QueueObject queue = queue_of(QueueObject::Order::arrival, {"c", "a", "b", "a"});
  EXPECT_EQ(taken(queue), "c a b a");
}

TEST_F(Objects, APriorityQueueGivesTheLeastFirst) {
  QueueObject queue = queue_of(QueueObject::Order::priority, {"5", "1", "4", "1", "3"});
  EXPECT_EQ(taken(queue), "1 1 3 4 5");
}

TEST_F(Objects, APriorityQueueSortsWhateverComesInBetween) {
  std::mt19937 random(5);
  QueueObject queue(QueueObject::Order::priority);
  std::vector<double> expected;
  for (int i = 0; i < 400; ++i) {
    if (random() % 3 != 0 || expected.empty()) {
      const auto value = static_cast<double>(random() % 50);
      queue.add(Value::number(value), symbols());
      expected.push_back(value);
    } else {
      const auto least = std::ranges::min_element(expected);
      EXPECT_EQ(queue.take(symbols()).as_number(), *least);
      expected.erase(least);
    }
    EXPECT_EQ(queue.size(), expected.size());
  }
}

TEST_F(Objects, CopiesAreOfTheirOwn) {
  SetObject set = set_of({"a", "b"});
  const auto copied = set.copy();
  set.clear();
  EXPECT_EQ(copied->size(), 2U);
  EXPECT_EQ(copied->kind(), Object::Kind::set);
  QueueObject queue = queue_of(QueueObject::Order::priority, {"3", "1", "2"});
  const auto other = queue.copy();
  queue.add(term("0"), symbols());
  auto& copy = static_cast<QueueObject&>(*other);
  EXPECT_EQ(taken(copy), "1 2 3") << "in the same order, too";
}

TEST_F(Objects, ShowAllTheirValuesToWhoVisitsThem) {
  MapObject map;
  map.put(term("b"), term("2"), symbols());
  map.put(term("a"), term("1"), symbols());
  std::vector<Value> seen;
  map.visit([&](Value& value) { seen.push_back(value); });
  EXPECT_EQ(text(seen), "a 1 b 2");
  SetObject set = set_of({"a"});
  set.visit([&](Value& value) { value = term("moved"); });
  EXPECT_EQ(text(set.elements()), "moved");
}

TEST_F(Objects, TakeMoreMemoryTheMoreTheyHold) {
  SetObject set = set_of({"a"});
  const std::size_t one = set.bytes();
  EXPECT_GE(one, kObjectBytes);
  set.add(term("b"), symbols());
  EXPECT_GT(set.bytes(), one);
  MapObject map;
  const std::size_t none = map.bytes();
  map.put(term("a"), term("1"), symbols());
  EXPECT_GT(map.bytes(), none);
}

}  // namespace
}  // namespace jaywalk
