// SPDX-License-Identifier: Apache-2.0
#pragma once

// The language server: requests and notifications in, answers and diagnostics out, as JSON texts.
// Edits are applied at once but checked later, when a request needs it or no more messages wait to
// be read, so that a queue of edits is checked once.

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tools/jaywalk/lsp/lsp_document.h"
#include "tools/jaywalk/lsp/lsp_protocol.h"
#include "tools/jaywalk/lsp/lsp_workspace.h"

namespace jaywalk::lsp {

class Server {
 public:
  using Send = std::function<void(std::string_view message)>;

  Server(IncludePath include_path, Send send)
      : include_path_(std::move(include_path)), send_(std::move(send)) {}

  /// Handles one message; any text may be given.
  void receive(std::string_view message);
  /// A message that could not be read.
  void receive_broken();
  /// Checks changed documents; called when no message waits.
  void settle();

  [[nodiscard]] bool has_exited() const { return exited_; }
  /// `shutdown` came before `exit`.
  [[nodiscard]] bool was_shut_down() const { return shut_down_; }

 private:
  struct Opened {
    SourcePtr source;
    /// The checked document; outdated while its path is in `changed_`, null before its first check.
    std::unique_ptr<Document> document;
  };

  void notification(const std::string& method, const Json& parameters);
  void request(const Json& id, const std::string& method, const Json& parameters);
  [[nodiscard]] Json answer_of(const std::string& method, const Json& parameters,
                               std::string& problem);
  [[nodiscard]] Json references(const Document& document, const Json& parameters) const;
  [[nodiscard]] Json renaming(const Document& document, Position at, const std::string& name,
                              std::string& problem) const;
  [[nodiscard]] bool is_foreign(const std::string& file) const;
  [[nodiscard]] Workspace workspace(const Document& document) const;
  [[nodiscard]] IncludePath with_open_texts() const;
  [[nodiscard]] Json to_json(const Place& place) const;
  [[nodiscard]] Json to_json(const std::vector<Place>& places) const;
  void add_folders(const Json& parameters);
  void change_folders(const Json& event);
  void open(const std::string& uri, std::string text);
  void change(const Json& parameters);
  void close(const std::string& uri);
  void publish(const Document& document);
  void respond(const Json& id, Json result);
  void respond_error(const Json& id, int code, std::string_view message);
  void send(const Json& message);

  IncludePath include_path_;
  Send send_;
  std::map<std::string, Opened> documents_;  // by URI
  std::set<std::string> changed_;            // paths of documents that must be checked again
  std::set<std::string> folders_;            // of the workspace
  bool initialised_ = false;
  bool shut_down_ = false;
  bool exited_ = false;
};

}  // namespace jaywalk::lsp
