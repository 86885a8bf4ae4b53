#include "tools/jaywalk/lsp/lsp_json.h"

#include <cstdint>

namespace jaywalk::lsp {

namespace {

std::uint32_t number_of(const Json& json) {
  constexpr double kMost = 4e9;
  const double number = json.is_number() ? json.get<double>() : 0;
  return number > 0 && number < kMost ? static_cast<std::uint32_t>(number) : 0;
}

}  // namespace

const Json& part(const Json& json, const char* name) {
  static const Json kNothing;
  if (!json.is_object()) return kNothing;
  const auto found = json.find(name);
  return found == json.end() ? kNothing : *found;
}

std::string text_of(const Json& json) { return json.is_string() ? json.get<std::string>() : ""; }

Position position_of(const Json& json) {
  return {number_of(part(json, "line")), number_of(part(json, "character"))};
}

std::string document_uri(const Json& parameters) {
  return text_of(part(part(parameters, "textDocument"), "uri"));
}

Json to_json(Position position) { return {{"line", position.line}, {"character", position.unit}}; }

Json to_json(const Range& range) {
  return {{"start", to_json(range.begin)}, {"end", to_json(range.end)}};
}

}  // namespace jaywalk::lsp
