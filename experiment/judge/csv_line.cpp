#include "experiment/judge/csv_line.h"

namespace jaywalk {

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

}  // namespace jaywalk
