// SPDX-License-Identifier: Apache-2.0
// Agents of one program share what it begins with, until one of them changes something.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/agent.h"
#include "tests/unit/mas/system.h"

namespace jaywalk {
namespace {

using test::System;
using ::testing::ElementsAre;
using ::testing::SizeIs;

/// Agents `a` and `b` of one program, which have run.
class SharedBeliefs : public ::testing::Test {
 protected:
  void run(const std::string& program, const std::vector<Parameter>& given = {}) {
    system.add("a", program);
    mas = std::make_unique<Mas>(system.symbols, system.options, nullptr);
    AgentSpec spec = system.agents.front();
    spec.parameters = given;
    a = mas->add_agent(spec);
    spec.parameters.clear();
    spec.name = "b";
    b = mas->add_agent(spec);
    mas->run();
  }
  [[nodiscard]] bool shares(AgentId agent, std::string_view functor, std::uint16_t arity) const {
    return mas->agent(agent).beliefs().find(system.symbols->predicate(functor, arity))->is_shared();
  }

  System system;
  std::unique_ptr<Mas> mas;
  AgentId a{};
  AgentId b{};
};

TEST_F(SharedBeliefs, StayThoseOfTheOthersWhenOneChangesThem) {
  run("edge(1,2). edge(2,3). far(X) :- edge(X,_) & X > 5."
      "!go. +!go : .my_name(a) <- -edge(1,2); +edge(9,9); ?far(F); .print(F)."
      "+!go <- .wait(10); .findall(X, far(X), L); .print(L).");
  EXPECT_THAT(system.printed, ElementsAre("[a] 9", "[b] []"));
  EXPECT_FALSE(shares(a, "edge", 2));
  EXPECT_TRUE(shares(b, "edge", 2));
  EXPECT_TRUE(shares(a, "far", 1));
  EXPECT_THAT(mas->describe_beliefs(b),
              ElementsAre("edge(1,2)[source(self)]", "edge(2,3)[source(self)]"));
}

TEST_F(SharedBeliefs, AreNotThoseThatAPlanHearsOf) {
  run("edge(1,2). known(1). edge(2,3). !go. +!go. +edge(X,_) <- .print(X).");
  EXPECT_THAT(system.printed, ElementsAre("[a] 2", "[b] 2", "[a] 1", "[b] 1"));
  EXPECT_FALSE(shares(a, "edge", 2));
  EXPECT_TRUE(shares(a, "known", 1));
}

TEST_F(SharedBeliefs, GiveWayToThoseThatAnAgentIsGiven) {
  run("speed(2). place(1). !go. +!go : speed(V) & place(P) <- .print(V, P).",
      {{system.symbols->predicate("speed", 1), {Value::number(5)}}});
  EXPECT_THAT(system.printed, ElementsAre("[a] 51", "[b] 21"));
  EXPECT_FALSE(shares(a, "speed", 1));
  EXPECT_TRUE(shares(a, "place", 1));
}

TEST_F(SharedBeliefs, CountEqualOnesOnce) {
  run("p(1). p(1)[source(bob)]. p(1). !go. +!go <- .count(p(_), N); ?p(1)[source(bob)]; "
      ".print(N).");
  EXPECT_THAT(system.printed, ElementsAre("[a] 1", "[b] 1"));
}

TEST_F(SharedBeliefs, AreFoundByTheirArgumentsOnSeveralThreads) {
  std::string program;
  for (int i = 0; i < 100; ++i) program += "edge(" + std::to_string(i) + ",next). ";
  system.options.threads = 4;
  system.options.fewest_parallel = 2;
  run(program + "!go. +!go : edge(77,X) <- .print(X).");
  EXPECT_THAT(system.printed, SizeIs(2));
  EXPECT_TRUE(shares(a, "edge", 2) && shares(b, "edge", 2));
}

}  // namespace
}  // namespace jaywalk
