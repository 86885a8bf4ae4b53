// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/repl/repl_input.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace jaywalk {
namespace {

using Kind = ReplInput::Kind;

/// The input that a text is; kind `nothing` if it is none or several.
ReplInput read_input(const std::string& text) {
  const std::vector<ReplInput> inputs = read_inputs(text);
  EXPECT_LE(inputs.size(), 1U) << text;
  return inputs.empty() ? ReplInput{} : inputs.front();
}

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
       {"p(1).", "p :- q.", "+p : q.", "+p <- q.", "+!g.", "@l +p.", "^!g.", "+p. { +q. }",
        "{ begin namespace(n) } p. { end }", "p(", "+!g <- if (a) { b } ?c.",
        "+!g <- !h. { +!h <- ?a; b. }"}) {
    EXPECT_EQ(read_input(program).kind, Kind::program) << program;
    EXPECT_EQ(read_input(program).text, program);
  }
  EXPECT_EQ(read_input("p. q.").kind, Kind::program);
  EXPECT_EQ(read_input("p. q.").text, "p.\nq.");
}

TEST(ReplInput, ReadsEachClauseOfALineAsItWouldBeAlone) {
  const std::vector<ReplInput> inputs =
      read_inputs("+a(1). -b(2). ?- a(X), b. !g. p(1). q :- p(1). ?- q. +c <- x. !h.");
  std::vector<std::pair<Kind, std::string>> seen;
  for (const ReplInput& input : inputs) seen.emplace_back(input.kind, input.text);
  const std::vector<std::pair<Kind, std::string>> expected{{Kind::add, "a(1)"},
                                                           {Kind::remove, "b(2)"},
                                                           {Kind::query, "a(X), b"},
                                                           {Kind::goal, "g"},
                                                           {Kind::program, "p(1).\nq :- p(1)."},
                                                           {Kind::query, "q"},
                                                           {Kind::program, "+c <- x."},
                                                           {Kind::goal, "h"}};
  EXPECT_EQ(seen, expected);
}

TEST(ReplInput, ReadsClausesThatStandAroundBlocks) {
  const std::vector<ReplInput> inputs = read_inputs(
      "+a(1). { begin namespace(n) } p(1). { end } +b(2).\n+!g <- !h. { +!h <- x. } !g.");
  std::vector<Kind> kinds;
  for (const ReplInput& input : inputs) kinds.push_back(input.kind);
  EXPECT_EQ(kinds, (std::vector{Kind::add, Kind::program, Kind::add, Kind::program, Kind::goal}));
}

TEST(ReplInput, HasCommandsAmidOthersOnALineOfTheirOwn) {
  for (const auto& [line, word] :
       {std::pair{":quit", "quit"}, std::pair{" :help ", "help"}, std::pair{"help", "help"},
        std::pair{"quit", "quit"}, std::pair{"exit", "quit"}, std::pair{":beliefs", "beliefs"}}) {
    const auto command = command_alone(line);
    ASSERT_TRUE(command) << line;
    EXPECT_EQ(command->word, word);
  }
  for (const char* line :
       {": p(X)", ":beliefs p", "help.", "quit(1)", "beliefs", "", ":", ":halp"}) {
    EXPECT_FALSE(command_alone(line)) << line;
  }
}

}  // namespace
}  // namespace jaywalk
