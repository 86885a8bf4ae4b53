// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/transfer.h"

#include <string>

#include <gtest/gtest.h>

#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"
#include "tests/helpers/generate.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

/// From one heap to another.
class TransferTest : public testing::Test {
 protected:
  std::string text(Value value) { return term_text(value, from_.symbols); }

  test::Terms from_;
  Heap to_;
};

TEST_F(TransferTest, MakesTermsThatSayTheSame) {
  for (const char* written :
       {"1.5", "a", "\"text\"", "p(1,\"t\",[a,b|[]])", "~p(q(r))[source(s),b(1)]", "[]",
        "[1,[2,[3]]]", "{ !g(1); +b }", "ns::p(a)", "f(1,2,3,4,5,6,7,8,9,10,11)"}) {
    const Value term = from_.term(written);
    EXPECT_TRUE(equal_terms(transfer(term, to_), term)) << written;
    EXPECT_EQ(text(transfer(term, to_)), text(term));
  }
}

TEST_F(TransferTest, MakesTermsThatOutliveTheirOrigin) {
  Value copied;
  std::string expected;
  {
    Heap heap;
    const std::string words = "a text that is only there";
    copied = transfer(heap.list(std::vector<Value>{heap.text(words), Value::number(1)}), to_);
    expected = "[\"" + words + "\",1]";
  }
  EXPECT_EQ(text(copied), expected);
}

TEST_F(TransferTest, MakesOneVariableOfOne) {
  const Value copied = transfer(from_.term("p(X,Y,f(X))"), to_);
  const Structure& structure = *copied.structure();
  const Value x = deref(structure.arg(0));
  EXPECT_TRUE(x.is_variable());
  EXPECT_EQ(x.bits(), deref(deref(structure.arg(2)).structure()->arg(0)).bits());
  EXPECT_NE(x.bits(), deref(structure.arg(1)).bits());
}

TEST_F(TransferTest, MakesVariablesThatAreNotTheOldOnes) {
  const Value old = from_.term("X");
  EXPECT_NE(transfer(old, to_).bits(), old.bits());
}

TEST_F(TransferTest, SharesVariablesBetweenTermsOfOneTransfer) {
  Transfer transfer(to_);
  const Value first = transfer.copy(from_.term("X"));
  EXPECT_EQ(transfer.copy(from_.term("X")).bits(), first.bits());
  EXPECT_NE(Transfer(to_).copy(from_.term("X")).bits(), first.bits());
}

TEST_F(TransferTest, CopiesWhatIsBoundAndNotTheVariable) {
  ASSERT_TRUE(from_.unify("X", "f(Y)"));
  ASSERT_TRUE(from_.unify("Y", "3"));
  EXPECT_EQ(text(transfer(from_.term("p(X)"), to_)), "p(f(3))");
}

TEST_F(TransferTest, CopiesCollectionsToo) {
  auto set = std::make_unique<SetObject>();
  set->add(from_.term("f(a)"), from_.symbols);
  SetObject& original = *set;
  const Value object = from_.heap.object(std::move(set));
  const Value copied = transfer(object, to_);
  original.clear();
  EXPECT_EQ(copied.object()->object->size(), 1U) << "agents share nothing";
}

TEST_F(TransferTest, RefusesTermsThatAreTooDeep) {
  Value term = Value::number(1);
  const Predicate f =
      from_.symbols.predicate(Signature{.functor = from_.symbols.symbol("f"), .arity = 1});
  for (int i = 0; i < kMaxTermDepth + 1; ++i) term = from_.heap.structure(f, std::span(&term, 1));
  EXPECT_THROW((void)transfer(term, to_), TermTooDeep);
}

TEST_F(TransferTest, TakesLongListsThough) {
  Value list = Value::empty_list();
  for (int i = 0; i < 20'000; ++i) {
    const Value element = Value::number(i);
    list = from_.heap.list(std::span(&element, 1), list);
  }
  const Value copied = transfer(list, to_);
  EXPECT_EQ(copied.pair()->head.as_number(), 19'999);
}

TEST_F(TransferTest, KeepsRandomTermsAsTheyAre) {
  test::Choices choices(9);
  for (int i = 0; i < 300; ++i) {
    const std::string written = test::random_term(choices, {.variables = false});
    const Value term = from_.term(written);
    EXPECT_EQ(compare_terms(transfer(term, to_), term, from_.symbols), 0) << written;
  }
}

}  // namespace
}  // namespace jaywalk
