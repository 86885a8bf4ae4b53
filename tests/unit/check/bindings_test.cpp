// SPDX-License-Identifier: Apache-2.0
// Variables: those that occur once, and those that have no value where one is needed.

#include <gtest/gtest.h>

#include "tests/unit/check/warnings.h"

namespace jaywalk {
namespace {

TEST(CheckVariables, WarnsOfThoseThatOccurOnce) {
  for (const auto& [text, warnings] : {
           Row{"+!g(X) <- a.", "1:5 the variable 'X' occurs only here\n"},
           Row{"+b : c(X,Y) <- d(X).", "1:10 the variable 'Y' occurs only here\n"},
           Row{"p(X) :- q(X,Y).", "1:13 the variable 'Y' occurs only here\n"},
           Row{"+!g <- .findall(X, p(X,Y), L); a(L).", "1:24 the variable 'Y' occurs only here\n"},
           Row{"+b[source(S)] <- a.", "1:11 the variable 'S' occurs only here\n"},
           Row{"+!g(X) <- a(X). { +!h(Y) <- a. }", "1:23 the variable 'Y' occurs only here\n"},
       }) {
    EXPECT_EQ(warnings_of("singleton-variable", text), warnings) << text;
  }
}

TEST(CheckVariables, IsSilentAboutThoseThatOccurAgain) {
  for (const char* text : {
           "+!g(X) <- a(X).",
           "+!g(_X,_) <- a.",
           "+!g(_1) <- a.",
           "likes(X).",
           "+!g([H|T]) <- a(T,H).",
           "+!g(X) <- .puts(\"the #{X}\").",
           "+!g <- for (.range(I,1,3)) { a }.",
           "+!g(X) <- a. { +!h <- b(X). }",
           "+!G[source(self)] <- a.",
           "+b[k|Others] <- a(Others).",
           "+!g <- .create_agent(Bob,\"bob.asl\").",
           "+!g <- .add_plan({ +!h(X) <- a }).",
           "+!g(N) <- a(N::b).",
       }) {
    EXPECT_EQ(warnings_of("singleton-variable", text), "") << text;
  }
}

TEST(CheckVariables, WarnsOfArithmeticWithoutAValue) {
  for (const auto& [text, warnings] : {
           Row{"+!g <- Y = X + 1; a(Y); a(X).", "1:12 the variable 'X' has no value here\n"},
           Row{"+!g : X > 2 & b(X) <- a.", "1:7 the variable 'X' has no value here\n"},
           Row{"+!g : not b(X) & X > 2 <- a.", "1:18 the variable 'X' has no value here\n"},
           Row{"+!g <- !h(X+1); a(X).", "1:11 the variable 'X' has no value here\n"},
           Row{"+!g <- +b(-X); a(X).", "1:12 the variable 'X' has no value here\n"},
           Row{"+!g <- .print(X); a(X*2).", "1:21 the variable 'X' has no value here\n"},
           Row{"+!g <- .verbose(X); a(X*2).", "1:23 the variable 'X' has no value here\n"},
           Row{"+!g <- .kill_agent(X); a(X*2).", "1:26 the variable 'X' has no value here\n"},
           Row{"+!g <- .at(X,{+!g}); a(X*2).", "1:24 the variable 'X' has no value here\n"},
           Row{"+!g <- a(math.abs(X)); a(X).", "1:19 the variable 'X' has no value here\n"},
           Row{"+!g <- if (X == 3) { a(X) }.", "1:12 the variable 'X' has no value here\n"},
           Row{"+!g <- .findall(X, b(X), L); a(X+1,L).",
               "1:32 the variable 'X' has no value here\n"},
           Row{"+!g <- for (b(X)) { Y = X }; a(Y+1).", "1:32 the variable 'Y' has no value here\n"},
           Row{"+!g <- while (b(X)) { ?c(Y) }; a(X-Y).",
               "1:34 the variable 'X' has no value here\n1:36 the variable 'Y' has no value "
               "here\n"},
           Row{"+!g <- if (b) { a } else { X = 1 }; !!h(Z); a(Z/2,X).",
               "1:47 the variable 'Z' has no value here\n"},
           Row{"p(X) :- Y < X & q(Y).", "1:9 the variable 'Y' has no value here\n"},
           Row{"+!g : b(_) & _ > 3 <- a.", "1:14 the variable '_' has no value here\n"},
       }) {
    EXPECT_EQ(warnings_of("unbound-variable", text), warnings) << text;
  }
}

TEST(CheckVariables, IsSilentWhereAValueIsPossible) {
  for (const char* text : {
           "+!g(X) <- a(X+1).",
           "+!g : b(X) & X > 2 <- a.",
           "+!g : b & c(X) | d(X) & X > 2 <- a(X+1).",
           "+b[cost(C)] : C > 3 <- a.",
           "+!g <- ?b(X); a(X+1).",
           "+!g <- !h(X); a(X+1).",
           "+!g <- -b(X); a(X+1).",
           "+!g <- act(X); a(X+1).",
           "+!g <- .nth(0,[1],X); a(X+1).",
           "+!g <- X = Y; Y = 2; a(X+1).",
           "+!g <- f(X) = Z; a(X+Z).",
           "+!g <- P =.. [f,[X],[]]; a(X+P).",
           "+!g <- if (b(X)) { a(X+1) } else { a }; a(X+1).",
           "+!g <- if (b) { X = 1 } else { X = 2 }; a(X+1).",
           "+!g <- if (b) { a } elif (c(X)) { a }; a(X+1).",
           "+!g <- for (b(X)) { a(X+1) }.",
           "+!g <- while (b(X) & X < 3) { Y = X+1; -+b(Y) }.",
           "+!g <- X = 1 |&| Y = 2; a(X+Y).",
           "+!g <- .findall(X+1, b(X), L); .length(L,N); a(N+1).",
           "+!g <- .findall(p(X,Y), b(X) & Y = X+1, L); a(L).",
           "+!g <- .count(b(_), N); a(N+1).",
           "+!g <- .max(X, b(X), M); a(M+1).",
           "+!g <- .wait(b(X) & X > 3); a(X+1).",
           "+!g <- .wait({+b(X)}); a(X+1).",
           "+!g <- .send(bob, askOne, p(X), p(X)); a(X+1).",
           "+!g(B) <- B; a(X+1); b(X).",
           "+!g(X) <- a. { +!h <- a(X+1). }",
           "p(X,Y+1) :- q(X,Y).",
           "p(X,Y) :- Y = X+1.",
           "f(X+1).",
           "+!g <- .add_plan({ +!h <- Y = X+1 }).",
           "+!g(E) <- E = { a(X+1) }.",
           "+!g : .my_name(Me) & .length(Me,N) & N > 2 <- a.",
           "+!g(_1) : _1 > 2 <- a.",
           "+!g <: b(X) & X > 3 <- a.",
       }) {
    EXPECT_EQ(warnings_of("unbound-variable", text), "") << text;
  }
}

TEST(CheckVariables, TellsWhereAValueWasLost) {
  EXPECT_EQ(warnings_of("+!g <- for (b(X)) { a(X) }; a(X+1)."),
            "1: unbound-variable: the variable 'X' has no value here (what a loop gives a variable "
            "is lost after it)\n");
}

TEST(CheckVariables, TakesLongBodiesInLinearTime) {
  std::string text = "+!g(X) <- a";
  for (int i = 0; i < 20'000; ++i) text += "; if (b(Y" + std::to_string(i) + ")) { a }";
  EXPECT_EQ(warnings_of("unbound-variable", text + "."), "");
}

}  // namespace
}  // namespace jaywalk
