// SPDX-License-Identifier: Apache-2.0
#include "interpreter/term/compare.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/term/print.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

struct Pairing {
  std::string a;
  std::string b;
};

TEST(EqualTerms, HoldForTermsThatSayTheSame) {
  const std::vector<Pairing> rows{
      {"1", "1.0"},
      {"0", "0.0"},
      {"\"a\"", "\"a\""},
      {"a", "a"},
      {"f(a,[1])", "f(a,[1])"},
      {"p[a,b]", "p[b,a,b]"},
      {"[a|[b]]", "[a,b]"},
      {"~p(1)", "~p(1)"},
      {"{ !g; ?t }", "{ !g; ?t }"},
  };
  for (const Pairing& row : rows) {
    test::Terms terms;
    EXPECT_TRUE(equal_terms(terms.term(row.a), terms.term(row.b))) << row.a << " == " << row.b;
    EXPECT_TRUE(equal_terms(terms.term(row.b), terms.term(row.a))) << row.b << " == " << row.a;
  }
}

TEST(EqualTerms, DoNotHoldForTermsThatDiffer) {
  const std::vector<Pairing> rows{
      {"1", "2"},           {"1", "\"1\""},     {"a", "'a'"},     {"a", "\"a\""},
      {"p", "~p"},          {"p(1)", "p(2)"},   {"p(1)", "q(1)"}, {"p(1)", "p(1,1)"},
      {"p", "p[a]"},        {"p[a]", "p[a,b]"}, {"n::p", "m::p"}, {"[a]", "[a,b]"},
      {"[]", "[a]"},        {"X", "Y"},         {"_", "_"},       {"f(p[a])", "f(p)"},
      {"{ !g }", "{ ?g }"},
  };
  for (const Pairing& row : rows) {
    test::Terms terms;
    EXPECT_FALSE(equal_terms(terms.term(row.a), terms.term(row.b))) << row.a << " == " << row.b;
    EXPECT_FALSE(equal_terms(terms.term(row.b), terms.term(row.a))) << row.b << " == " << row.a;
  }
}

TEST(EqualTerms, MayIgnoreTheAnnotationsOfTheWholeButNotOfParts) {
  test::Terms terms;
  EXPECT_TRUE(equal_terms(terms.term("p(1)[a]"), terms.term("p(1)[b]"), Annotations::ignore));
  EXPECT_TRUE(equal_terms(terms.term("p[a]"), terms.term("p"), Annotations::ignore));
  EXPECT_FALSE(equal_terms(terms.term("p(q[a])"), terms.term("p(q)"), Annotations::ignore));
}

TEST(EqualTerms, FollowVariables) {
  test::Terms terms;
  ASSERT_TRUE(terms.unify("X", "f(Y)"));
  ASSERT_TRUE(terms.unify("Y", "2"));
  EXPECT_TRUE(equal_terms(terms.term("X"), terms.term("f(2)")));
  EXPECT_EQ(hash_term(terms.term("X")), hash_term(terms.term("f(2)")));
}

TEST(EqualTerms, EndForListsThatEndInThemselves) {
  test::Terms terms;
  const Value a = terms.term("A");
  const Value b = terms.term("B");
  a.variable()->value = terms.term("[1|A]");
  b.variable()->value = terms.term("[1,1|B]");
  EXPECT_THROW((void)equal_terms(a, b), TermTooDeep);
  EXPECT_THROW((void)compare_terms(a, b, terms.symbols), TermTooDeep);
  EXPECT_THROW((void)hash_term(a), TermTooDeep);
  EXPECT_THROW((void)is_ground(a), TermTooDeep);
}

// The order of the language: each term is below all those behind it.
TEST(CompareTerms, PutsTermsInJasonsOrder) {
  test::Terms terms;
  const std::vector<std::string> ascending{
      "-1",    "0",    "0.5",    "2",       "10",     "\"\"",   "\"B\"",   "\"a\"",
      "\"b\"", "[]",   "[1]",    "[1,2]",   "[1,3]",  "[2]",    "[\"a\"]", "'A'",
      "a",     "a[k]", "a(1)",   "a(1)[k]", "a(1,0)", "a(1,2)", "a(2)",    "~a",
      "aa",    "b(a)", "b(a,0)", "b(b)",    "z",      "X",      "Y",
  };
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t j = 0; j < ascending.size(); ++j) {
      const int order =
          compare_terms(terms.term(ascending[i]), terms.term(ascending[j]), terms.symbols);
      const bool as_expected = i < j ? order < 0 : i > j ? order > 0 : order == 0;
      EXPECT_TRUE(as_expected) << ascending[i] << " against " << ascending[j] << ": " << order;
    }
  }
}

TEST(CompareTerms, PutsNamespacesBeforeFunctors) {
  test::Terms terms;
  EXPECT_LT(compare_terms(terms.term("m::z"), terms.term("n::a"), terms.symbols), 0);
  EXPECT_GT(compare_terms(terms.term("n::a"), terms.term("m::z"), terms.symbols), 0);
}

TEST(CompareTerms, PutsNamedVariablesBeforeUnnamedOnes) {
  test::Terms terms;
  EXPECT_LT(compare_terms(terms.term("Z"), terms.term("_"), terms.symbols), 0);
}

TEST(HashTerm, IsEqualForEqualTerms) {
  const std::vector<Pairing> rows{
      {"1", "1.0"},         {"p(1)[a]", "p(1)[b]"}, {"p", "p[a]"},
      {"[a,b]", "[a|[b]]"}, {"\"x\"", "\"x\""},     {"f(0)", "f(0.0)"},
  };
  for (const Pairing& row : rows) {
    test::Terms terms;
    EXPECT_EQ(hash_term(terms.term(row.a)), hash_term(terms.term(row.b))) << row.a << ", " << row.b;
    EXPECT_NE(hash_term(terms.term(row.a)), 0U) << row.a;
  }
}

TEST(HashTerm, IsTheSameForBothZeros) {
  EXPECT_EQ(hash_term(Value::number(-0.0)), hash_term(Value::number(0.0)));
}

TEST(HashTerm, IsZeroForOpenTerms) {
  test::Terms terms;
  for (const char* const open : {"X", "f(X)", "[a|T]", "f([X])"}) {
    EXPECT_EQ(hash_term(terms.term(open)), 0U) << open;
  }
}

TEST(HashTerm, TellsMostTermsApart) {
  test::Terms terms;
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 1000; ++i) {
    hashes.push_back(hash_term(terms.term("p(" + std::to_string(i) + ")")));
    hashes.push_back(hash_term(terms.term("[" + std::to_string(i) + "]")));
    hashes.push_back(hash_term(terms.term("a" + std::to_string(i))));
  }
  std::sort(hashes.begin(), hashes.end());
  EXPECT_EQ(std::unique(hashes.begin(), hashes.end()), hashes.end());
}

TEST(IsGround, LooksIntoEveryPart) {
  test::Terms terms;
  EXPECT_TRUE(is_ground(terms.term("f(a,[1,2],\"s\")[k]")));
  for (const char* const open : {"X", "f(X)", "[a|T]", "[X]", "p[k(X)]", "p[k|T]", "X + 1"}) {
    EXPECT_FALSE(is_ground(terms.term(open))) << open;
  }
  ASSERT_TRUE(terms.unify("X", "1"));
  EXPECT_TRUE(is_ground(terms.term("f(X)")));
}

TEST(SortedSet, SortsAndDropsDuplicates) {
  test::Terms terms;
  const auto sorted = [&](std::string_view list) {
    return term_text(sorted_set(terms.heap, terms.term(list), terms.symbols), terms.symbols);
  };
  EXPECT_EQ(sorted("[b,a,b,1,\"s\",a]"), "[1,\"s\",a,b]");
  EXPECT_EQ(sorted("[]"), "[]");
  EXPECT_EQ(sorted("[a]"), "[a]");
  EXPECT_EQ(sorted("[b,a|T]"), "[a,b|T]");
  EXPECT_EQ(sorted("[f(2),f(1),f]"), "[f,f(1),f(2)]");
}

// Few elements are put in order in another way than many.
TEST(SortedSet, IsInOrderWhateverTheNumberOfElements) {
  test::Terms terms;
  for (std::size_t count = 2; count < 40; ++count) {
    std::vector<Value> elements;
    for (std::size_t i = 0; i < count; ++i) {
      elements.push_back(terms.term("f(" + std::to_string(i * 7919 % 23) + ")"));
    }
    std::set<double> numbers;
    for (const Value each : elements) numbers.insert(each.structure()->arg(0).as_number());
    std::vector<Value> sorted;
    const Value end = append_elements(
        sorted, sorted_set(terms.heap, elements, Value::empty_list(), terms.symbols));
    EXPECT_TRUE(end.is_empty_list());
    ASSERT_EQ(sorted.size(), numbers.size()) << count;
    EXPECT_TRUE(std::ranges::equal(sorted, numbers, {}, [](Value each) {
      return each.structure()->arg(0).as_number();
    })) << count;
  }
}

TEST(SortedSet, KeepsTheFirstOfEqualElements) {
  test::Terms terms;
  const Value first = terms.term("f(1)");
  const Value second = terms.term("f(1)");
  ASSERT_FALSE(first.same_as(second));
  for (const std::size_t others : {0U, 20U}) {
    std::vector<Value> elements{first, second};
    for (std::size_t i = 0; i < others; ++i)
      elements.push_back(Value::number(static_cast<double>(i)));
    std::vector<Value> sorted;
    (void)append_elements(sorted,
                          sorted_set(terms.heap, elements, Value::empty_list(), terms.symbols));
    EXPECT_TRUE(sorted.back().same_as(first)) << others;
  }
}

TEST(UnionOf, HasWhatEitherHas) {
  test::Terms terms;
  const auto both = [&](std::string_view a, std::string_view b) {
    return term_text(union_of(terms.heap, terms.term(a), terms.term(b), terms.symbols),
                     terms.symbols);
  };
  EXPECT_EQ(both("[a,c]", "[b,c]"), "[a,b,c]");
  EXPECT_EQ(both("[]", "[b]"), "[b]");
  EXPECT_EQ(both("[a]", "[]"), "[a]");
  EXPECT_EQ(both("[]", "[]"), "[]");
}

TEST(SortedSet, IsTheListItselfIfThatIsInOrder) {
  test::Terms terms;
  const Value ordered = terms.term("[1,a,f(2)]");
  EXPECT_TRUE(sorted_set(terms.heap, ordered, terms.symbols).same_as(ordered));
}

// One element, as `source(self)` mostly is, goes straight to its place: as it does beside others.
TEST(UnionOf, PutsOneElementWhereItBelongsInAnySet) {
  test::Terms terms;
  for (std::size_t count = 0; count < 16; ++count) {
    for (std::size_t element = 0; element <= 2 * count; ++element) {
      std::vector<Value> odd;
      for (std::size_t i = 0; i < count; ++i)
        odd.push_back(Value::number(static_cast<double>(2 * i + 1)));
      std::ranges::reverse(odd);  // sets that are not in order are put in order
      const Value list = terms.heap.list(odd);
      const Value set = element % 3 == 0 ? list : sorted_set(terms.heap, list, terms.symbols);
      const Value one = terms.heap.list(std::vector{Value::number(static_cast<double>(element))});
      odd.push_back(Value::number(static_cast<double>(element)));
      EXPECT_EQ(term_text(union_of(terms.heap, set, one, terms.symbols), terms.symbols),
                term_text(sorted_set(terms.heap, odd, Value::empty_list(), terms.symbols),
                          terms.symbols));
    }
  }
}

TEST(UnionOf, KeepsTheElementThatTheFirstSetHas) {
  test::Terms terms;
  const Value set = terms.term("[a,f(1)]");
  std::vector<Value> united;
  (void)append_elements(united, union_of(terms.heap, set, terms.term("[f(1)]"), terms.symbols));
  ASSERT_EQ(united.size(), 2U);
  EXPECT_TRUE(united[1].same_as(set.pair()->tail.pair()->head));
}

TEST(UnionOf, KeepsAnOpenEnd) {
  test::Terms terms;
  EXPECT_EQ(term_text(union_of(terms.heap, terms.term("[b|T]"), terms.term("[a]"), terms.symbols),
                      terms.symbols),
            "[a,b|T]");
}

}  // namespace
}  // namespace jaywalk
