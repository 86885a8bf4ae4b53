#pragma once

// The language server: requests and notifications in, answers and diagnostics out, as JSON texts.

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "tools/jaywalk/lsp_document.h"

namespace jaywalk::lsp {

class Server {
 public:
  using Send = std::function<void(std::string_view message)>;

  Server(IncludePath include_path, Send send)
      : include_path_(std::move(include_path)), send_(std::move(send)) {}

  /// One message; no text can make it fail.
  void receive(std::string_view message);
  /// A message that could not be read.
  void receive_broken();

  [[nodiscard]] bool has_exited() const { return exited_; }
  /// `shutdown` came before `exit`.
  [[nodiscard]] bool was_shut_down() const { return shut_down_; }

 private:
  using Json = nlohmann::json;

  void notification(const std::string& method, const Json& parameters);
  void request(const Json& id, const std::string& method, const Json& parameters);
  [[nodiscard]] Json answer_of(const std::string& method, const Json& parameters,
                               std::string& problem);
  void open(const std::string& uri, std::string text);
  void change(const Json& parameters);
  void publish(const Document& document);
  void respond(const Json& id, Json result);
  void respond_error(const Json& id, int code, std::string_view message);
  void send(const Json& message);

  IncludePath include_path_;
  Send send_;
  std::map<std::string, Document> documents_;  // by URI
  bool initialised_ = false;
  bool shut_down_ = false;
  bool exited_ = false;
};

}  // namespace jaywalk::lsp
