#include "tools/jaywalk/repl_input.h"

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using Kind = ReplInput::Kind;

TEST(ReplInput, EndsWithAFullStopOutsideOfBrackets) {
  EXPECT_TRUE(is_whole_input("p(1)."));
  EXPECT_FALSE(is_whole_input("p(1)"));
  EXPECT_FALSE(is_whole_input("?- p(X,"));
  EXPECT_FALSE(is_whole_input("+!g <- a; // a comment."));
  EXPECT_FALSE(is_whole_input("+!g <- !h. {"));
  EXPECT_FALSE(is_whole_input("+!g <- !h. { +!h <- a."));
  EXPECT_TRUE(is_whole_input("+!g <- !h. { +!h <- a. }"));
  EXPECT_FALSE(is_whole_input("/* a comment. *"));
  EXPECT_TRUE(is_whole_input("/* a comment */"));
  EXPECT_FALSE(is_whole_input("p(\"/*\""));
}

TEST(ReplInput, IsWholeAsSoonAsItIsWrong) {
  EXPECT_TRUE(is_whole_input("?- p(X,."));
  EXPECT_TRUE(is_whole_input("p) "));
  EXPECT_TRUE(is_whole_input("p(\"text"));
}

TEST(ReplInput, IsOneLineIfItIsACommand) {
  EXPECT_TRUE(is_whole_input(":load file"));
  EXPECT_TRUE(is_whole_input("  "));
  const ReplInput input = read_input("  :load  my file.asl \n");
  EXPECT_EQ(input.kind, Kind::command);
  EXPECT_EQ(input.word, "load");
  EXPECT_EQ(input.text, "my file.asl");
  EXPECT_EQ(read_input(":help").word, "help");
}

TEST(ReplInput, TellsKindsApartByParsing) {
  EXPECT_EQ(read_input("// nothing").kind, Kind::nothing);
  EXPECT_EQ(read_input("?- p(X) & q.").text, "p(X) & q");
  EXPECT_EQ(read_input("? p(X).").kind, Kind::query);
  EXPECT_EQ(read_input("+p(1)[a].").kind, Kind::add);
  EXPECT_EQ(read_input("+p(1)[a].").text, "p(1)[a]");
  EXPECT_EQ(read_input("-p(_).").kind, Kind::remove);
  EXPECT_EQ(read_input("!g(1).").kind, Kind::goal);
  for (const char* const program :
       {"p(1).", "p :- q.", "+p : q.", "+p <- q.", "+!g.", "@l +p.", "^!g.", "p. q.", "+p. { +q. }",
        "{ begin namespace(n) } p. { end }", "p(", "!a. !b."}) {
    EXPECT_EQ(read_input(program).kind, Kind::program) << program;
    EXPECT_EQ(read_input(program).text, program);
  }
}

}  // namespace
}  // namespace jaywalk
