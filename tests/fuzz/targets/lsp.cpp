// SPDX-License-Identifier: Apache-2.0
// What editors send, in another order, with other values, and between frames that are none.

#include <algorithm>

#include "tests/fuzz/target.h"
#include "tests/fuzz/texts.h"

namespace jaywalk::fuzz::target::lsp {
namespace {

/// The lines of a session that are messages; others are comments.
Texts messages_of(const std::string& session) {
  Texts messages;
  for (std::size_t at = 0; at < session.size();) {
    const std::size_t end = std::min(session.find('\n', at), session.size());
    if (session[at] == '{') messages.push_back(session.substr(at, end - at));
    at = end + 1;
  }
  return messages;
}

Texts all_messages() {
  Texts messages = messages_of(project_text("tests/golden/cli/files/lsp_session.jsonl"));
  for (const std::string& session : corpus("lsp")) {
    for (std::string& message : messages_of(session)) messages.push_back(std::move(message));
  }
  return messages;
}

std::string frame(const std::string& content) {
  return "Content-Length: " + std::to_string(content.size()) + "\r\n\r\n" + content;
}

/// Bytes that are no message.
std::string garbage(Choices& choices) {
  switch (choices.below(10)) {
    case 0:
      return "\r\n\r\n";
    case 1:
      return "Content-Length: x\r\n\r\n";
    case 2:
      return "Content-Length: 99999999999999999999\r\n\r\n";
    case 3:
      return "Content-Length: -4\r\n\r\n";
    case 4:
      return "content-length:2\r\n\r\n{}";
    case 5:
      return frame(std::string(20'000, '['));
    case 6:
      return frame("\xFF\xFE");
    case 7:
      return frame("");
    case 8:
      return std::string(5000, 'X') + "\r\n\r\n";
    default:
      return test::mutate(choices, frame("null"), "Content-Type: x\r\n");
  }
}

/// An edit of an open document, at places that may not be there.
std::string edit(Choices& choices, const Texts& programs) {
  const auto number = [&] {
    return std::string(choices.one_of({"0", "1", "5", "40", "4294967295", "-1"}));
  };
  std::string text;
  for (const char c : one_of(choices, programs).substr(0, choices.below(200))) {
    if (c == '\n')
      text += "\\n";
    else if (c == '"' || c == '\\')
      text += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) >= ' ')
      text += c;
  }
  return R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":{"textDocument":{"uri":)"
         R"("file:///agents/example.asl","version":2},"contentChanges":[{"range":{"start":{"line":)" +
         number() + R"(,"character":)" + number() + R"(},"end":{"line":)" + number() +
         R"(,"character":)" + number() + R"(}},"text":")" + text + "\"}]}}";
}

}  // namespace

Case make(Choices& choices) {
  static const Texts kMessages = all_messages();
  static const Texts kPrograms = project_texts("agents/crossing", ".asl");
  Texts sent = kMessages;
  const std::size_t moves = choices.below(12);
  for (std::size_t i = 0; i < moves; ++i) {
    std::swap(sent[choices.below(sent.size())], sent[choices.below(sent.size())]);
  }
  Case made;
  for (const std::string& message : sent) {
    if (choices.once_in(10)) continue;
    if (choices.once_in(12)) made.input += garbage(choices);
    if (choices.once_in(8)) made.input += frame(edit(choices, kPrograms));
    made.input += frame(choices.once_in(3) ? spoil_json(choices, message) : message);
  }
  if (choices.once_in(4)) made.input = test::mutate(choices, made.input, "{\"id\":1}");
  made.commands = {{"lsp"}};
  return made;
}

}  // namespace jaywalk::fuzz::target::lsp
