// SPDX-License-Identifier: Apache-2.0
// .print .println .printf .puts .log .print_unifier

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/helpers/run_agents.h"
#include "tests/unit/actions/bodies.h"

namespace jaywalk::test {
namespace {

TEST(OutputActions, PrintTermsOneAfterAnother) {
  expect_lines({
      {".print(a, 1, \"b\", [c,\"d\"], X, f(X))", {"a1b[c,\"d\"]X<no-value>f(X)"}},
      {".print; .println(\"line \", x)", {"", "line x"}},
      {".print(1 < 2, 1 + 2)", {"(1 < 2)3"}},
  });
}

TEST(OutputActions, FormatAsJava) {
  expect_lines({
      {".printf(\"%5.2f|%s|%08.0f\", 3.14159, text, 42)", {" 3.14|text|00000042"}},
      {".printf(\"%s %s %s\", 1, [1,a], \"s\")", {"1.0 [1, a] s"}},
      {".printf(\"%d\", 1)", {"failed: unknown"}},
      {".printf(\"%s\")", {"failed: unknown"}},
      {".printf(a)", {"failed: unknown"}},
  });
}

TEST(OutputActions, FillInVariables) {
  expect_lines({
      {"X = 4; .puts(\"X is #{X}, twice #{X*2}\")", {"X is 4, twice #{X*2}"}},
      {"X = \"t\"; .puts(\"<#{X}>\", S); .length(S, N); .print(N, S)", {"3<t>"}},
      {".puts(\"#{Y} #{a} #{} #\")", {"Y a #{} #"}},
      {".puts(a)", {"failed: wrong_arguments"}},
  });
}

TEST(OutputActions, LogByLevel) {
  const AgentRun run = run_agents({{"ann",
                                    "!a. +!a <- .log(info, x, 1); .log(severe, bad); "
                                    ".log(fine, small); .verbose(2)."}});
  EXPECT_THAT(run.printed, ::testing::ElementsAre("[ann] x1"));
  EXPECT_THAT(run.logged, ::testing::ElementsAre(::testing::HasSubstr("bad")));
  expect_lines({{".log(1, x)", {"failed: unknown"}}});
}

TEST(OutputActions, ShowTheUnifier) {
  expect_lines({{"X = 1; Y = f(Z, \"s\"); .print_unifier", {"X=1", "Y=f(Z,\"s\")", "done"}}});
}

}  // namespace
}  // namespace jaywalk::test
