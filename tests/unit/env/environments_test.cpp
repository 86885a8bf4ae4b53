#include "env/environments.h"

#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace jaywalk
