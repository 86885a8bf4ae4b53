// SPDX-License-Identifier: Apache-2.0
#include "interpreter/syntax/format/formatter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using testing::HasSubstr;

std::string formatted(std::string text) {
  const auto source = std::make_shared<const Source>("a.asl", std::move(text));
  auto result = format_agent(source);
  return result ? result.value() : result.diagnostics().render();
}

TEST(Formatter, PutsBlanksWhereTheyBelong) {
  EXPECT_EQ(formatted("p( 1,X ) [ a,b ]:-q(X)&not r|X>=-1&Y= [H |T]&~s&Z=(1+2 )*-3 ."),
            "p(1, X)[a, b] :- q(X) & not r | X >= -1 & Y = [H|T] & ~s & Z = (1 + 2) * -3.\n");
  EXPECT_EQ(formatted("! g ( 1 ) . { include ( \"x\" ) }\nn :: p ."),
            "!g(1).\n{ include(\"x\") }\nn::p.\n");
}

TEST(Formatter, LeavesOnOneLineWhatWasWrittenOnOne) {
  EXPECT_EQ(formatted("@ l [atomic] +! g(X):X>1<- a(X) ;+b ; -+c; !! d; ? e;if(f){g}else{h;i}."),
            "@l[atomic] +!g(X) : X > 1 <- a(X); +b; -+c; !!d; ?e; if (f) { g } else { h; i }.\n");
}

TEST(Formatter, LaysOutPlansOfSeveralLines) {
  EXPECT_EQ(formatted("@l +!g(X) : a &\n b <- c; if (d) { e;\n f } elif (g) { h } else { }; i."),
            "@l\n"
            "+!g(X) : a & b\n"
            "  <- c;\n"
            "     if (d) {\n"
            "       e;\n"
            "       f\n"
            "     } elif (g) {\n"
            "       h\n"
            "     } else {};\n"
            "     i.\n");
}

TEST(Formatter, KeepsTheLineBreaksThatStandForSemicolons) {
  EXPECT_EQ(formatted("+!g <- print(\"a\")\n extend;\n b."),
            "+!g\n"
            "  <- print(\"a\")\n"
            "     extend;\n"
            "     b.\n");
  EXPECT_EQ(formatted("+!g <- if (c) { a\n b }\n d."),
            "+!g\n"
            "  <- if (c) {\n"
            "       a\n"
            "       b\n"
            "     }\n"
            "     d.\n");
}

TEST(Formatter, KeepsColumnsThatNeighbouringLinesHave) {
  EXPECT_EQ(
      formatted(
          "+!a : b(X)     <- c.\n+!aa           <- d.   // one\n+!aaa :  bb    <- e.   // two\n"),
      "+!a : b(X) <- c.\n"
      "+!aa       <- d.  // one\n"
      "+!aaa : bb <- e.  // two\n");
}

TEST(Formatter, MakesNoColumnsWhereThereWereNone) {
  EXPECT_EQ(formatted("p(1) :- q.\np :- q(1).\n"), "p(1) :- q.\np :- q(1).\n");
  EXPECT_EQ(formatted("p(1) :- q.\n\np    :- q(1).\n"), "p(1) :- q.\n\np :- q(1).\n");
}

TEST(Formatter, BreaksLinesOutsideOfCallsFirst) {
  const std::string long_name(60, 'x');
  EXPECT_EQ(
      formatted("r :-\n " + long_name + " & .findall(option(A, B), some(A) & other(B), All)."),
      "r :-\n  " + long_name + " &\n  .findall(option(A, B), some(A) & other(B), All).\n");
}

TEST(Formatter, KeepsCommentsWhereTheyAre) {
  EXPECT_EQ(
      formatted("// first   \n\n\n\np.// p is\n  /* long\n one */\n+!g // goal\n<- a; // do a\n"
                "\n // then\nb /* now */ (c)\n. // end"),
      "// first\n"
      "\n"
      "p.  // p is\n"
      "/* long\n one */\n"
      "+!g  // goal\n"
      "  <- a;  // do a\n"
      "\n"
      "     // then\n"
      "     b /* now */ (c).  // end\n");
}

TEST(Formatter, KeepsCommentsInEmptyPlaces) {
  EXPECT_EQ(formatted("// alone"), "// alone\n");
  EXPECT_EQ(formatted(""), "");
  EXPECT_EQ(formatted(" \n\n"), "");
  EXPECT_EQ(formatted("+!g <- if (a) { // nothing\n }."),
            "+!g\n"
            "  <- if (a) {  // nothing\n"
            "     }.\n");
}

TEST(Formatter, IndentsBlocksAndSubPlans) {
  EXPECT_EQ(formatted("{begin namespace(n,local)}\np. // x\n // last\n{end}\n+!g <: q <- \na.\n"
                      "{ +!h.\n// inner\n-!h. }\nr."),
            "{ begin namespace(n, local) }\n"
            "  p.  // x\n"
            "  // last\n"
            "{ end }\n"
            "+!g\n"
            "  <: q\n"
            "  <- a.\n"
            "{\n"
            "  +!h.\n"
            "  // inner\n"
            "  -!h.\n"
            "}\n"
            "r.\n");
}

TEST(Formatter, WrapsLongLines) {
  const std::string name(30, 'x');
  const std::string text =
      formatted("+!g : " + name + " & " + name + " & " + name + " & " + name + " <- .print(" +
                name + "," + name + "," + name + "," + name + ").");
  const std::string two = name + " & " + name;
  EXPECT_EQ(text, "+!g\n  : " + two + " &\n    " + two + "\n  <- .print(" + name + ", " + name +
                      ",\n       " + name + ", " + name + ").\n");
}

TEST(Formatter, SaysWhatIsWrong) {
  EXPECT_THAT(formatted("p(1.\nq."), HasSubstr("a.asl:1:4: error: "));
}

}  // namespace
}  // namespace jaywalk
