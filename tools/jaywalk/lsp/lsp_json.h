#pragma once

// Parts of messages of the language server protocol. A message may be anything: missing parts, or
// parts of another type, are empty.

#include <string>

#include <nlohmann/json.hpp>

#include "tools/jaywalk/lsp/lsp_text.h"

namespace jaywalk::lsp {

using Json = nlohmann::json;

[[nodiscard]] const Json& part(const Json& json, const char* name);
[[nodiscard]] std::string text_of(const Json& json);
[[nodiscard]] Position position_of(const Json& json);
/// The URI of the document that a message is about.
[[nodiscard]] std::string document_uri(const Json& parameters);

[[nodiscard]] Json to_json(Position position);
[[nodiscard]] Json to_json(const Range& range);

}  // namespace jaywalk::lsp
