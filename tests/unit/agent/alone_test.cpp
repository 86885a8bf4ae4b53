// SPDX-License-Identifier: Apache-2.0
// An intention that is alone goes on into the next cycle, and its event does not pass through E
// (agent/cycle/cycle.cpp): the cycles are the same. Where each step is one cycle, nothing goes on,
// so each program runs in such steps, too, and once with an observer.

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "interpreter/agent/surroundings/observer.h"
#include "tests/helpers/run_agents.h"

namespace jaywalk {
namespace {

using ::testing::ElementsAreArray;

struct ProgramRow {
  std::string name;
  std::string program;
};

MasOptions limited() {
  MasOptions options;
  options.max_cycles = 20'000;
  options.max_agent_bytes = 8U << 20U;
  options.max_inferences = 100'000;
  return options;
}

test::AgentRun run(const std::string& program, int agents, MasOptions options,
                   test::Steps steps = test::Steps::many) {
  std::vector<test::NamedProgram> all;
  for (int i = 0; i < agents; ++i) all.push_back({"a" + std::to_string(i), program});
  return test::run_agents(all, std::move(options), {}, steps);
}

void expect_same(const test::AgentRun& run, const test::AgentRun& usual, const std::string& name) {
  EXPECT_THAT(run.printed, ElementsAreArray(usual.printed)) << name;
  EXPECT_THAT(run.logged, ElementsAreArray(usual.logged)) << name;
  EXPECT_EQ(run.outcome.cycles, usual.outcome.cycles) << name;
  EXPECT_EQ(run.outcome.end, usual.outcome.end) << name;
  EXPECT_EQ(run.outcome.message, usual.outcome.message) << name;
}

void expect_the_same(const ProgramRow& row, int agents) {
  const test::AgentRun usual = run(row.program, agents, limited());
  EXPECT_THAT(usual.errors, ::testing::IsEmpty()) << row.name;
  ReasoningObserver nobody;
  MasOptions observed = limited();
  observed.observer = &nobody;
  expect_same(run(row.program, agents, observed), usual, row.name + ", observed");
  expect_same(run(row.program, agents, limited(), test::Steps::one), usual,
              row.name + ", cycle by cycle");
}

const std::vector<ProgramRow> kRows{
    {"tail recursion", "!c(50). +!c(0) <- .print(done). +!c(N) : N > 0 <- !c(N-1)."},
    {"sub-goals with results",
     "!s. +!s <- !fib(9, F); .print(F). +!fib(0, 1). +!fib(1, 1)."
     "+!fib(N, F) : N > 1 <- !fib(N-1, A); !fib(N-2, B); F = A+B."},
    {"a result that stays open", "!s. +!s <- !g(X, Y); .print(X, Y). +!g(A, A)."},
    {"a result in a structure", "!s. +!s <- !g(X); .print(X). +!g(f(A, 1, _))."},
    {"a constraint that fails before a division by zero",
     "!s(1). +!s(X) <- X = 2; .print(1 div 0). -!s(_) <- .print(failed)."},
    {"what has no name",
     "b(1). b(2). d(_, 7). r(X) :- b(X) & d(_, _)."
     "!s(2). +!s(0). +!s(N) : b(X) & d(P, _) & r(X) <- L = [_, P, _]; .print(L); !s(N-1)."},
    {"rules with functions and constants",
     "at(3, 8). dist(D) :- at(X, Y) & row(X, R) & D = math.abs(X - Y) + R. "
     "row(X, 1) :- X < 2. row(X, R) :- X > 5 & R = X - 5. row(X, 0) :- X >= 2 & X <= 5. "
     "!s(9). +!s(0). +!s(N) : dist(D) & D < N <- .print(far, N, D); !s(N-1). "
     "+!s(N) : dist(D) & not D == math.max(N, 2) <- .print(near, N, D); !s(N-1). "
     "+!s(N) : row(3, R) <- .print(at, N, R); !s(N-1)."},
    {"the same variable twice", "!s. +!s <- !g(X, X); .print(X). +!g(A, B) <- A = 3; .print(B)."},
    {"two variables that are one", "!s. +!s <- X = Y; !g(X, Y); .print(X, Y). +!g(1, B)."},
    {"a result of several levels",
     "!s. +!s <- !a(X); .print(X). +!a(X) <- !b(X). +!b(X) <- !c(X). +!c([1, 2])."},
    {"tail recursion with a result",
     "!s. +!s <- !l(3, X); .print(X). +!l(0, end)."
     "+!l(N, X) : N > 0 <- !l(N-1, X)."},
    {"beliefs that change",
     "b(0). !s. +!s : b(N) & N >= 5 <- .findall(X, c(X), L); .print(L)."
     "+!s : b(N) <- -+b(N+1); +c(N); !s. +c(3) <- .print(three); -c(1). -b(2) <- .print(two)."},
    {"beliefs of others and rules",
     "b(1)[source(x)]. b(2)[k]. r(3) :- true. !s."
     "+!s <- -+b(5); -+r(4); .findall(X, b(X), L); .findall(X, r(X), M); .print(L, M)."},
    {"atoms that come and go",
     "!s. +!s <- +a; -a; -+a; ?a; -a; not a; .print(x). -!s <- .print(f)."},
    {"contexts",
     "p(1). p(2). p(3). q(2, a). q(3, b). n(2). r(X) :- n(X). !s(1). !s(2). !s(3). !s(9)."
     "+!s(X) : p(X) & q(X, Y) & not r(X) <- .print(1, X, Y)."
     "+!s(X) : p(X) & q(X, Y) & Z = X * 2 + 1 & Z == 5 <- .print(2, X, Y, Z)."
     "+!s(X) : q(Y, Z) & Y > X & not Z = a <- .print(3, X, Y, Z)."
     "+!s(X) : p(Y) & r(Y) & .print(inside) <- .print(4, X, Y)."},
    {"contexts over many facts",
     "!s(0). +!s(30) : f(_, 7) & f(X, 7) & f(X, Y) & not f(Y, _) <- .print(X, Y). +!s(30)."
     "+!s(N) <- +f(N, N mod 8 + 100); +f(N, 7); !s(N+1)."},
    {"contexts with rules",
     "h(17). h(3). k(1). k(2). l(2, a). d(X, D) :- h(H) & D = H - X & D > 0 & D < 20. "
     "c(X, yes) :- X > 5. c(X, no) :- X <= 5. t(X, Y) :- d(X, Y) & k(X). o(_, Y). e(Z, Z). u(X) :- "
     "l(X, a). deep(0). deep(N) :- N > 0 & deep(N-1). same(X, X) :- k(X)."
     "!s(0). !s(1). !s(2). !s(16). !f."
     "+!s(X) : d(X, D) & D < 3 & k(K) & not K = X <- .print(1, X, D, K)."
     "+!s(X) : t(X, Y) & not u(X) & c(Y, A) <- .print(2, X, Y, A)."
     "+!s(X) : not t(X, _) & c(X, A) & deep(3) & e(B, B) <- .print(3, X, A, B)."
     "+!s(X) : d(X, Y) & k(Z) & Y - Z > 11 & same(Z, W) & o(1, O) <- .print(4, X, Y, Z, W, O)."
     "+!f : not (d(1, D) & D > 15 & k(2)) <- .print(no)."
     "+!f : d(A, 2) <- .print(A). +!f : d(1, Y) & deep(9) & .print(in, Y) & Y < 5 <- .print(Y)."},
    {"rules with errors in contexts",
     "h(a). h(2). d(X, D) :- h(H) & D = H + X. z(X) :- 1 div X > 0. !s. !t. !u."
     "+!s : d(1, D) & D > 2 <- .print(D). +!s <- .print(none)."
     "+!t : z(0). +!t <- .print(zero). +!u : d(1, D) & z(D) <- .print(D). +!u <- .print(u)."},
    {"a context that fails with an error", "a(x). !s. +!s : a(X) & 1 div 0 > 2. +!s <- .print(b)."},
    {"arithmetic on atoms", "a(x). !s. +!s : a(X) & X + 1 > 2 <- .print(a). +!s <- .print(b)."},
    {"failures", "!s. +!s <- !a; .print(s). -!s[error(E)] <- .print(E). +!a <- !b. +!b <- 1 > 2."},
    {"goals without plans",
     "!s. +!s <- !a. -!a[error(E)] <- .print(E); !c(1). -!c(X) <- .print(c, X)."},
    {"division by zero in a goal", "!s. +!s <- !a(1 div 0). +!a(_). -!s[error(E)] <- .print(E)."},
    {"tests",
     "b(1). !s. +!s <- ?b(X); ?t(X, Y); .print(X, Y); ?u. +?t(1, two). -!s[error(E)] <- "
     ".print(E)."},
    {"statements",
     "b(1). b(2). !s. +!s <- if (b(3)) { .print(no) } else { !g(X); if (X > 1) { +c(X) } };"
     "for (b(Y)) { !g(Z); .print(Y, Z) }; ?c(W); .print(W). +!g(2)."},
    {"intentions side by side",
     "!a(3). !b(3). +!a(0). +!a(N) <- +p(N); !a(N-1). +!b(0). +!b(N) <- .print(N); !b(N-1)."
     "+p(N) <- .print(p, N)."},
    {"new focus",
     "!s. +!s <- !!t(1); +a(1); ++a(2); !t(2). +!t(X) <- .print(t, X). +a(X) <- .print(a, X)."},
    {"atomic plans",
     "!a. !b. @x[atomic] +!a <- !c; .print(a). +!c <- +d; .print(c). +!b <- .print(b). +d <- "
     ".print(d)."},
    {"waiting",
     "!a. !b. +!a <- .wait(20); .print(a). +!b <- .wait(g(X)); .print(X). +!c. !d. +!d <- !c; "
     "+g(1)."},
    {"intentions that are dropped",
     "!a. +!a <- !b; .print(a). +!b <- .drop_all_intentions; .print(b)."},
    {"plans that come at run time",
     "!s. +!s <- !g; .add_plan({ +!g <- .print(new) }, self, begin); !g. +!g <- .print(old)."},
    {"bodies as values",
     "!s. +!s <- !do({ .print(1); !g(X); .print(X) }). +!do(B) <- B; .print(e). +!g(7)."},
    {"names of variables",
     "!s. +!s <- !g(X, _); !g(_, Y); .print(X, Y, _). +!g(A, _) <- .print(A)."},
    {"negated literals",
     "~b(1). !s. +!s : ~b(X) <- -~b(X); !~g(X); .print(X). +!~g(1) <- .print(n). +~c. -~b(X) <- "
     ".print(m)."},
    {"a loop without end", "!s(0). +!s(N) <- !s(N+1)."},
    {"a term that grows without end", "!s(0). +!s(X) <- !s(f(X, X, X))."},
    {"a goal that nests without end", "!s. +!s <- !s; .print(x)."},
};

TEST(Alone, TakesTheSameCyclesAsOneByOne) {
  for (const ProgramRow& row : kRows) expect_the_same(row, 1);
}

TEST(Alone, TakesTheSameCyclesAmongOthers) {
  for (const ProgramRow& row : kRows) expect_the_same(row, 3);
}

TEST(Alone, LogsInTheSameOrderWhereAgentsKeepToThemselves) {
  const std::vector<ProgramRow> rows{
      {"failures", "!s(3). +!s(0) <- !t. +!s(N) <- !s(N-1); !u. -!s(2) <- !s(1). +!t <- 1 > 2."},
      {"busy agents", "b(0). !s. +!s : b(N) & N > 90 <- !t. +!s : b(N) <- -+b(N+1); !!u(N); !s."},
      {"agents that never end", "b(0). !s. +!s : b(N) <- -+b(N+1); !s."},
  };
  for (const ProgramRow& row : rows) expect_the_same(row, 5);
}

}  // namespace
}  // namespace jaywalk
