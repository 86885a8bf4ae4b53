// SPDX-License-Identifier: Apache-2.0
// The server's offers for a document: completions, outline, layout.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/lsp_editor.h"

namespace jaywalk::lsp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::UnorderedElementsAre;

TEST(LspCompletion, OffersGoalsBehindAnExclamationMark) {
  Editor editor;
  editor.open("seen(1).\n+!greet <- !g.\n+!go.\n+!wave.\n");
  EXPECT_THAT(editor.completions(1, 13), UnorderedElementsAre("go", "greet"));
  EXPECT_THAT(editor.completions(1, 12), UnorderedElementsAre("go", "greet", "wave"));
}

TEST(LspCompletion, OffersInternalActionsBehindAFullStop) {
  Editor editor;
  editor.open("+!go <- .subs; .pri.\n");
  EXPECT_THAT(editor.completions(0, 13), ElementsAre(".substring"));
  EXPECT_THAT(editor.completions(0, 19),
              ElementsAre(".print", ".print_unifier", ".printf", ".println"));
}

TEST(LspCompletion, OffersDirectivesBehindABrace) {
  Editor editor;
  editor.open("{ inc }\n");
  EXPECT_THAT(editor.completions(0, 5), ElementsAre("include"));
  EXPECT_THAT(editor.completions(0, 2), IsSupersetOf({"begin", "bdg", "namespace"}));
}

TEST(LspCompletion, OffersBeliefsAndWhatTheEnvironmentKnows) {
  Editor editor;
  editor.open("price(3).\n!cross.\n+!cross : pr <- move(forward); mov.\n");
  EXPECT_THAT(editor.completions(2, 12), testing::Contains("price"));
  EXPECT_THAT(editor.completions(2, 34), ElementsAre("move"));
}

TEST(LspCompletion, ReplacesWhatIsWritten) {
  Editor editor;
  editor.open("+!go <- .subs.\n");
  const Json items = editor.result("textDocument/completion", Editor::place(0, 13));
  EXPECT_EQ(items[0]["textEdit"]["newText"], ".substring");
  EXPECT_EQ(items[0]["textEdit"]["range"]["start"]["character"], 8);
  EXPECT_EQ(items[0]["textEdit"]["range"]["end"]["character"], 13);
}

TEST(LspSymbols, AreTheOutlineOfAProgram) {
  Editor editor;
  editor.open(
      "b(1).\n"
      "r(X) :- b(X).\n"
      "!go.\n"
      "{ begin namespace(n) }\n"
      "c.\n"
      "{ end }\n"
      "+!go : b(_) <- .print(1). { +!sub. }\n");
  const Json symbols = editor.result("textDocument/documentSymbol", Editor::place(0, 0));
  std::vector<std::string> names;
  for (const Json& each : symbols) names.push_back(each["name"]);
  EXPECT_THAT(names, ElementsAre("b(1)", "r(X)", "!go", "namespace(n)", "+!go"));
  EXPECT_EQ(symbols[3]["children"][0]["name"], "c");
  EXPECT_EQ(symbols[4]["detail"], "b(_)");
  EXPECT_EQ(symbols[4]["children"][0]["name"], "+!sub");
}

TEST(LspSymbols, LieWithinTheirRanges) {
  Editor editor;
  editor.open("@label +!go(X)\n  : b(X)\n  <- .print(X).\n");
  const Json plan = editor.result("textDocument/documentSymbol", Editor::place(0, 0))[0];
  EXPECT_EQ(plan["range"]["start"]["line"], 0);
  EXPECT_EQ(plan["range"]["end"]["line"], 2);
  EXPECT_EQ(plan["selectionRange"]["start"]["character"], 9);
}

TEST(LspFormatting, IsOneEditOrNone) {
  Editor editor;
  editor.open("b( 1 ).\n");
  const Json edits = editor.result("textDocument/formatting", Editor::place(0, 0));
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_THAT(edits[0]["newText"].get<std::string>(), HasSubstr("b(1)."));
  editor.open("b(1).\n");
  EXPECT_THAT(editor.result("textDocument/formatting", Editor::place(0, 0)), IsEmpty());
}

TEST(LspFormatting, LeavesProgramsWithMistakesAndProjectsAlone) {
  Editor editor;
  editor.open("b( 1 .\n");
  EXPECT_THAT(editor.result("textDocument/formatting", Editor::place(0, 0)), IsEmpty());
  const std::string project = "file:///editor/p.mas2j";
  editor.open("MAS   p { agents: a; }", project);
  EXPECT_THAT(editor.result("textDocument/formatting", Editor::place(0, 0, project)), IsEmpty());
}

}  // namespace
}  // namespace jaywalk::lsp
