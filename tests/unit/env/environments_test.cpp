// SPDX-License-Identifier: Apache-2.0
#include "env/environments.h"

#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "env/crossing/layout.h"
#include "env/crossing/road_user.h"
#include "env/grid/grid.h"

namespace jaywalk {
namespace {

TEST(Environments, AreFoundByName) {
  ASSERT_NE(find_environment("crossing"), nullptr);
  EXPECT_EQ(find_environment("crossing")->name, "crossing");
  EXPECT_EQ(find_environment("crosing"), nullptr);
}

TEST(Environments, HaveWordsWithFunctorAndArity) {
  const EnvironmentWord at{"at(X,Y)", ""};
  const EnvironmentWord stay{"stay", ""};
  EXPECT_EQ(functor(at), "at");
  EXPECT_EQ(arity(at), 2);
  EXPECT_EQ(functor(stay), "stay");
  EXPECT_EQ(arity(stay), 0);
}

TEST(Environments, DescribeEachWordOnce) {
  for (const EnvironmentKind& kind : environments()) {
    EXPECT_FALSE(kind.summary.empty());
    std::set<std::string> seen;
    for (const EnvironmentWord& word : kind.percepts) {
      EXPECT_TRUE(seen.insert(std::string(functor(word))).second) << word.form;
      EXPECT_FALSE(word.meaning.empty()) << word.form;
    }
    for (const EnvironmentWord& word : kind.actions) {
      const std::string indicator = fmt::format("{}/{}", functor(word), arity(word));
      EXPECT_TRUE(seen.insert(indicator).second) << word.form;
      EXPECT_FALSE(word.meaning.empty()) << word.form;
    }
  }
}

TEST(Environments, SayWhichAtomsTheirArgumentsTake) {
  using Values = std::vector<std::vector<std::string>>;
  const EnvironmentWord word{"on(Id,Way,Kind)", "", "Kind: a; Way: b c"};
  EXPECT_EQ(argument_values(word), (Values{{}, {"b", "c"}, {"a"}}));
  EXPECT_EQ(argument_values({"stay", "", ""}), Values{});
  EXPECT_EQ(argument_values({"at(X,Y)", "", ""}), (Values{{}, {}}));
}

TEST(Environments, DeclareTheAtomsThatTheCrossingUses) {
  const auto declared = [](std::string_view form) -> std::set<std::string> {
    std::set<std::string> atoms;
    for (const auto& words :
         {find_environment("crossing")->percepts, find_environment("crossing")->actions}) {
      for (const EnvironmentWord& word : words) {
        if (word.form != form) continue;
        for (const auto& values : argument_values(word)) atoms.insert(values.begin(), values.end());
      }
    }
    return atoms;
  };
  const auto names = []<class Enum>(Enum, int count) {
    std::set<std::string> all;
    for (int i = 0; i < count; ++i) all.emplace(name(static_cast<Enum>(i)));
    return all;
  };
  EXPECT_EQ(declared("move(Way)"), names(Direction{}, kDirectionCount));
  EXPECT_EQ(declared("move(Way,Cells)"), names(Direction{}, kDirectionCount));
  EXPECT_EQ(declared("show(Colour)"), names(SignalColour{}, 3));
  EXPECT_EQ(declared("signal(N,Colour)"), names(SignalColour{}, 3));
  EXPECT_EQ(declared("ground_here(Kind)"), names(Surface{}, 4));
  EXPECT_EQ(declared("crosswalk(N,First,Last,Kind)"), names(CrosswalkKind{}, 2));
}

TEST(Environments, DeclareNoValuesOfArgumentsThatTheFormsDoNotHave) {
  for (const EnvironmentKind& kind : environments()) {
    for (const auto& words : {kind.percepts, kind.actions}) {
      for (const EnvironmentWord& word : words) {
        std::size_t atoms = 0;
        for (const auto& values : argument_values(word)) atoms += values.size();
        std::istringstream all{std::string(word.values)};
        std::string each;
        std::size_t written = 0;
        while (all >> each) written += each.ends_with(':') ? 0 : 1;
        EXPECT_EQ(atoms, written) << word.form;
      }
    }
  }
}

}  // namespace
}  // namespace jaywalk
