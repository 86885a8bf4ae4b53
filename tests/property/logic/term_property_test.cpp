// SPDX-License-Identifier: Apache-2.0
// Laws of terms, over generated ones. A failure names its seed.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/term/compare.h"
#include "interpreter/term/print.h"
#include "tests/helpers/generate.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

using test::Choices;
using test::random_term;
using test::TermKinds;
using test::Terms;

constexpr std::uint64_t kSeeds = 3000;

/// What stands in the variables of the generator.
std::string variables_of(Terms& terms) { return terms.text("vars(X,Y,Z,W)"); }

TEST(TermProperty, UnificationIsSymmetricWithoutAnnotations) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    const TermKinds kinds{.annotations = false};
    const std::string a = random_term(choices, kinds);
    const std::string b = random_term(choices, kinds);
    Terms one;
    Terms two;
    try {
      const bool forth = one.unify(a, b);
      ASSERT_EQ(two.unify(b, a), forth) << "seed " << seed << ": " << a << " = " << b;
      if (!forth) continue;
      ASSERT_EQ(one.text(a), two.text(a)) << "seed " << seed << ": " << a << " = " << b;
    } catch (const TermTooDeep&) {
      // A term that contains itself.
    }
  }
}

TEST(TermProperty, UnifiedTermsAreEqual) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    const TermKinds kinds{.annotations = false};
    const std::string a = random_term(choices, kinds);
    const std::string b = random_term(choices, kinds);
    Terms terms;
    try {
      if (!terms.unify(a, b)) continue;
      ASSERT_TRUE(
          equal_terms(terms.unifier().apply(terms.term(a)), terms.unifier().apply(terms.term(b))))
          << "seed " << seed << ": " << a << " = " << b;
    } catch (const TermTooDeep&) {
    }
  }
}

TEST(TermProperty, FailedUnificationLeavesNoBinding) {
  std::size_t failures = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    const std::string a = random_term(choices, {.expressions = true});
    const std::string b = random_term(choices, {.expressions = true});
    Terms terms;
    const std::string before = variables_of(terms);
    const std::size_t mark = terms.unifier().mark();
    try {
      if (terms.unify(a, b)) continue;
    } catch (const TermTooDeep&) {
      continue;
    }
    ++failures;
    ASSERT_EQ(terms.unifier().mark(), mark) << "seed " << seed << ": " << a << " = " << b;
    ASSERT_EQ(variables_of(terms), before) << "seed " << seed << ": " << a << " = " << b;
  }
  EXPECT_GT(failures, kSeeds / 10);  // else this has tested nothing
}

TEST(TermProperty, UnifyingATermWithItselfBindsNothing) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    const std::string a = random_term(choices, {});
    Terms terms;
    ASSERT_TRUE(terms.unify(a, a)) << "seed " << seed << ": " << a;
    ASSERT_EQ(variables_of(terms), "vars(X,Y,Z,W)") << "seed " << seed << ": " << a;
  }
}

TEST(TermProperty, PrintingThenParsingIsIdentity) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    Terms terms;
    const Value made = terms.term(random_term(choices, {.expressions = true}));
    const std::string printed = term_text(made, terms.symbols);
    const Value again = terms.term(printed);
    ASSERT_EQ(term_text(again, terms.symbols), printed) << "seed " << seed;
    ASSERT_TRUE(equal_terms(made, again)) << "seed " << seed << ": " << printed;
  }
}

TEST(TermProperty, TheOrderIsTotalAndAgreesWithEquality) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    Terms terms;
    const TermKinds kinds{.depth = 2};
    const Value a = terms.term(random_term(choices, kinds));
    const Value b = terms.term(random_term(choices, kinds));
    const Value c = terms.term(random_term(choices, kinds));
    const auto order = [&](Value x, Value y) { return compare_terms(x, y, terms.symbols); };
    const auto sign = [](int value) { return value < 0 ? -1 : value > 0 ? 1 : 0; };
    const std::string which = "seed " + std::to_string(seed) + ": " + terms.text(a) + ", " +
                              terms.text(b) + ", " + terms.text(c);
    ASSERT_EQ(order(a, a), 0) << which;
    ASSERT_EQ(sign(order(a, b)), -sign(order(b, a))) << which;
    ASSERT_EQ(order(a, b) == 0, equal_terms(a, b)) << which;
    if (order(a, b) > 0 || order(b, c) > 0) continue;
    ASSERT_LE(order(a, c), 0) << which;
  }
}

TEST(TermProperty, EqualTermsHaveEqualHashes) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    Terms terms;
    const TermKinds kinds{.variables = false, .depth = 2};
    const Value a = terms.term(random_term(choices, kinds));
    const Value b = terms.term(random_term(choices, kinds));
    if (equal_terms(a, b, Annotations::ignore)) {
      ASSERT_EQ(hash_term(a), hash_term(b)) << terms.text(a) << ", " << terms.text(b);
    }
    ASSERT_NE(hash_term(a), 0U) << terms.text(a);
  }
}

TEST(TermProperty, AFreshCopyUnifiesWithItsOriginalAndSharesNothing) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Choices choices(seed);
    Terms terms;
    const Value original = terms.term(random_term(choices, {}));
    const Value copy = terms.unifier().fresh_copy(original);
    const std::string before = terms.text(original);
    const std::size_t mark = terms.unifier().mark();
    ASSERT_TRUE(terms.unifier().unify(copy, original)) << "seed " << seed << ": " << before;
    terms.unifier().undo(mark);
    ASSERT_EQ(terms.text(original), before) << "seed " << seed;
    ASSERT_EQ(terms.text(copy), before) << "seed " << seed;  // names survive
  }
}

TEST(TermProperty, CollectionChangesNothingThatCanBeSeen) {
  for (std::uint64_t seed = 0; seed < kSeeds / 10; ++seed) {
    Choices choices(seed);
    Terms terms;
    std::vector<Value> roots;
    std::vector<std::string> texts;
    for (int i = 0; i < 5; ++i) {
      roots.push_back(terms.term(random_term(choices, {.expressions = true})));
      (void)terms.term(random_term(choices, {}));  // garbage
    }
    terms.new_scope();
    for (const Value root : roots) texts.push_back(term_text(root, terms.symbols));
    terms.heap.collect([&](Heap::Relocator& relocate) {
      for (Value& root : roots) relocate(root);
    });
    for (std::size_t i = 0; i < roots.size(); ++i) {
      ASSERT_EQ(term_text(roots[i], terms.symbols), texts[i]) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace jaywalk
