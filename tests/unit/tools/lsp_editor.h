// SPDX-License-Identifier: Apache-2.0
#pragma once

// An editor as the tests of the language server have it: it asks and keeps what it is answered.

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tools/jaywalk/lsp/lsp_server.h"

namespace jaywalk::lsp {

inline constexpr const char* kUri = "file:///editor/a.asl";

/// An editor that has begun a conversation, unless constructed without one.
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
  /// The parameters of a request about a place, line and character counted from 0.
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

}  // namespace jaywalk::lsp
