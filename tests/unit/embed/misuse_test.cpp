// SPDX-License-Identifier: Apache-2.0
// Whatever is asked of agents that are gone or never were, and whatever programs do: the program
// that embeds goes on.

#include <array>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/mas/mas.h"
#include <jaywalk/interpreter.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

class Misuse : public testing::Test {
 protected:
  AgentId add(const std::string& name, const std::string& text) {
    const auto program = interpreter.load_text(name + ".asl", text);
    EXPECT_TRUE(program) << program.diagnostics().render();
    return interpreter.add_agent(name, program.value());
  }
  void expect_refusals(AgentId agent, const std::string& why) {
    EXPECT_THAT(interpreter.believe(agent, "p(1)").render(), HasSubstr(why));
    EXPECT_THAT(interpreter.forget(agent, "p(_)").render(), HasSubstr(why));
    EXPECT_THAT(interpreter.achieve(agent, "g").render(), HasSubstr(why));
    EXPECT_THAT(interpreter.include(agent, "more", "p(1).").render(), HasSubstr(why));
    const auto answers = interpreter.ask(agent, "p(X)");
    ASSERT_FALSE(answers);
    EXPECT_THAT(answers.diagnostics().render(), HasSubstr(why));
    EXPECT_FALSE(interpreter.mas().is_alive(agent));
    EXPECT_EQ(interpreter.mas().agent_name(agent), "");
    EXPECT_TRUE(interpreter.mas().describe_intentions(agent).empty());
    EXPECT_TRUE(interpreter.mas().describe_beliefs(agent).empty());
    std::string problem;
    EXPECT_FALSE(interpreter.mas().intervene(
        agent, [](Agent&) {}, problem));
    EXPECT_NE(problem, "");
  }

  std::vector<std::string> printed;
  Interpreter interpreter{{.max_cycles_per_tick = 2'000,
                           .max_cycles = 20'000,
                           .max_agents = 20,
                           .max_inferences = 5'000,
                           .print = [this](std::string_view line) { printed.emplace_back(line); }}};
};

TEST_F(Misuse, OfAnAgentThatHasKilledItself) {
  const AgentId ann = add("ann", "!g. +!g <- .my_name(N); .kill_agent(N); .print(never); !g.");
  interpreter.run();
  expect_refusals(ann, "the agent is gone");
  EXPECT_EQ(interpreter.run().end, RunEnd::idle);
}

TEST_F(Misuse, OfAnAgentThatAnotherHasKilled) {
  const AgentId ann = add("ann", "p(1). !w. +!w <- .wait(1000).");
  add("bob", "!g. +!g <- .kill_agent(ann); .send(ann,tell,p(2)). -!g[error(E)] <- .print(E).");
  interpreter.run();
  expect_refusals(ann, "the agent is gone");
  // The name is free again, the number is not.
  const AgentId other = add("ann", "p(3).");
  EXPECT_NE(other, ann);
  EXPECT_TRUE(interpreter.believe(other, "p(4)").empty());
  expect_refusals(ann, "the agent is gone");
}

TEST_F(Misuse, OfIdsThatWereNeverGiven) {
  expect_refusals(AgentId{0}, "there is no agent of that number");
  add("ann", "p(1).");
  expect_refusals(AgentId{1}, "there is no agent of that number");
  expect_refusals(AgentId{0xFFFFFFFFU}, "there is no agent of that number");
}

TEST_F(Misuse, OfTheInterpreterWhileItIsAtWork) {
  std::vector<std::string> refused;
  const AgentId ann = add("ann", "p(1). p(2).");
  const Diagnostics found = interpreter.ask(ann, "p(X)", [&](const Answer&) {
    refused.push_back(interpreter.believe(ann, "p(3)").render());
    refused.push_back(interpreter.include(ann, "more", "p(4).").render());
    EXPECT_FALSE(interpreter.step());
    (void)interpreter.run();
    EXPECT_FALSE(interpreter.ask(ann, "p(X)"));
    return true;
  });
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(refused.size(), 4U);
  for (const std::string& each : refused) EXPECT_THAT(each, HasSubstr("at work"));
  EXPECT_TRUE(interpreter.believe(ann, "p(3)").empty());
}

TEST_F(Misuse, OfAnAgentWithoutAProgram) {
  const AgentId ann = interpreter.add_agent("ann", nullptr);
  EXPECT_TRUE(interpreter.believe(ann, "p(1)").empty());
  EXPECT_TRUE(interpreter.ask(ann, "p(1)"));
}

constexpr std::array kTexts = {"p(1)",
                               "p(_)",
                               "p(X) & X > 0",
                               "",
                               "(",
                               "p(",
                               "\"",
                               "3",
                               "[a|b]",
                               "X",
                               "_",
                               "~p",
                               "n::p(1)",
                               "N::p(X)",
                               "{ +!g <- .kill_agent(self) }",
                               "p(1 div 0)",
                               "X = 1 div 0",
                               "X = f(X) & X = f(f(X))",
                               "not p(1)",
                               ".kill_agent(ann)",
                               ".stopMAS",
                               ".print(p)",
                               ".findall(X,p(X),L)",
                               "loop(1)",
                               "p({!g; ?q})",
                               "p(1)[source(X)]",
                               "self_kill",
                               "kill(ann)",
                               "kill(nobody)",
                               "create(zoe)",
                               "tell_all(p(2))",
                               "deep(500)",
                               "\xff\xfe",
                               "p(\xc3\xa4)",
                               "!g",
                               "+!g.",
                               "true",
                               "false",
                               "a.b(1)",
                               ".length([1],N)",
                               "end_all"};

constexpr std::string_view kProgram =
    "loop(X) :- loop(X). deep(0). deep(N) :- deep(N-1)."
    "+!self_kill <- .my_name(N); .kill_agent(N); !self_kill."
    "+!kill(A) <- .kill_agent(A)."
    "+!create(A) <- .create_agent(A, \"\"); .send(A, achieve, x)."
    "+!tell_all(B) <- .broadcast(tell, B); .wait(5); .suspend."
    "+!end_all <- .stopMAS. +!g <- .wait({+p(3)}). +!{ } <- x.";

class MisuseAtRandom : public testing::TestWithParam<unsigned> {};

TEST_P(MisuseAtRandom, EndsNothing) {
  Interpreter interpreter({.max_cycles_per_tick = 2'000,
                           .max_cycles = 20'000,
                           .max_agents = 20,
                           .max_inferences = 5'000});
  EXPECT_FALSE(interpreter.load_text("bad", std::string(kProgram)));  // its last plan is none
  const std::string good(kProgram.substr(0, kProgram.rfind("+!{")));
  const auto program = interpreter.load_text("any", good);
  ASSERT_TRUE(program) << program.diagnostics().render();
  for (int i = 0; i < 3; ++i) (void)interpreter.add_agent("ann", program.value());
  std::mt19937 random(GetParam());
  const auto one_of = [&](std::size_t count) { return random() % count; };
  const auto is_refused = [&](AgentId agent, const std::string& said) {
    switch (one_of(6)) {
      case 0:
        return !interpreter.believe(agent, said).empty();
      case 1:
        return !interpreter.forget(agent, said).empty();
      case 2:
        return !interpreter.ask(agent, said, 3);
      case 3:
        return !interpreter.include(agent, "more", said + ".").empty();
      default:
        return !interpreter.achieve(agent, said).empty();
    }
  };
  int dead = 0;
  for (int i = 0; i < 200; ++i) {
    const AgentId agent{static_cast<std::uint32_t>(one_of(10))};
    const std::string said = kTexts[one_of(kTexts.size())];
    const bool is_alive = interpreter.mas().is_alive(agent);
    const bool refused = is_refused(agent, said);
    if (!is_alive) {
      ++dead;
      EXPECT_TRUE(refused) << said;
    }
    if (one_of(4) == 0) (void)interpreter.step();
    if (one_of(10) == 0) (void)interpreter.run();
    if (one_of(20) == 0) (void)interpreter.add_agent("ann", program.value());
  }
  EXPECT_GT(dead, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MisuseAtRandom, testing::Range(0U, 4U));

}  // namespace
}  // namespace jaywalk
