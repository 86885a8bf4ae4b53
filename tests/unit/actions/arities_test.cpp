// SPDX-License-Identifier: Apache-2.0
// How many arguments each internal action takes, how a call with another number fails, and that a
// call with arguments of the wrong kinds at most fails its plan.

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/logic/action.h"
#include "tests/helpers/run_agents.h"

namespace jaywalk::test {
namespace {

/// A call with `arguments` equal arguments.
std::string call(const ActionDefinition& action, int arguments, const std::string& argument) {
  std::string text = action.name;
  for (int i = 0; i < arguments; ++i) text += (i == 0 ? "(" : ", ") + argument;
  return arguments == 0 ? text : text + ')';
}

/// The output of a plan that makes the call: the error of its failure, or that there was none.
std::vector<std::string> run(const std::string& call) {
  MasOptions options;
  options.max_cycles = 50;
  return printed_by("!go. +!go <- " + call +
                        "; .print(done). -!go[error(E), error_msg(M)] <- .print(E, \": \", M).",
                    options);
}

/// The names of those of which that is so.
template <class Condition>
std::vector<std::string> actions_that(Condition is_so) {
  std::vector<std::string> names;
  for (const ActionDefinition& action : standard_actions().actions()) {
    if (is_so(action)) names.push_back(action.name);
  }
  return names;
}

std::string name_of(const testing::TestParamInfo<std::string>& action) {
  std::string name = action.param.substr(1);
  std::ranges::replace(name, '.', '_');
  return name;
}

class ActionTest : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static const ActionDefinition& action() {
    return *standard_actions().action(GetParam());
  }
};
class CountingItsLeast : public ActionTest {};
class CountingItsMost : public ActionTest {};
class Harmless : public ActionTest {};
class EachAction : public ActionTest {};

TEST_P(CountingItsLeast, SaysHowManyArgumentsItTakesWhereThereAreTooFew) {
  const auto lines = run(call(action(), action().least_args - 1, "a"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "wrong_arguments: " + wrong_number_of_arguments(action()));
}

TEST_P(CountingItsMost, SaysHowManyArgumentsItTakesWhereThereAreTooMany) {
  const auto lines = run(call(action(), action().most_args + 1, "a"));
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], "wrong_arguments: " + wrong_number_of_arguments(action()));
}

TEST_P(EachAction, IsCalledAsItsSignatureSays) {
  EXPECT_EQ(action().signature.substr(0, action().signature.find('(')), action().name);
  EXPECT_FALSE(action().summary.empty());
  const auto commas = std::count(action().signature.begin(), action().signature.end(), ',');
  const int shown =
      action().signature.find('(') == std::string::npos ? 0 : static_cast<int>(commas) + 1;
  if (action().signature.find("...") != std::string::npos) {
    EXPECT_LT(action().most_args, 0) << "dots stand for any number";
  } else {
    EXPECT_GE(shown, action().least_args) << action().signature;
    EXPECT_LE(shown, action().most_args) << action().signature;
  }
  if (action().most_args >= 0) {
    EXPECT_LE(action().least_args, action().most_args);
  }
}

TEST_P(Harmless, OfOddArgumentsLeavesItsAgentAlive) {
  const int most = action().most_args < 0 ? action().least_args + 2 : action().most_args;
  for (int count = action().least_args; count <= most; ++count) {
    for (const char* odd : {"X", "-1", "1e300", "\"\"", "[]", "~p(1)[q]", "{ +!g <- .print(1) }"}) {
      const std::string made = call(action(), count, odd);
      // However the call ends (it may wait for ever, or drop the goal), a message is processed.
      const AgentRun run =
          run_agents({{"agent", "!go. +!go <- " + made + ". -!go. +ping <- .print(alive)."},
                      {"other", "!go. +!go <- .wait(1000); .send(agent, tell, ping)."}},
                     {.max_cycles = 200});
      if (!run.errors.empty()) continue;  // refused at its place, before anything ran
      EXPECT_THAT(run.printed_by("agent"), testing::Contains("alive")) << made;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Actions, CountingItsLeast,
                         testing::ValuesIn(actions_that([](const ActionDefinition& action) {
                           return action.least_args > 0 && !action.is_uncounted;
                         })),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Actions, CountingItsMost,
                         testing::ValuesIn(actions_that([](const ActionDefinition& action) {
                           return action.most_args >= 0 && !action.is_uncounted;
                         })),
                         name_of);
// Others may end the agent, or change what it prints.
INSTANTIATE_TEST_SUITE_P(Actions, Harmless,
                         testing::ValuesIn(actions_that([](const ActionDefinition& action) {
                           return action.name != ".stopMAS" && action.name != ".kill_agent" &&
                                  action.name != ".verbose";
                         })),
                         name_of);
INSTANTIATE_TEST_SUITE_P(
    Actions, EachAction,
    testing::ValuesIn(actions_that([](const ActionDefinition&) { return true; })), name_of);

TEST(WrongNumberOfArguments, IsSaidInTheWordsOfJason) {
  const auto said = [](int least, int most) {
    return wrong_number_of_arguments({.name = ".set.add", .least_args = least, .most_args = most});
  };
  const std::string begin =
      "The internal action 'add' has not received the required number of argument(s). ";
  EXPECT_EQ(said(1, 1), begin + "One argument is expected.");
  EXPECT_EQ(said(2, 2), begin + "2 arguments are expected.");
  EXPECT_EQ(said(0, 0), begin + "0 arguments are expected.");
  EXPECT_EQ(said(1, 3), begin + "From 1 to 3 arguments are expected.");
  EXPECT_EQ(said(1, -1), begin + "From 1 to 2147483647 arguments are expected.");
}

TEST(Takes, CountsUnlessJasonDoesNot) {
  const ActionDefinition counted{.name = ".a", .least_args = 1, .most_args = 2};
  EXPECT_FALSE(takes(counted, 0));
  EXPECT_TRUE(takes(counted, 1));
  EXPECT_TRUE(takes(counted, 2));
  EXPECT_FALSE(takes(counted, 3));
  ActionDefinition uncounted = counted;
  uncounted.is_uncounted = true;
  EXPECT_FALSE(takes(uncounted, 0));
  EXPECT_TRUE(takes(uncounted, 30));
  EXPECT_TRUE(takes({.name = ".b", .least_args = 0, .most_args = -1}, 30));
}

}  // namespace
}  // namespace jaywalk::test
