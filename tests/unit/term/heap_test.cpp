// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/heap.h"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/term/compare.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

/// Collects with the given values as roots.
void collect(Heap& heap, std::vector<Value*> roots) {
  heap.collect([&](Heap::Relocator& relocate) {
    for (Value* const root : roots) relocate(*root);
  });
}

/// A collection of the language, reduced to what the collector sees of it.
class Box : public Object {
 public:
  Box(Value content, int& alive) : content_(content), alive_(alive) { ++alive_; }
  ~Box() override { --alive_; }
  Box(const Box&) = delete;
  Box& operator=(const Box&) = delete;
  [[nodiscard]] Kind kind() const override { return Kind::queue; }
  [[nodiscard]] std::size_t size() const override { return 1; }
  [[nodiscard]] std::size_t bytes() const override { return kObjectBytes; }
  [[nodiscard]] std::unique_ptr<Object> copy() const override {
    return std::make_unique<Box>(content_, alive_);
  }
  void visit(const std::function<void(Value&)>& visit) override { visit(content_); }
  [[nodiscard]] Value content() const { return content_; }
  void set(Value content) { content_ = content; }

 private:
  Value content_;
  int& alive_;
};

TEST(Heap, HoldsTextsOfEveryLength) {
  Heap heap;
  for (std::size_t length = 0; length < 40; ++length) {
    const std::string text(length, 'x');
    EXPECT_EQ(heap.text(text).text()->view(), text);
  }
}

TEST(Heap, MakesAnAtomOfAStructureWithoutParts) {
  Heap heap;
  EXPECT_TRUE(heap.structure(predicates::self, {}).is_atom());
  const Value annotated = heap.structure(predicates::self, {}, source_self());
  ASSERT_TRUE(annotated.is_structure());
  EXPECT_TRUE(annotated.structure()->annots().same_as(source_self()));
  EXPECT_EQ(annotated.structure()->arity, 0);
}

TEST(Heap, KeepsWhatTheRootsReach) {
  test::Terms terms;
  Value root = terms.term("f(1,\"text\",[a,b|T],g(X,X),n::~h)[k(2),source(self)]");
  const std::string before = terms.text(root);
  collect(terms.heap, {&root});
  EXPECT_EQ(terms.text(root), before);
}

TEST(Heap, FreesWhatNoRootReaches) {
  Heap heap;
  Value kept = heap.text("kept");
  for (int i = 0; i < 10'000; ++i) (void)heap.text("a text that is not needed any more");
  const std::size_t before = heap.bytes();
  collect(heap, {&kept});
  EXPECT_LT(heap.bytes(), 200U);
  EXPECT_GT(before, 100'000U);
  EXPECT_EQ(kept.text()->view(), "kept");
}

TEST(Heap, KeepsSharedPartsShared) {
  Heap heap;
  const Value shared = heap.text("shared");
  Value list = heap.list(std::vector<Value>{shared, shared});
  Value other = shared;
  collect(heap, {&list, &other});
  EXPECT_TRUE(list.pair()->head.same_as(list.pair()->tail.pair()->head));
  EXPECT_TRUE(list.pair()->head.same_as(other));
}

TEST(Heap, KeepsVariablesThatAreBoundToWhatHoldsThem) {
  Heap heap;
  Value variable = heap.variable();
  variable.variable()->value = heap.structure(predicates::source, std::span(&variable, 1));
  collect(heap, {&variable});
  const Value inside = variable.variable()->value.structure()->arg(0);
  EXPECT_TRUE(inside.same_as(variable));
}

TEST(Heap, KeepsListsThatEndInThemselves) {
  Heap heap;
  Value tail = heap.variable();
  Value list = heap.pair(Value::number(1), tail);
  tail.variable()->value = list;
  collect(heap, {&list, &tail});
  EXPECT_TRUE(deref(list.pair()->tail).same_as(list));
}

TEST(Heap, KeepsTermsOfAnyDepth) {
  Heap heap;
  Value term = Value::empty_list();
  constexpr int kDepth = 1'000'000;
  for (int i = 0; i < kDepth; ++i) term = heap.pair(term, Value::empty_list());
  collect(heap, {&term});
  int depth = 0;
  for (; term.is_pair(); term = term.pair()->head) ++depth;
  EXPECT_EQ(depth, kDepth);
}

TEST(Heap, LeavesConstantsOfProgramsAlone) {
  Heap program(Heap::Owner::program);
  Heap heap;
  const Value constant = program.text("constant");
  Value list = heap.pair(constant, Value::empty_list());
  collect(heap, {&list});
  EXPECT_TRUE(list.pair()->head.same_as(constant));
  EXPECT_TRUE(constant.is_static());
}

TEST(Heap, CollectsObjectsThatAreNotNamedAnyMore) {
  int alive = 0;
  Heap heap;
  Value kept = heap.object(std::make_unique<Box>(heap.text("inside"), alive));
  (void)heap.object(std::make_unique<Box>(Value(), alive));
  ASSERT_EQ(alive, 2);
  collect(heap, {&kept});
  EXPECT_EQ(alive, 1);
  const auto& box = static_cast<const Box&>(*kept.object()->object);
  EXPECT_EQ(box.content().text()->view(), "inside");
}

TEST(Heap, CollectsObjectsThatNameOneAnotherInACircle) {
  int alive = 0;
  {
    Heap heap;
    const Value a = heap.object(std::make_unique<Box>(Value(), alive));
    const Value b = heap.object(std::make_unique<Box>(a, alive));
    static_cast<Box&>(*a.object()->object).set(b);
    Value root = a;
    collect(heap, {&root});
    EXPECT_EQ(alive, 2);
    collect(heap, {});
    EXPECT_EQ(alive, 0);
    (void)heap.object(std::make_unique<Box>(Value(), alive));
  }
  EXPECT_EQ(alive, 0);
}

TEST(Heap, TakesWhatIsAliveAlongWhenItLeavesItsNursery) {
  Heap::Remains nursery;
  Heap::Remains aside;
  Heap heap;
  heap.enter(nursery);
  const Value first = heap.pair(Value::number(1), Value::empty_list());
  Value kept = heap.pair(heap.text("alive"), first);
  Value none = Value::number(2);
  for (int i = 0; i < 50; ++i) (void)heap.text("rubbish");
  heap.leave(nursery, aside, [&](Heap::Relocator& relocate) {
    relocate(kept);
    relocate(none);
  });
  EXPECT_EQ(heap.bytes(), 6 * sizeof(std::uint64_t));
  EXPECT_EQ(kept.pair()->head.text()->view(), "alive");
  EXPECT_EQ(kept.pair()->tail.pair()->head.as_number(), 1);
  // Another heap lives where it has lived.
  Heap second;
  second.enter(nursery);
  for (int i = 0; i < 50; ++i) (void)second.text("others");
  EXPECT_EQ(kept.pair()->head.text()->view(), "alive");
  EXPECT_EQ(heap.text("more").text()->view(), "more");
}

TEST(Heap, StaysInANurseryThatItHasGrownOutOf) {
  Heap::Remains nursery;
  Heap::Remains aside;
  Heap heap;
  heap.enter(nursery);
  Value kept = heap.text("alive");
  for (int i = 0; i < 500; ++i) (void)heap.text("very much");
  const std::size_t bytes = heap.bytes();
  heap.leave(nursery, aside, [&](Heap::Relocator& relocate) { relocate(kept); });
  EXPECT_EQ(heap.bytes(), bytes);
  EXPECT_EQ(kept.text()->view(), "alive");
}

TEST(Heap, CollectsAgainAndAgain) {
  test::Terms terms;
  Value root = terms.term("[1,f(X,[2,3]),\"s\"]");
  const std::string before = terms.text(root);
  collect(terms.heap, {&root});
  const std::size_t bytes = terms.heap.bytes();
  for (int i = 0; i < 10; ++i) {
    collect(terms.heap, {&root});
    EXPECT_EQ(terms.heap.bytes(), bytes);
  }
  EXPECT_EQ(terms.text(root), before);
}

TEST(Heap, IsCutBackToAMark) {
  Heap heap;
  (void)heap.text("first");
  const Heap::Mark mark = heap.mark();
  const std::size_t bytes = heap.bytes();
  for (int i = 0; i < 100'000; ++i) (void)heap.pair(Value::number(i), Value::empty_list());
  EXPECT_GT(heap.bytes(), bytes);
  heap.release(mark);
  EXPECT_EQ(heap.bytes(), bytes);
}

TEST(Heap, IsCutBackToNothing) {
  Heap heap;
  const Heap::Mark mark = heap.mark();
  (void)heap.text("gone");
  heap.release(mark);
  EXPECT_EQ(heap.bytes(), 0U);
  EXPECT_EQ(heap.text("again").text()->view(), "again");
}

TEST(Heap, IsEmptyOnceItIsCleared) {
  for (const std::size_t length :
       {std::size_t{3}, std::size_t{3000}}) {  // within its first chunk, and beyond
    int alive = 0;
    Heap heap;
    (void)heap.object(std::make_unique<Box>(heap.text(std::string(length, 'x')), alive));
    heap.protect();
    heap.clear();
    EXPECT_EQ(heap.bytes(), 0U);
    EXPECT_EQ(alive, 0);
    const Value text = heap.text(std::string(length, 'y'));
    EXPECT_EQ(text.text()->view(), std::string(length, 'y'));
    EXPECT_GE(heap.bytes(), length);
  }
}

TEST(Heap, KeepsWhatIsProtectedWhateverTheMark) {
  Heap heap;
  const Heap::Mark mark = heap.mark();
  const Value kept = heap.text("protected");
  heap.protect();
  const std::size_t bytes = heap.bytes();
  for (int i = 0; i < 10'000; ++i) (void)heap.text("gone");
  heap.release(mark);
  EXPECT_EQ(heap.bytes(), bytes);
  (void)heap.text("overwrites what was released");
  EXPECT_EQ(kept.text()->view(), "protected");
}

TEST(Heap, StopsAtItsLimit) {
  Heap heap;
  heap.set_limit(100'000);
  EXPECT_THROW(
      {
        for (;;) (void)heap.pair(Value::number(1), Value::empty_list());
      },
      HeapExhausted);
  EXPECT_LE(heap.bytes(), 50'000U);  // while they are collected, terms are there twice
  EXPECT_THROW((void)heap.text(std::string(1'000'000, 'x')), HeapExhausted);
}

TEST(Heap, HasRoomAgainOnceItHasCollected) {
  Heap heap;
  heap.set_limit(100'000);
  try {
    for (;;) (void)heap.pair(Value::number(1), Value::empty_list());
  } catch (const HeapExhausted&) {
  }
  collect(heap, {});
  EXPECT_EQ(heap.bytes(), 0U);
  EXPECT_EQ(heap.text("fits").text()->view(), "fits");
}

TEST(Heap, WantsACollectionOnlyWhenMuchHasBeenMade) {
  Heap heap;
  EXPECT_FALSE(heap.wants_collection());
  for (int i = 0; i < 100'000; ++i) (void)heap.variable();
  EXPECT_TRUE(heap.wants_collection());
  collect(heap, {});
  EXPECT_FALSE(heap.wants_collection());
}

TEST(Heap, WantsACollectionBeforeItsLimitHoweverMuchIsAlive) {
  Heap heap;
  heap.set_limit(1'000'000);
  Value alive = heap.text(std::string(350'000, 'x'));
  collect(heap, {&alive});
  try {
    for (;;) (void)heap.variable();
  } catch (const HeapExhausted&) {
  }
  EXPECT_TRUE(heap.wants_collection());
}

TEST(Heap, NumbersItsVariables) {
  Heap heap;
  EXPECT_NE(heap.variable().variable()->serial, heap.variable().variable()->serial);
}

}  // namespace
}  // namespace jaywalk
