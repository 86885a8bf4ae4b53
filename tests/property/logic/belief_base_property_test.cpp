// SPDX-License-Identifier: Apache-2.0
// The belief base against the simplest thing that could do the same: a list of texts.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/term/print.h"
#include "tests/helpers/generate.h"
#include "tests/helpers/terms.h"

namespace jaywalk {
namespace {

/// Facts p(A,B) with sources, newest first.
class Model {
 public:
  struct Fact {
    std::string args;
    std::set<std::string> annots;
  };

  /// The annotations that are new.
  std::set<std::string> add(const std::string& args, const std::set<std::string>& annots,
                            bool at_back) {
    const auto known = find(args);
    if (known == facts_.end()) {
      facts_.insert(at_back ? facts_.end() : facts_.begin(), Fact{args, annots});
      return annots;
    }
    std::set<std::string> news;
    for (const std::string& annot : annots) {
      if (known->annots.insert(annot).second) news.insert(annot);
    }
    return news;
  }

  bool remove(const std::string& args, const std::set<std::string>& annots) {
    const auto known = find(args);
    if (known == facts_.end()) return false;
    if (!std::includes(known->annots.begin(), known->annots.end(), annots.begin(), annots.end())) {
      return false;
    }
    for (const std::string& annot : annots) known->annots.erase(annot);
    const bool has_source =
        std::any_of(known->annots.begin(), known->annots.end(),
                    [](const std::string& annot) { return annot.starts_with("source("); });
    if (!has_source) facts_.erase(known);
    return true;
  }

  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> all;
    for (const Fact& fact : facts_) all.push_back("p(" + fact.args + ")" + text(fact.annots));
    return all;
  }

  /// The facts whose first or second argument is this one.
  [[nodiscard]] std::vector<std::string> with_argument(const std::string& arg, bool first) const {
    std::vector<std::string> all;
    for (const Fact& fact : facts_) {
      const std::size_t comma = fact.args.find(',');
      const std::string one = fact.args.substr(0, comma);
      const std::string two = fact.args.substr(comma + 1);
      if ((first ? one : two) == arg) all.push_back(first ? two : one);
    }
    return all;
  }

  static std::string text(const std::set<std::string>& annots) {
    std::string out = "[";
    for (const std::string& annot : annots) out += (out.size() > 1 ? "," : "") + annot;
    return out + "]";
  }

 private:
  std::vector<Fact>::iterator find(const std::string& args) {
    return std::find_if(facts_.begin(), facts_.end(),
                        [&](const Fact& fact) { return fact.args == args; });
  }

  std::vector<Fact> facts_;
};

std::set<std::string> random_annots(test::Choices& choices) {
  std::set<std::string> annots{std::string(choices.one_of({"source(ann)", "source(self)"}))};
  if (choices.once_in(3)) annots.insert("k");
  if (choices.once_in(4)) annots.insert("source(bob)");
  return annots;
}

void run_against_model(std::uint64_t seed, std::size_t operations, std::size_t values) {
  test::Choices choices(seed);
  test::Terms terms;
  Model model;
  for (std::size_t i = 0; i < operations; ++i) {
    const std::string first = std::to_string(choices.below(values));
    const std::string second = std::string(choices.one_of({"a", "[b]", "\"c\"", "d(1)"}));
    const std::string args = first + "," + second;
    const std::set<std::string> annots = random_annots(choices);
    const std::string literal = "p(" + args + ")" + Model::text(annots);
    const std::string where =
        "seed " + std::to_string(seed) + ", operation " + std::to_string(i) + ": " + literal;
    const std::size_t kind = choices.below(20);
    if (kind < 10) {
      const bool at_back = choices.once_in(5);
      const auto added =
          terms.beliefs.add(terms.term(literal), at_back ? Place::back : Place::front);
      const std::set<std::string> news = model.add(args, annots, at_back);
      ASSERT_EQ(added.has_value(), !news.empty()) << "+" << where;
      if (added) {
        ASSERT_EQ(term_text(*added, terms.symbols), "p(" + args + ")" + Model::text(news)) << where;
      }
    } else if (kind < 16) {
      ASSERT_EQ(terms.beliefs.remove(terms.term(literal), terms.unifier()),
                model.remove(args, annots))
          << "-" << where;
    } else if (kind < 17) {
      terms.beliefs.compact();
    } else if (kind < 18) {
      terms.new_scope();
      ASSERT_EQ(terms.answers("p(" + first + ",V)", "V"), model.with_argument(first, true))
          << where;
    } else if (kind < 19) {
      terms.new_scope();
      ASSERT_EQ(terms.answers("p(V," + second + ")", "V"), model.with_argument(second, false))
          << where;
    } else {
      terms.heap.collect([&](Heap::Relocator& relocate) {
        terms.beliefs.visit_terms([&](Value& value) { relocate(value); });
      });
      terms.new_scope();
    }
  }
  ASSERT_EQ(terms.facts("p", 2), model.texts()) << "seed " << seed;
}

TEST(BeliefBaseProperty, AgreesWithAListOfAFewFacts) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    ASSERT_NO_FATAL_FAILURE(run_against_model(seed, 100, 3));
  }
}

TEST(BeliefBaseProperty, AgreesWithAListOfManyFacts) {
  for (std::uint64_t seed = 1000; seed < 1020; ++seed) {
    ASSERT_NO_FATAL_FAILURE(run_against_model(seed, 2000, 200));
  }
}

}  // namespace
}  // namespace jaywalk
