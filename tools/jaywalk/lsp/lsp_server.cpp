// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/lsp/lsp_server.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "tools/jaywalk/lsp/lsp_answers.h"
#include "tools/jaywalk/lsp/lsp_protocol.h"

namespace jaywalk::lsp {
namespace {

// Codes of JSON-RPC and of the protocol.
constexpr int kParseError = -32700;
constexpr int kInvalidRequest = -32600;
constexpr int kMethodNotFound = -32601;
constexpr int kInvalidParameters = -32602;
constexpr int kNotInitialised = -32002;

Json capabilities() {
  return {{"capabilities",
           {{"textDocumentSync", {{"openClose", true}, {"change", 2}}},
            {"positionEncoding", "utf-16"},
            {"hoverProvider", true},
            {"completionProvider", {{"triggerCharacters", {".", "!", "{"}}}},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"documentFormattingProvider", true},
            {"workspace",
             {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}}}},
          {"serverInfo", {{"name", "jaywalk"}}}};
}

}  // namespace

void Server::send(const Json& message) {
  send_(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Server::respond(const Json& id, Json result) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Server::respond_error(const Json& id, int code, std::string_view message) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

void Server::receive_broken() {
  respond_error(nullptr, kParseError, "expected a header Content-Length and as much text");
}

void Server::receive(std::string_view message) {
  const Json json = Json::parse(message, nullptr, false);
  if (json.is_discarded()) {
    respond_error(nullptr, kParseError, "the message is not JSON");
    return;
  }
  const std::string method = text_of(part(json, "method"));
  const Json& id = part(json, "id");
  const bool is_request = id.is_string() || id.is_number();
  if (method.empty()) {
    // Answers to requests of ours would come here; there are none.
    const bool is_answer = json.is_object() && (json.contains("result") || json.contains("error"));
    if (!is_answer) respond_error(is_request ? id : Json(), kInvalidRequest, "no method is named");
  } else if (is_request) {
    request(id, method, part(json, "params"));
  } else {
    notification(method, part(json, "params"));
  }
}

void Server::request(const Json& id, const std::string& method, const Json& parameters) {
  if (method == "initialize") {
    initialised_ = true;
    add_folders(parameters);
    respond(id, capabilities());
  } else if (!initialised_) {
    respond_error(id, kNotInitialised, "the first request must be initialize");
  } else if (shut_down_) {
    respond_error(id, kInvalidRequest, "the server has been shut down");
  } else if (method == "shutdown") {
    shut_down_ = true;
    respond(id, nullptr);
  } else {
    std::string problem;
    Json answer = answer_of(method, parameters, problem);
    if (answer.is_discarded()) {
      respond_error(id, kMethodNotFound, fmt::format("there is no method '{}'", method));
    } else if (!problem.empty()) {
      respond_error(id, kInvalidParameters, problem);
    } else {
      respond(id, std::move(answer));
    }
  }
}

// A discarded value: there is no such method.
Json Server::answer_of(const std::string& method, const Json& parameters, std::string& problem) {
  constexpr std::string_view kAboutDocuments = "textDocument/";
  if (!method.starts_with(kAboutDocuments)) return Json(Json::value_t::discarded);
  const std::string what = method.substr(kAboutDocuments.size());
  // Questions are answered about the texts as they are now.
  settle();
  const auto found = documents_.find(document_uri(parameters));
  const Position at = position_of(part(parameters, "position"));
  const bool known = what == "hover" || what == "completion" || what == "definition" ||
                     what == "references" || what == "prepareRename" || what == "rename" ||
                     what == "documentSymbol" || what == "formatting";
  if (!known) return Json(Json::value_t::discarded);
  if (found == documents_.end()) {
    problem = "the document is not open";
    return nullptr;
  }
  const Document& document = *found->second.document;
  if (what == "hover") {
    const auto hover = document.hover(at);
    if (!hover) return nullptr;
    return {{"contents", {{"kind", "markdown"}, {"value", hover->first}}},
            {"range", lsp::to_json(hover->second)}};
  }
  if (what == "completion") return completion_items(document, at);
  if (what == "definition") return to_json(document.definitions(at));
  if (what == "references") return references(document, parameters);
  if (what == "prepareRename") {
    const auto place = document.renamable(at);
    return place ? lsp::to_json(place->range) : Json(nullptr);
  }
  if (what == "rename") {
    return renaming(document, at, text_of(part(parameters, "newName")), problem);
  }
  if (what == "documentSymbol") return symbols(document, document.components());
  return formatting(document);
}

// Uses the client's spelling of the URI if it has the file open.
Json Server::to_json(const Place& place) const {
  const std::string file = file_of(place.path, include_path_.files);
  std::string uri = uri_of_path(file);
  for (const auto& [opened, document] : documents_) {
    if (document.source->name() == file) uri = opened;
  }
  return {{"uri", std::move(uri)}, {"range", lsp::to_json(place.range)}};
}

Json Server::to_json(const std::vector<Place>& places) const {
  Json json = Json::array();
  for (const Place& place : places) json.push_back(to_json(place));
  return json;
}

IncludePath Server::with_open_texts() const {
  IncludePath include_path = include_path_;
  for (const std::string& folder : folders_) include_path.files.allow_reading(folder);
  for (const auto& [uri, opened] : documents_) {
    const std::string& file = opened.source->name();
    include_path.given.emplace_back(file, opened.source->text());
    const std::string installed = installed_name(file, include_path_.files);
    if (!installed.empty()) include_path.given.emplace_back(installed, opened.source->text());
  }
  return include_path;
}

Workspace Server::workspace(const Document& document) const {
  std::vector<std::string> open;
  for (const auto& [uri, opened] : documents_) {
    if (opened.document->is_program()) open.push_back(opened.source->name());
  }
  Folders folders{.whole = folders_, .alone = {}};
  // Without a workspace the file's own folder alone, not what is below it.
  if (folders_.empty()) {
    const std::string& path = document.source()->name();
    folders.alone.insert(path.substr(0, path.rfind('/') + 1));
  }
  return {folders, open, with_open_texts()};
}

Json Server::references(const Document& document, const Json& parameters) const {
  const Json& declarations = part(part(parameters, "context"), "includeDeclaration");
  const bool all = !declarations.is_boolean() || declarations.get<bool>();
  const Use* const use = document.use_there(position_of(part(parameters, "position")));
  if (use == nullptr) return Json::array();
  return to_json(workspace(document).uses(Name(*use), document.source()->name(),
                                          all ? Definitions::included : Definitions::left_out));
}

// Installed, and in none of the workspace's folders.
bool Server::is_foreign(const std::string& file) const {
  if (installed_name(file, include_path_.files).empty()) return false;
  return std::ranges::none_of(folders_, [&file](const std::string& folder) {
    return !folder.empty() && file.starts_with(folder.ends_with('/') ? folder : folder + '/');
  });
}

Json Server::renaming(const Document& document, Position at, const std::string& name,
                      std::string& problem) const {
  const Use* const use = document.use_there(at);
  if (!is_good_name(name)) {
    problem = fmt::format("'{}' cannot be the name of a goal or belief", name);
  } else if (use == nullptr || !document.renamable(at)) {
    problem = "there is no goal or belief to be renamed";
  } else if (document.is_of_environment(*use)) {
    problem = fmt::format("'{}' is a percept of the environment", use->name);
  }
  if (!problem.empty()) return nullptr;
  const Workspace workspace = this->workspace(document);
  const std::string& path = document.source()->name();
  if (name != use->name && workspace.is_taken(Name(*use), name, path)) {
    problem = fmt::format("there is a '{}' already", name);
    return nullptr;
  }
  Json changes = Json::object();
  for (const Place& place : workspace.uses(Name(*use), path, Definitions::included)) {
    if (is_foreign(place.path)) {
      problem = fmt::format("'{}' is also used in {}, which is installed", use->name, place.path);
      return nullptr;
    }
    const Json where = to_json(place);
    changes[where["uri"].get<std::string>()].push_back(
        {{"range", where["range"]}, {"newText", name}});
  }
  return {{"changes", std::move(changes)}};
}

void Server::add_folders(const Json& parameters) {
  const Json& folders = part(parameters, "workspaceFolders");
  if (folders.is_array()) {
    for (const Json& folder : folders) folders_.insert(path_of_uri(text_of(part(folder, "uri"))));
  } else if (const std::string root = text_of(part(parameters, "rootUri")); !root.empty()) {
    folders_.insert(path_of_uri(root));
  } else {
    folders_.insert(text_of(part(parameters, "rootPath")));
  }
  folders_.erase("");
}

void Server::change_folders(const Json& event) {
  for (const Json& folder : part(event, "removed")) {
    folders_.erase(path_of_uri(text_of(part(folder, "uri"))));
  }
  for (const Json& folder : part(event, "added")) {
    folders_.insert(path_of_uri(text_of(part(folder, "uri"))));
  }
  folders_.erase("");
}

void Server::notification(const std::string& method, const Json& parameters) {
  if (method == "exit") {
    exited_ = true;
  } else if (!initialised_ || shut_down_) {
    return;
  } else if (method == "textDocument/didOpen") {
    open(document_uri(parameters), text_of(part(part(parameters, "textDocument"), "text")));
  } else if (method == "textDocument/didChange") {
    change(parameters);
  } else if (method == "textDocument/didClose") {
    close(document_uri(parameters));
  } else if (method == "workspace/didChangeWorkspaceFolders") {
    change_folders(part(parameters, "event"));
  } else if (method == "workspace/didChangeWatchedFiles") {
    for (const Json& file : part(parameters, "changes")) {
      changed_.insert(path_of_uri(text_of(part(file, "uri"))));
    }
  }
}

void Server::open(const std::string& uri, std::string text) {
  if (uri.empty()) return;
  Opened& opened = documents_[uri];
  opened.source = std::make_shared<const Source>(path_of_uri(uri), std::move(text));
  changed_.insert(opened.source->name());
}

void Server::close(const std::string& uri) {
  const auto found = documents_.find(uri);
  if (found == documents_.end()) return;
  changed_.insert(found->second.source->name());
  documents_.erase(found);
  send({{"jsonrpc", "2.0"},
        {"method", "textDocument/publishDiagnostics"},
        {"params", {{"uri", uri}, {"diagnostics", Json::array()}}}});
}

void Server::change(const Json& parameters) {
  const std::string uri = document_uri(parameters);
  const auto found = documents_.find(uri);
  const Json& changes = part(parameters, "contentChanges");
  if (found == documents_.end() || !changes.is_array()) return;
  std::string text(found->second.source->text());
  // In their order: each is about the text that the one before left.
  for (const Json& each : changes) {
    const std::string changed = text_of(part(each, "text"));
    const Json& range = part(each, "range");
    if (!range.is_object()) {
      text = changed;
      continue;
    }
    const TextPlaces places(text);
    const std::uint32_t begin = places.offset(position_of(part(range, "start")));
    const std::uint32_t end = places.offset(position_of(part(range, "end")));
    if (begin > end) continue;
    text.replace(begin, end - begin, changed);
  }
  open(uri, std::move(text));
}

void Server::settle() {
  if (changed_.empty() || shut_down_) return;
  const std::set<std::string> changed = std::exchange(changed_, {});
  const IncludePath include_path = with_open_texts();
  for (auto& entry : documents_) {
    Opened& opened = entry.second;
    // A document that includes a changed file is checked again with it.
    const bool concerned =
        opened.document == nullptr || std::ranges::any_of(changed, [&](const std::string& path) {
          const std::string installed = installed_name(path, include_path.files);
          return path == opened.source->name() || opened.document->depends_on(path) ||
                 (!installed.empty() && opened.document->depends_on(installed));
        });
    if (!concerned) continue;
    opened.document = std::make_unique<Document>(entry.first, opened.source, include_path);
    publish(*opened.document);
  }
}

void Server::publish(const Document& document) {
  Json diagnostics = Json::array();
  for (const Diagnostic& diagnostic : document.diagnostics()) {
    diagnostics.push_back(json_of(diagnostic, document));
  }
  send({{"jsonrpc", "2.0"},
        {"method", "textDocument/publishDiagnostics"},
        {"params", {{"uri", document.uri()}, {"diagnostics", std::move(diagnostics)}}}});
}

}  // namespace jaywalk::lsp
