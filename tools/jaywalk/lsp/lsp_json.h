#pragma once

// Parts of messages of the language server protocol. A message may be anything: what is not there,
// or is of another kind, is empty.

#include <string>

#include <nlohmann/json.hpp>

#include "tools/jaywalk/lsp/lsp_text.h"

namespace jaywalk::lsp {

[[nodiscard]] const nlohmann::json& part(const nlohmann::json& json, const char* name);
[[nodiscard]] std::string text_of(const nlohmann::json& json);
[[nodiscard]] Position position_of(const nlohmann::json& json);
/// The URI of the document that a message is about.
[[nodiscard]] std::string document_uri(const nlohmann::json& parameters);

[[nodiscard]] nlohmann::json to_json(Position position);
[[nodiscard]] nlohmann::json to_json(const Range& range);

}  // namespace jaywalk::lsp
