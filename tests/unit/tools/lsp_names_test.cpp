// SPDX-License-Identifier: Apache-2.0
// The server's answers about names: hovers, definitions, references, renaming.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/lsp_editor.h"

namespace jaywalk::lsp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(LspHover, ShowsInternalActionsWithTheirArguments) {
  Editor editor;
  editor.open("!go.\n+!go <- .nth(0, [a], X); .print(X, math.abs(1)).\n");
  EXPECT_THAT(editor.hover(1, 9), HasSubstr(".nth(Index, List, Element)"));
  EXPECT_THAT(editor.hover(1, 37), HasSubstr("math.abs"));
}

TEST(LspHover, ShowsPlansOfAGoalWithTheCommentsAboveThem) {
  Editor editor;
  editor.open(
      "!greet.\n"
      "// Says hello,\n"
      "/// then goes.\n"
      "+!greet : near(X) <- .print(X).\n"
      "+!greet.\n"
      "+near(_).\n");
  EXPECT_EQ(editor.hover(0, 2),
            "```jason\n+!greet : near(X)\n```\nSays hello,\nthen goes.\n"
            "\n\n```jason\n+!greet\n```");
}

TEST(LspHover, ShowsTheCommentOfABelief) {
  Editor editor;
  editor.open("// In pounds.\nprice(3).\n!go.\n+!go : price(X) <- .print(X).\n");
  EXPECT_EQ(editor.hover(3, 8), "In pounds.\n");
  EXPECT_EQ(editor.hover(0, 4), "") << "a comment has no meaning";
}

TEST(LspHover, ShowsWordsOfTheEnvironment) {
  Editor editor;
  editor.open("!cross.\n+!cross : tick(_) <- move(forward); !cross.\n");
  EXPECT_THAT(editor.hover(1, 11), HasSubstr("`tick`: "));
  EXPECT_THAT(editor.hover(1, 22), HasSubstr("`move`: "));
}

TEST(LspHover, ShowsTheFormWithThatNumberOfArguments) {
  Editor editor;
  editor.open("!cross.\n+!cross : tick(_) <- move(forward); move(left, 1); move; !cross.\n");
  const std::string whole = editor.hover(1, 22);
  const std::string shorter = editor.hover(1, 37);
  EXPECT_THAT(whole, Not(HasSubstr("shorter")));
  EXPECT_THAT(shorter, HasSubstr("shorter"));
  EXPECT_EQ(editor.hover(1, 52), whole) << "no form of it: the first";
}

const std::string kGreeter =
    "price(3).\n"
    "!greet(1).\n"
    "+!greet(N) : price(X) & X > N <- .print(N); !greet(N + 1).\n"
    "+!greet(_) <- -price(3).\n";

TEST(LspDefinition, OfAGoalIsEachOfItsPlans) {
  Editor editor;
  editor.open(kGreeter);
  EXPECT_THAT(Editor::begins(editor.result("textDocument/definition", Editor::place(1, 3))),
              ElementsAre("2:2", "3:2"));
}

TEST(LspDefinition, OfABeliefIsWhereItIsWritten) {
  Editor editor;
  editor.open(kGreeter);
  EXPECT_THAT(Editor::begins(editor.result("textDocument/definition", Editor::place(2, 14))),
              ElementsAre("0:0"));
}

TEST(LspDefinition, OfABeliefThatIsNowhereWrittenIsThePlanThatReacts) {
  Editor editor;
  editor.open("+seen(X) <- .print(X).\n!go.\n+!go : seen(_).\n");
  EXPECT_THAT(Editor::begins(editor.result("textDocument/definition", Editor::place(2, 8))),
              ElementsAre("0:1"));
  EXPECT_THAT(editor.result("textDocument/definition", Editor::place(0, 13)), IsEmpty())
      << "an internal action";
}

TEST(LspReferences, AreAllPlacesOfAName) {
  Editor editor;
  editor.open(kGreeter);
  Json asked = Editor::place(0, 1);
  asked["context"] = {{"includeDeclaration", true}};
  EXPECT_THAT(Editor::begins(editor.result("textDocument/references", asked)),
              ElementsAre("0:0", "2:13", "3:15"));
  asked["context"] = {{"includeDeclaration", false}};
  EXPECT_THAT(Editor::begins(editor.result("textDocument/references", asked)),
              ElementsAre("2:13", "3:15"));
}

TEST(LspReferences, DoNotMixNumbersOfArguments) {
  Editor editor;
  editor.open("b(1). b(1,2).\n!go. +!go : b(_) <- ?b(_,_).\n");
  EXPECT_THAT(Editor::begins(editor.result("textDocument/references", Editor::place(0, 0))),
              ElementsAre("0:0", "1:12"));
}

Json rename_to(const std::string& name, int line, int character) {
  Json parameters = Editor::place(line, character);
  parameters["newName"] = name;
  return parameters;
}

TEST(LspRename, ChangesEveryPlaceOfAName) {
  Editor editor;
  editor.open(kGreeter);
  const Json answer = editor.result("textDocument/rename", rename_to("welcome", 1, 3));
  const Json& changes = answer["changes"][kUri];
  EXPECT_THAT(Editor::begins(changes), ElementsAre("1:1", "2:2", "2:45", "3:2"));
  for (const Json& each : changes) EXPECT_EQ(each["newText"], "welcome");
}

TEST(LspRename, ReachesIncludedFiles) {
  Editor editor;
  editor.open("+!go <- .print(1).\n", "file:///editor/b.asl");
  editor.open("{ include(\"b.asl\") }\n!go.\n");
  const Json answer = editor.result("textDocument/rename", rename_to("start", 1, 1));
  EXPECT_THAT(Editor::begins(answer["changes"][kUri]), ElementsAre("1:1"));
  EXPECT_THAT(Editor::begins(answer["changes"]["file:///editor/b.asl"]), ElementsAre("0:2"));
}

TEST(LspRename, RefusesNamesThatCannotBe) {
  Editor editor;
  editor.open(kGreeter);
  for (const char* name : {"Welcome", "", "two words", "a.b", "1st", "_x", "a(1)"}) {
    EXPECT_EQ(editor.request("textDocument/rename", rename_to(name, 1, 3))["error"]["message"],
              "'" + std::string(name) + "' cannot be the name of a goal or belief");
  }
}

TEST(LspRename, RefusesNamesThatMeanSomethingElseAlready) {
  Editor editor;
  editor.open("!go(1). +!go(X) <- !walk(X). +!walk(_).\n");
  EXPECT_EQ(editor.request("textDocument/rename", rename_to("walk", 0, 1))["error"]["message"],
            "there is a 'walk' already");
}

TEST(LspRename, LeavesWordsOfTheEnvironmentAndOfTheLanguageAlone) {
  Editor editor;
  editor.open("!cross.\n+!cross : tick(_) <- move(forward); .print(1); !cross.\n");
  EXPECT_EQ(editor.request("textDocument/rename", rename_to("place", 1, 11))["error"]["message"],
            "'tick' is a percept of the environment");
  EXPECT_EQ(editor.request("textDocument/rename", rename_to("go", 1, 36))["error"]["message"],
            "there is no goal or belief to be renamed");
}

TEST(LspRename, CanBeAskedForBefore) {
  Editor editor;
  editor.open(kGreeter);
  const Json range = editor.result("textDocument/prepareRename", Editor::place(1, 3));
  EXPECT_EQ(range["start"]["character"], 1);
  EXPECT_EQ(range["end"]["character"], 6);
  EXPECT_TRUE(editor.result("textDocument/prepareRename", Editor::place(2, 35)).is_null());
}

}  // namespace
}  // namespace jaywalk::lsp
