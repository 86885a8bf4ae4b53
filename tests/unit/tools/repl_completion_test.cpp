// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/repl/repl_input.h"

namespace jaywalk {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class ReplCompletion : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> candidates(std::string_view before) const {
    return complete_input(before, names).candidates;
  }

  ReplNames names{.commands = {"load", "beliefs", "rules", "reload"},
                  .predicates = {"likes", "price", "likely"},
                  .goals = {"buy", "bring", "likes"},
                  .actions = {".print", ".println", ".length", "math.max"}};
};

TEST_F(ReplCompletion, OffersCommandsAfterAColon) {
  EXPECT_THAT(candidates(":"), ElementsAre("beliefs", "load", "reload", "rules"));
  EXPECT_THAT(candidates("  :r"), ElementsAre("reload", "rules"));
  EXPECT_THAT(candidates(":beliefs li"), ElementsAre("likely", "likes"));
  EXPECT_THAT(candidates(":plans b"), ElementsAre("bring", "buy"));
  EXPECT_THAT(candidates(":trace !bu"), ElementsAre("buy"));
  EXPECT_THAT(candidates(":load li"), IsEmpty());
}

TEST_F(ReplCompletion, OffersGoalsAfterAnExclamationMark) {
  EXPECT_THAT(candidates("!b"), ElementsAre("bring", "buy"));
  EXPECT_THAT(candidates("+!x <- !!bu"), ElementsAre("buy"));
}

TEST_F(ReplCompletion, OffersActionsAfterAFullStop) {
  EXPECT_THAT(candidates("?- .p"), ElementsAre(".print", ".println"));
  EXPECT_THAT(candidates("?- X = math."), ElementsAre("math.max"));
  EXPECT_THAT(candidates("?- ma"), ElementsAre("math.max"));
}

TEST_F(ReplCompletion, OffersWhatIsBelievedElsewhere) {
  EXPECT_THAT(candidates("?- lik"), ElementsAre("likely", "likes"));
  EXPECT_THAT(candidates("+pr"), ElementsAre("price"));
  EXPECT_THAT(candidates("?- Lik"), IsEmpty());
}

TEST_F(ReplCompletion, OffersNothingWithinAString) {
  EXPECT_THAT(candidates("?- p(\"li"), IsEmpty());
}

TEST_F(ReplCompletion, KnowsWhatCandidatesShare) {
  const Completion completion = complete_input("?- .pr", names);
  EXPECT_EQ(completion.replaced, 3U);
  EXPECT_EQ(completion.common(), ".print");
  EXPECT_EQ(complete_input("?- nothing", names).common(), "");
}

}  // namespace
}  // namespace jaywalk
