// Conversations of an editor with the language server.

#include "tools/jaywalk/lsp/lsp_server.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/jaywalk/lsp/lsp_frames.h"

namespace jaywalk::lsp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::UnorderedElementsAre;

constexpr const char* kUri = "file:///editor/a.asl";

/// An editor that has begun a conversation, unless it is told not to.
class Editor {
 public:
  Editor() { (void)request("initialize", Json::object()); }

  /// The answer to a request: with `result` or `error`.
  Json request(const std::string& method, Json parameters) {
    receive({{"id", ++id_}, {"method", method}, {"params", std::move(parameters)}});
    for (const Json& each : sent_) {
      if (each.contains("id") && each["id"] == id_) return each;
    }
    ADD_FAILURE() << method << " was not answered";
    return {};
  }
  Json result(const std::string& method, Json parameters) {
    const Json answer = request(method, std::move(parameters));
    EXPECT_TRUE(answer.contains("result")) << answer;
    return answer.value("result", Json());
  }
  void notify(const std::string& method, Json parameters) {
    receive({{"method", method}, {"params", std::move(parameters)}});
  }
  void open(const std::string& text, const std::string& uri = kUri) {
    notify("textDocument/didOpen", {{"textDocument", {{"uri", uri}, {"text", text}}}});
    server.settle();
  }
  /// What is asked about a place, both counted from 0.
  static Json place(int line, int character, const std::string& uri = kUri) {
    return {{"textDocument", {{"uri", uri}}},
            {"position", {{"line", line}, {"character", character}}}};
  }
  /// The markdown of a hover; empty if there is none.
  std::string hover(int line, int character) {
    const Json answer = result("textDocument/hover", place(line, character));
    return answer.is_null() ? "" : answer["contents"]["value"].get<std::string>();
  }
  std::vector<std::string> completions(int line, int character) {
    std::vector<std::string> labels;
    for (const Json& item : result("textDocument/completion", place(line, character))) {
      labels.push_back(item["label"]);
    }
    return labels;
  }
  /// The begins of places of the document, as `line:character`.
  static std::vector<std::string> begins(const Json& places) {
    std::vector<std::string> texts;
    for (const Json& each : places) {
      const Json& start = each["range"]["start"];
      texts.push_back(start["line"].dump() + ":" + start["character"].dump());
    }
    return texts;
  }
  /// The messages of the diagnostics that were published last for a document.
  [[nodiscard]] std::vector<std::string> published(const std::string& uri = kUri) const {
    std::vector<std::string> messages;
    for (const Json& each : sent_) {
      if (!each.contains("method") || each["params"]["uri"] != uri) continue;
      messages.clear();
      for (const Json& one : each["params"]["diagnostics"]) messages.push_back(one["message"]);
    }
    return messages;
  }
  [[nodiscard]] std::size_t published_times(const std::string& uri = kUri) const {
    std::size_t times = 0;
    for (const Json& each : sent_) {
      if (each.contains("method") && each["params"]["uri"] == uri) ++times;
    }
    return times;
  }
  [[nodiscard]] const std::vector<Json>& sent() const { return sent_; }

  void receive(Json message) {
    message["jsonrpc"] = "2.0";
    server.receive(message.dump());
  }

 private:
  std::vector<Json> sent_;
  int id_ = 0;

 public:
  Server server{IncludePath{},
                [this](std::string_view message) { sent_.push_back(Json::parse(message)); }};
};

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

std::vector<Frame> frames_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<Frame> frames;
  while (const auto frame = read_frame(in)) frames.push_back(*frame);
  return frames;
}

TEST(LspFrames, AreReadOneAfterAnother) {
  const auto frames = frames_of(
      "Content-Length: 2\r\n\r\n{}"
      "content-length:3\nContent-Type: x\n\n[1]");
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].content, "{}");
  EXPECT_EQ(frames[1].content, "[1]");
}

TEST(LspFrames, AreReadAgainAsTheyWereWritten) {
  std::ostringstream out;
  write_frame(out, "{\"é\": 1}");
  EXPECT_EQ(out.str(), "Content-Length: 9\r\n\r\n{\"é\": 1}") << "bytes are counted";
  EXPECT_EQ(frames_of(out.str()).at(0).content, "{\"é\": 1}");
}

TEST(LspFrames, WithoutALengthAreBroken) {
  for (const char* header : {"Content-Type: x", "Content-Length: -1", "Content-Length: 2x",
                             "Content-Length: 99999999999", "Content-Length:", "Length: 2"}) {
    const auto frames = frames_of(std::string(header) + "\r\n\r\nContent-Length: 2\r\n\r\n{}");
    ASSERT_EQ(frames.size(), 2U) << header;
    EXPECT_TRUE(frames[0].is_broken) << header;
    EXPECT_EQ(frames[1].content, "{}") << header;
  }
}

TEST(LspFrames, ThatEndTooSoonAreBroken) {
  const auto frames = frames_of("Content-Length: 10\r\n\r\n{}");
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_TRUE(frames[0].is_broken);
  EXPECT_EQ(frames[0].content, "");
  EXPECT_THAT(frames_of(""), IsEmpty());
  EXPECT_THAT(frames_of("\r\n\r\n"), IsEmpty());
}

}  // namespace
}  // namespace jaywalk::lsp
