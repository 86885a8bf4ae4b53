// SPDX-License-Identifier: Apache-2.0
// Conversations of an editor with the language server.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/tools/lsp_editor.h"

namespace jaywalk::lsp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(LspConversation, BeginsWithInitialize) {
  std::vector<Json> sent;
  Server server(IncludePath{}, [&](std::string_view text) { sent.push_back(Json::parse(text)); });
  server.receive(R"({"id": 1, "method": "textDocument/hover"})");
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0]["error"]["code"], -32002);
  server.receive(R"({"method": "textDocument/didOpen", "params": {"textDocument":
                     {"uri": "file:///a.asl", "text": "b("}}})");
  server.settle();
  EXPECT_EQ(sent.size(), 1U) << "what comes before is passed over";
}

TEST(LspConversation, NamesWhatTheServerCanDo) {
  Editor editor;
  const Json& can = editor.sent().at(0)["result"]["capabilities"];
  for (const char* what : {"hoverProvider", "definitionProvider", "referencesProvider",
                           "documentSymbolProvider", "documentFormattingProvider"}) {
    EXPECT_EQ(can[what], true) << what;
  }
  EXPECT_EQ(can["renameProvider"]["prepareProvider"], true);
  EXPECT_EQ(can["textDocumentSync"]["change"], 2) << "changes come in parts";
}

TEST(LspConversation, EndsWithShutdownAndExit) {
  Editor editor;
  EXPECT_TRUE(editor.result("shutdown", {}).is_null());
  EXPECT_TRUE(editor.server.was_shut_down());
  EXPECT_FALSE(editor.server.has_exited());
  EXPECT_EQ(editor.request("textDocument/hover", Editor::place(0, 0))["error"]["code"], -32600);
  editor.notify("exit", {});
  EXPECT_TRUE(editor.server.has_exited());
}

TEST(LspConversation, MayEndWithoutShutdown) {
  Editor editor;
  editor.notify("exit", {});
  EXPECT_TRUE(editor.server.has_exited());
  EXPECT_FALSE(editor.server.was_shut_down());
}

TEST(LspConversation, RefusesMethodsThatItDoesNotHave) {
  Editor editor;
  for (const char* method : {"workspace/symbol", "textDocument/foldingRange", "hover"}) {
    EXPECT_EQ(editor.request(method, {})["error"]["code"], -32601) << method;
  }
  editor.notify("$/cancelRequest", {{"id", 1}});
  EXPECT_EQ(editor.sent().size(), 4U) << "notifications that it does not know are passed over";
}

TEST(LspConversation, SaysWhatIsNoMessage) {
  Editor editor;
  const auto code_after = [&](std::string_view text) {
    editor.server.receive(text);
    return editor.sent().back()["error"]["code"].get<int>();
  };
  EXPECT_EQ(code_after("{"), -32700);
  EXPECT_EQ(code_after(""), -32700);
  EXPECT_EQ(code_after("[]"), -32600);
  EXPECT_EQ(code_after("17"), -32600);
  EXPECT_EQ(code_after(R"({"id": 4})"), -32600);
  editor.server.receive_broken();
  EXPECT_EQ(editor.sent().back()["error"]["code"], -32700);
}

TEST(LspConversation, PassesOverAnswersToQuestionsThatItDidNotAsk) {
  Editor editor;
  const std::size_t before = editor.sent().size();
  editor.server.receive(R"({"id": 4, "result": null})");
  editor.server.receive(R"({"id": 4, "error": {}})");
  EXPECT_EQ(editor.sent().size(), before);
}

TEST(LspConversation, TakesParametersOfAnyKind) {
  Editor editor;
  for (const Json& odd : {Json(), Json(1), Json("x"), Json::array({1, 2}),
                          Json{{"textDocument", 3}}, Json{{"textDocument", {{"uri", 3}}}},
                          Json{{"position", {{"line", -1}, {"character", 1e300}}}}}) {
    for (const char* method : {"textDocument/hover", "textDocument/rename"}) {
      EXPECT_TRUE(editor.request(method, odd).contains("error")) << odd;
    }
    for (const char* method :
         {"textDocument/didOpen", "textDocument/didChange", "textDocument/didClose",
          "workspace/didChangeWorkspaceFolders", "workspace/didChangeWatchedFiles"}) {
      editor.notify(method, odd);
    }
  }
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspDiagnostics, ArePublishedWithTheirPlacesWhenADocumentIsOpened) {
  Editor editor;
  editor.open("!go.\n+!go <- !wlak.\n+!walk.\n");
  const Json& diagnostics = editor.sent().back()["params"]["diagnostics"];
  ASSERT_FALSE(diagnostics.empty());
  EXPECT_EQ(diagnostics[0]["message"], "no plan for the goal 'wlak'\ndid you mean 'walk'?");
  EXPECT_EQ(diagnostics[0]["code"], "unknown-goal");
  EXPECT_EQ(diagnostics[0]["severity"], 2);
  EXPECT_EQ(diagnostics[0]["source"], "jaywalk");
  EXPECT_EQ(diagnostics[0]["range"], Json::parse(R"({"start": {"line": 1, "character": 9},
                                                     "end": {"line": 1, "character": 13}})"));
}

TEST(LspDiagnostics, OfErrorsAreGraver) {
  Editor editor;
  editor.open("b(1.\n");
  EXPECT_EQ(editor.sent().back()["params"]["diagnostics"][0]["severity"], 1);
}

TEST(LspDiagnostics, WaitUntilSomebodyAsksOrNothingWaits) {
  Editor editor;
  editor.notify("textDocument/didOpen", {{"textDocument", {{"uri", kUri}, {"text", "b("}}}});
  EXPECT_EQ(editor.published_times(), 0U);
  editor.server.settle();
  EXPECT_EQ(editor.published_times(), 1U);
  editor.server.settle();
  EXPECT_EQ(editor.published_times(), 1U) << "nothing has changed";
  editor.notify("textDocument/didOpen", {{"textDocument", {{"uri", kUri}, {"text", "b."}}}});
  (void)editor.hover(0, 0);
  EXPECT_EQ(editor.published_times(), 2U);
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspDiagnostics, AreTakenBackWhenADocumentIsClosed) {
  Editor editor;
  editor.open("b(");
  EXPECT_THAT(editor.published(), Not(IsEmpty()));
  editor.notify("textDocument/didClose", {{"textDocument", {{"uri", kUri}}}});
  EXPECT_THAT(editor.published(), IsEmpty());
  EXPECT_EQ(editor.request("textDocument/hover", Editor::place(0, 0))["error"]["message"],
            "the document is not open");
}

TEST(LspDiagnostics, AreOfProjectsToo) {
  Editor editor;
  const std::string project = "file:///editor/p.mas2j";
  editor.open("MAS p { agents: a }", project);
  EXPECT_THAT(editor.published(project), Not(IsEmpty()));
  editor.open("MAS p { agents: a; }", project);
  EXPECT_THAT(editor.published(project), IsEmpty());
}

TEST(LspDiagnostics, KnowTheOpenTextOfIncludedFiles) {
  Editor editor;
  editor.open("{ include(\"b.asl\") }\n!go.\n");
  EXPECT_THAT(editor.published(), ElementsAre(HasSubstr("cannot find 'b.asl'")));
  editor.open("+!go <- .print(1).\n", "file:///editor/b.asl");
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspDiagnostics, OfIncludedFilesStandAtTheBeginning) {
  Editor editor;
  editor.open("+!go <- .print(1.\n", "file:///editor/b.asl");
  editor.open("{ include(\"b.asl\") }\n!go. +!go.\n");
  EXPECT_THAT(editor.published(), testing::Contains(HasSubstr("/editor/b.asl: ")));
}

/// A change of a part of the document.
Json edit(int line, int from, int to, const std::string& text) {
  return {{"textDocument", {{"uri", kUri}}},
          {"contentChanges", Json::array({{{"range",
                                            {{"start", {{"line", line}, {"character", from}}},
                                             {"end", {{"line", line}, {"character", to}}}}},
                                           {"text", text}}})}};
}

TEST(LspChanges, ReplaceAPartOfTheText) {
  Editor editor;
  editor.open("!go.\n+!goo <- .print(1).\n");
  editor.notify("textDocument/didChange", edit(1, 2, 5, "go"));
  editor.server.settle();
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspChanges, CountUnitsOfUtf16) {
  Editor editor;
  editor.open("b(\"🚶é\"). b(.\n");
  // The walker is two units, the é one: the wrong bracket is at unit 11.
  editor.notify("textDocument/didChange", edit(0, 10, 12, "c"));
  editor.server.settle();
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspChanges, MayReplaceEverything) {
  Editor editor;
  editor.open("b(");
  editor.notify("textDocument/didChange", {{"textDocument", {{"uri", kUri}}},
                                           {"contentChanges", Json::array({{{"text", "b(1)."}}})}});
  editor.server.settle();
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspChanges, ComeInTheirOrder) {
  Editor editor;
  editor.open("abc.\n");
  Json changes = edit(0, 0, 1, "x");
  changes["contentChanges"].push_back(edit(0, 1, 3, "(1)")["contentChanges"][0]);
  editor.notify("textDocument/didChange", changes);
  const Json symbols = editor.result("textDocument/documentSymbol", Editor::place(0, 0));
  EXPECT_EQ(symbols[0]["name"], "x(1)");
}

TEST(LspChanges, BeyondTheEndAreAtTheEnd) {
  Editor editor;
  editor.open("b");
  editor.notify("textDocument/didChange", edit(99, 7, 99, "."));
  editor.server.settle();
  EXPECT_THAT(editor.published(), IsEmpty());
}

TEST(LspChanges, ThatEndBeforeTheyBeginArePassedOver) {
  Editor editor;
  editor.open("b.");
  editor.notify("textDocument/didChange", edit(0, 2, 1, "((("));
  editor.server.settle();
  EXPECT_THAT(editor.published(), IsEmpty());
}

}  // namespace
}  // namespace jaywalk::lsp
