// SPDX-License-Identifier: Apache-2.0
// Programs without end and without bound: each ends in a clear way, and harms nothing else.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

MasOptions small_limits() {
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_inferences = 100'000;
  options.max_agent_bytes = 8U << 20U;
  return options;
}

struct LimitRow {
  std::string name;
  std::string program;
};

/// The step fails, and its failure plan runs.
TEST(AgentLimits, FailTheStepThatHitsThem) {
  const std::vector<LimitRow> rows{
      {"rule that calls itself", "p :- p. !a. +!a <- ?p."},
      {"rule with a growing argument", "p(X) :- p(f(X)). !a. +!a <- ?p(0)."},
      {"rule with a growing sum", "p(X) :- p(X + 1). !a. +!a <- ?p(0)."},
      {"rule that branches", "p :- p | p. !a. +!a <- ?p."},
      {"rule that negates itself", "p :- not p. !a. +!a <- ?p."},
      {"query within a query", "p(L) :- .findall(X, p(X), L). !a. +!a <- ?p(_)."},
      {"context", "p :- p. !a. +!a <- !b. +!b : p."},
      {"list that doubles", "!a. +!a <- !d([1, 2]). +!d(L) <- .concat(L, L, M); !d(M)."},
      {"text that doubles", "!a. +!a <- !d(\"ab\"). +!d(S) <- .concat(S, S, T); !d(T)."},
      {"solutions without end", "n(0). n(X) :- n(Y) & X = Y + 1. !a. +!a <- .findall(X, n(X), L)."},
      {"for over solutions without end",
       "n(0). n(X) :- n(Y) & X = Y + 1. !a. +!a <- for (n(X)) { .print(X) }."},
      {"list that ends in itself, its length", "!a. +!a <- X = [1|X]; .length(X, N)."},
      {"two of them", "!a. +!a <- X = [1|X]; Y = [1, 1|Y]; X = Y; .print(never)."},
      {"comparison of two of them", "!a. +!a <- X = f(X); Y = f(Y); X == Y."},
      {"belief that contains itself", "!a. +!a <- X = f(X); +b(X)."},
      {"message that contains itself", "!a. +!a <- X = f(X); .send(agent, tell, b(X))."},
  };
  for (const LimitRow& row : rows) {
    const test::AgentRun run =
        test::run_agents({{"agent", row.program + " -!a <- .print(\"failed\"). !other. "
                                                  "+!other <- .wait(1); .print(\"other\")."}},
                         small_limits());
    EXPECT_EQ(run.errors.size(), 0U) << row.name;
    EXPECT_THAT(run.printed_by("agent"), Contains("failed")) << row.name;
    EXPECT_THAT(run.printed_by("agent"), Contains("other")) << row.name;
  }
}

/// The run ends at its limit of cycles, in the memory allowed.
TEST(AgentLimits, EndRunsWithoutEnd) {
  const std::vector<LimitRow> rows{
      {"goal that calls itself last", "!a. +!a <- !a."},
      {"new focus for ever", "!a. +!a <- !!a."},
      {"loop", "!a. +!a <- while (true) { +b; -b }."},
      {"empty loop", "!a. +!a <- while (true) { }."},
      {"messages to oneself", "!a. +!a <- .send(agent, achieve, a)."},
      {"belief that adds itself", "!a. +!a <- -+n(0). +n(X) <- -+n(X + 1)."},
      {"goal that fails for ever", "!a. +!a <- .fail. -!a <- !a."},
      {"goal without plan that fails for ever", "!a. -!a <- !a."},
      {"plans without end", "!a. +!a <- .add_plan({ +!b(1) <- .print(1) }); !a."},
      {"events without end", "!a. +!a <- ++b; --b; !!a. +b. -b."},
  };
  for (const LimitRow& row : rows) {
    const test::AgentRun run = test::run_agents({{"agent", row.program}}, small_limits());
    EXPECT_EQ(run.errors.size(), 0U) << row.name;
    EXPECT_TRUE(run.outcome.end == RunEnd::limit || run.outcome.end == RunEnd::idle) << row.name;
    EXPECT_LE(run.outcome.cycles, 20'000U) << row.name;
  }
}

TEST(AgentLimits, SayWhichAgentReachedThem) {
  const test::AgentRun run = test::run_agents({{"runner", "!a. +!a <- !a."}}, small_limits());
  EXPECT_EQ(run.outcome.end, RunEnd::limit);
  EXPECT_THAT(run.outcome.message, HasSubstr("runner"));
}

TEST(AgentLimits, SayWhatAnAgentDoesThatNeverWaits) {
  MasOptions options = small_limits();
  options.max_cycles_per_tick = 1000;
  const test::AgentRun run = test::run_agents({{"runner", "!a. +!a <- !a."}}, options);
  EXPECT_EQ(run.outcome.end, RunEnd::looping);
  EXPECT_THAT(run.outcome.message, HasSubstr("runner"));
  EXPECT_THAT(run.outcome.message, HasSubstr("last in"));
}

TEST(AgentLimits, LeaveTheAgentAbleToGoOn) {
  const std::vector<std::string> printed = test::printed_by(R"(
      p(X) :- p(f(X)).
      !a(3).
      +!a(0) <- .print("end").
      +!a(N) <- ?p(0).
      -!a(N) <- .print(N); !a(N - 1).
      )",
                                                            small_limits());
  EXPECT_THAT(printed, ElementsAre("3", "2", "1", "end"));
}

TEST(AgentLimits, LetTermsBeLargeButNotDeep) {
  const std::vector<std::string> printed = test::printed_by(R"(
      !a.
      +!a <- .findall(X, .range(X, 1, 100000), L); .length(L, N); .print(N); !deep(20000, z).
      +!deep(0, T) <- .print("deep"); .print(T).
      +!deep(N, T) <- !deep(N - 1, f(T)).
      -!deep(_, _) <- .print("too deep").
      )",
                                                            {.max_cycles = 100'000});
  EXPECT_THAT(printed, Contains("100000"));
  EXPECT_THAT(printed, Contains("too deep"));
}

/// A term of n steps that is 2^n large if nothing in it is shared.
TEST(AgentLimits, HoldForTermsThatShareTheirParts) {
  for (const char* const use :
       {".print(T)", "+b(T)", "T == U", "T = U", "T < U", ".term2string(T, S)", ".length([T], N)",
        ".send(agent, tell, b(T))", ".concat(\"\", T, S)", "!!c(T)"}) {
    const test::AgentRun run = test::run_agents(
        {{"agent", std::string("!a. +!a <- !grow(60, z, T); !grow(60, z, U); ") + use +
                       ". -!a <- .print(\"failed\"). +!grow(0, X, X). "
                       "+!grow(N, X, Y) <- !grow(N - 1, f(X, X), Y). +!c(_)."}},
        small_limits());
    EXPECT_EQ(run.errors.size(), 0U) << use;
  }
}

/// Numbers of 16 bits do not wrap around at 65,536.
TEST(AgentLimits, HoldForTheWidthOfTermsAndClauses) {
  const auto repeated = [](const std::string& text, int times, const std::string& between) {
    std::string all = text;
    for (int i = 1; i < times; ++i) all += between + text;
    return all;
  };
  const auto error = [](const std::string& program) {
    const test::AgentRun run = test::run_agents({{"agent", program}}, small_limits());
    return run.errors.empty() ? std::string() : run.errors.front();
  };
  const std::string body = "!a.\n+!a <- ";
  EXPECT_EQ(error(body + "X = f(" + repeated("1", 65'535, ",") + ")."), "");
  EXPECT_EQ(error(body + "X = f(" + repeated("1", 65'536, ",") + ")."),
            "2:12: more than 65535 arguments");
  EXPECT_EQ(error("b(" + repeated("1", 70'000, ",") + ")."), "1:1: more than 65535 arguments");
  EXPECT_EQ(error(body + repeated("X=1", 65'535, ";") + "."), "");
  EXPECT_EQ(error(body + repeated("a", 65'536, ";") + "."),
            "2:131078: more than 65535 formulas in a body");
  EXPECT_EQ(error(body + "X = { " + repeated("a", 40'000, ";") + " }; Y = { " +
                  repeated("a", 40'000, ";") + " }."),
            "");
  EXPECT_THAT(
      error(body + "(" + repeated("a", 40'000, ";") + "); (" + repeated("a", 40'000, ";") + ")."),
      HasSubstr("more than 65535 formulas"));
  const auto variables = [](int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += (i == 0 ? "X" : ",X") + std::to_string(i);
    return all;
  };
  EXPECT_EQ(error(body + "Y = [" + variables(65'000) + "]."), "");
  EXPECT_EQ(error(body + "Y = [" + variables(65'536) + "]."), "2:1: more than 65535 variables");
  EXPECT_EQ(error("b :- Y = [" + variables(65'536) + "]."), "1:1: more than 65535 variables");
  EXPECT_THAT(test::printed_by("!a. +!a <- .findall(1, .range(_, 1, 65536), L); X =.. [f, L, []]; "
                               ".print(never). -!a[error(E)] <- .print(E).",
                               small_limits()),
              ElementsAre("limit"));
}

TEST(AgentLimits, LetALongSortAndALongMatchBeInterrupted) {
  for (const char* const program :
       {"!a. +!a <- .findall(X, .range(X, 1, 3), L); !b(L). "
        "+!b(L) <- .concat(L, L, M); .sort(M, S); !b(M).",
        "!a. +!a <- !b(\"aaaaaaaaaaaaaaaaaaaa\"). +!b(S) <- .concat(S, S, T); "
        ".replace(T, \"(a*)*(a*)*b\", \"\", R); !b(T)."}) {
    int asked = 0;
    MasOptions options;
    options.interrupted = [&asked] { return ++asked > 2000; };
    EXPECT_EQ(test::run_agents({{"agent", program}}, options).outcome.end, RunEnd::interrupted)
        << program;
  }
}

}  // namespace
}  // namespace jaywalk
