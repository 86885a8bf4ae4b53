// SPDX-License-Identifier: Apache-2.0
#include "experiment/judge/csv_line.h"

#include <fmt/format.h>

namespace jaywalk {
namespace {

std::string six_decimals(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

std::vector<CsvField> csv_fields(std::string_view line) {
  std::vector<CsvField> fields;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    const std::size_t begin = at;
    CsvField field;
    bool quoted = false;
    for (; at < line.size() && (quoted || line[at] != ','); ++at) {
      if (line[at] != '"') {
        field.text += line[at];
      } else if (quoted && at + 1 < line.size() && line[at + 1] == '"') {
        field.text += line[at++];
      } else {
        quoted = !quoted;
      }
    }
    field.where = line.substr(begin, at - begin);
    fields.push_back(std::move(field));
  }
  return fields;
}

std::string csv_quoted(std::string_view text) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

void add_csv_field(std::string& line, std::optional<double> value) {
  line += ',';
  if (value) line += six_decimals(*value);
}

}  // namespace jaywalk
