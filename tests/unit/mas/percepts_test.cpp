// SPDX-License-Identifier: Apache-2.0
// An agent's percepts, look by look: how Percepts compares with the last one, and that beliefs are
// the same whether they are updated by all percepts or by the changes.

#include "interpreter/environment/percepts.h"

#include <array>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/term/print.h"
#include "tests/helpers/terms.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A list of percepts: predicate number and argument; the predicates are p/1, q/1, ...
using Sights = std::vector<std::pair<int, int>>;

class Looks : public testing::Test {
 protected:
  void look(const Sights& sights) {
    percepts.begin_look();
    for (const auto& [name, arg] : sights) percepts.add(predicate(name), {Value::number(arg)});
    percepts.end_look();
  }
  Predicate predicate(int number) {
    return symbols.predicate(std::string(1, static_cast<char>('p' + number)), 1);
  }

  std::vector<std::string> news() {
    std::vector<std::string> all;
    for (const std::uint32_t i : percepts.news()) {
      all.push_back(text(percepts.predicate(i), percepts.args(i)));
    }
    return all;
  }
  std::vector<std::string> gone() {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < percepts.gone_size(); ++i) {
      all.push_back(text(percepts.gone_predicate(i), percepts.gone_args(i)));
    }
    return all;
  }
  std::string text(Predicate name, std::span<const Value> args) {
    return fmt::format("{}({})", symbols.functor(name), args[0].as_number());
  }

  SymbolTable symbols;
  Percepts percepts;
};

TEST_F(Looks, AreAllNewsTheFirstTime) {
  look({{0, 1}, {1, 2}});
  EXPECT_THAT(news(), ElementsAre("p(1)", "q(2)"));
  EXPECT_THAT(gone(), IsEmpty());
}

TEST_F(Looks, SayNothingOfWhatIsAsItWas) {
  look({{0, 1}, {1, 2}});
  look({{0, 1}, {1, 2}});
  EXPECT_THAT(news(), IsEmpty());
  EXPECT_THAT(gone(), IsEmpty());
  EXPECT_EQ(percepts.size(), 2U);
}

TEST_F(Looks, SayWhichArgumentsHaveChanged) {
  look({{0, 1}, {1, 2}, {0, 5}});
  look({{0, 1}, {1, 3}, {0, 5}});
  EXPECT_THAT(news(), ElementsAre("q(3)"));
  EXPECT_THAT(gone(), ElementsAre("q(2)"));
}

TEST_F(Looks, KeepTheEndBehindWhatComesAndGoes) {
  look({{0, 1}, {2, 7}, {2, 8}});
  look({{0, 2}, {1, 3}, {2, 7}, {2, 8}});
  EXPECT_THAT(news(), ElementsAre("p(2)", "q(3)"));
  EXPECT_THAT(gone(), ElementsAre("p(1)"));
  look({{0, 2}, {2, 7}, {2, 8}});
  EXPECT_THAT(news(), IsEmpty());
  EXPECT_THAT(gone(), ElementsAre("q(3)"));
  look({});
  EXPECT_EQ(percepts.size(), 0U);
  EXPECT_THAT(gone(), ElementsAre("p(2)", "r(7)", "r(8)"));
}

TEST_F(Looks, KeepTheRestIfItsNumberIsTheSame) {
  const auto look_at = [&](int first, std::uint64_t number) {
    percepts.begin_look();
    percepts.add(predicate(0), {Value::number(first)});
    if (!percepts.keep_rest(predicate(1), number)) {
      percepts.add(predicate(1), {Value::number(static_cast<double>(number))});
      percepts.add(predicate(2), {Value::number(7)});
    }
    percepts.end_look();
  };
  look_at(1, 5);
  EXPECT_THAT(news(), ElementsAre("p(1)", "q(5)", "r(7)"));
  look_at(2, 5);
  EXPECT_THAT(news(), ElementsAre("p(2)"));
  EXPECT_THAT(gone(), ElementsAre("p(1)"));
  EXPECT_EQ(percepts.size(), 3U);
  look_at(2, 6);
  EXPECT_THAT(news(), ElementsAre("q(6)"));
  EXPECT_THAT(gone(), ElementsAre("q(5)"));
  percepts.clear();
  look_at(2, 6);
  EXPECT_THAT(news(), ElementsAre("p(2)", "q(6)", "r(7)"));
}

TEST_F(Looks, TellTheRestIfWhatStandsBeforeItHasLeft) {
  look({{0, 1}, {0, 2}, {1, 5}});
  percepts.begin_look();
  percepts.add(predicate(0), {Value::number(1)});
  EXPECT_FALSE(percepts.keep_rest(predicate(1), 0));
  percepts.end_look();
}

TEST_F(Looks, SayHowManyHaveChangedInTheirPlaces) {
  look({{0, 1}, {1, 2}, {2, 3}});
  EXPECT_EQ(percepts.changed_size(), 0U);
  look({{0, 1}, {1, 3}, {2, 4}, {2, 5}});
  EXPECT_EQ(percepts.changed_size(), 2U);
}

/// Beliefs that are brought up to date in one of the two ways.
class Beliefs {
 public:
  explicit Beliefs(bool changes_alone) : by_changes_(changes_alone) {}

  /// The changes, removals first.
  std::vector<std::string> update(const std::vector<std::string>& literals) {
    percepts_.begin_look();
    for (const std::string& literal : literals) {
      const LiteralParts parts = literal_parts(terms.term(literal));
      percepts_.add(parts.predicate, parts.args, parts.annots);
    }
    percepts_.end_look();
    std::vector<std::string> news;
    std::vector<BeliefBase::PerceptChange> gone;
    const bool known = terms.beliefs.knows_percepts();
    terms.beliefs.begin_percepts();
    const auto perceive = [&](std::size_t i) {
      BeliefBase::PerceptChange change;
      if (terms.beliefs.perceive(percepts_.predicate(i), percepts_.args(i), change,
                                 percepts_.annotations(i))) {
        news.push_back("+" + term_text(change.literal, terms.symbols));
      }
    };
    if (by_changes_ && known) {
      ++by_changes;
      for (const std::uint32_t i : percepts_.news()) perceive(i);
      for (std::size_t i = 0; i < percepts_.gone_size(); ++i) {
        terms.beliefs.miss(percepts_.gone_predicate(i), percepts_.gone_args(i));
      }
      terms.beliefs.end_missed(gone);
    } else {
      for (std::size_t i = 0; i < percepts_.size(); ++i) perceive(i);
      terms.beliefs.end_percepts(gone);
    }
    std::vector<std::string> changes;
    for (const auto& change : gone) {
      changes.push_back("-" + term_text(change.literal, terms.symbols));
    }
    changes.insert(changes.end(), news.begin(), news.end());
    terms.beliefs.compact();
    return changes;
  }
  void add(const std::string& literal) { (void)terms.beliefs.add(terms.term(literal)); }
  void remove(const std::string& literal) {
    (void)terms.beliefs.remove(terms.term(literal), terms.unifier());
    terms.beliefs.compact();
  }
  std::vector<std::string> all() {
    std::vector<std::string> texts;
    for (const auto& relation : terms.beliefs.relations()) {
      for (std::int64_t seq = relation->first_seq(); seq < relation->end_seq(); ++seq) {
        const Row& row = relation->row(seq);
        if (!row.is_hole()) texts.push_back(term_text(row.fact, terms.symbols));
      }
    }
    return texts;
  }

  int by_changes = 0;

 private:
  test::Terms terms;
  Percepts percepts_;
  bool by_changes_;
};

// Lists that change a little or a lot, with repeated literals, all kinds of terms and annotations,
// and an agent that deletes percepts and believes some of them by itself.
TEST(BeliefUpdate, IsTheSameByChangesAsByAllPercepts) {
  std::mt19937 random(7);
  const auto below = [&](int bound) {
    return static_cast<int>(random() % static_cast<unsigned>(bound));
  };
  const auto plain = [&] {
    constexpr std::array<const char*, 4> kTerms = {"0", "[0,\"t\"]", "f(0)", "\"0\""};
    return fmt::format("{}({},{})", "pqr"[below(3)], below(4),
                       kTerms[static_cast<std::size_t>(below(4))]);
  };
  const auto literal = [&] { return plain() + (below(5) == 0 ? "[c(1)]" : ""); };
  int by_changes = 0;
  for (int run = 0; run < 300; ++run) {
    Beliefs fast(true);
    Beliefs slow(false);
    std::vector<std::string> sights;
    for (int tick = 0; tick < 30; ++tick) {
      for (int change = below(4); change > 0; --change) {
        const auto place = static_cast<std::size_t>(below(static_cast<int>(sights.size()) + 1));
        switch (below(3)) {
          case 0:
            sights.insert(sights.begin() + static_cast<std::ptrdiff_t>(place), literal());
            break;
          case 1:
            if (place < sights.size())
              sights.erase(sights.begin() + static_cast<std::ptrdiff_t>(place));
            break;
          default:
            if (place < sights.size()) sights[place] = literal();
        }
      }
      ASSERT_EQ(fast.update(sights), slow.update(sights)) << "run " << run << ", tick " << tick;
      if (below(8) == 0) {
        const std::string own = plain() + (below(2) == 0 ? "[source(self)]" : "[source(percept)]");
        const bool adds = below(2) == 0;
        for (Beliefs* const each : {&fast, &slow}) adds ? each->add(own) : each->remove(own);
      }
      ASSERT_EQ(fast.all(), slow.all()) << "run " << run << ", tick " << tick;
    }
    by_changes += fast.by_changes;
  }
  EXPECT_GT(by_changes, 2000);  // of 9000 updates
}

/// In each tick every agent perceives what a list says, by name and arguments.
class World : public Environment {
 public:
  World(SymbolTable& symbols, std::vector<Sights> ticks) : ticks_(std::move(ticks)) {
    for (const char* const name : {"p", "q", "r", "s"})
      names_.push_back(symbols.predicate(name, 1));
  }

  void perceive(AgentId, Percepts& percepts) const override {
    for (const auto& [name, arg] : ticks_[now_]) {
      percepts.add(names_[static_cast<std::size_t>(name)], {Value::number(arg)});
    }
  }
  void execute(std::span<const ActionRequest>, std::span<ActionResult>) override {}
  void advance() override { ++now_; }
  [[nodiscard]] bool finished() const override { return now_ == ticks_.size(); }
  [[nodiscard]] double tick_ms() const override { return 100; }

 private:
  std::vector<Predicate> names_;
  std::vector<Sights> ticks_;
  std::size_t now_ = 0;
};

// One agent has a plan for a change of belief, the other has none: so only the first makes events.
TEST(BeliefUpdate, IsTheSameIfNobodyHearsOfIt) {
  std::mt19937 random(11);
  const auto below = [&](std::size_t bound) { return static_cast<int>(random() % bound); };
  for (int run = 0; run < 200; ++run) {
    std::vector<Sights> ticks;
    Sights sights;
    for (int tick = 0; tick < 12; ++tick) {
      for (int change = below(3); change >= 0; --change) {
        const auto place = static_cast<std::ptrdiff_t>(below(sights.size() + 1));
        const std::pair<int, int> sight{below(4), below(3)};
        if (place == std::ssize(sights) || below(5) == 0) {
          sights.insert(sights.begin() + place, sight);
        } else if (below(4) == 0) {
          sights.erase(sights.begin() + place);
        } else {
          sights[static_cast<std::size_t>(place)].second = sight.second;
        }
      }
      ticks.push_back(sights);
    }
    test::System system;
    system.add("hears", "p(9). !act. +never. +!act <- -q(1); +r(1); act; !act. -!act <- !act.");
    system.add("deaf", "p(9). !act. +!act <- -q(1); +r(1); act; !act. -!act <- !act.");
    World world(*system.symbols, ticks);
    (void)system.run(&world);
    EXPECT_EQ(system.mas->describe_beliefs(AgentId{0}), system.mas->describe_beliefs(AgentId{1}))
        << "run " << run;
  }
}

}  // namespace
}  // namespace jaywalk
