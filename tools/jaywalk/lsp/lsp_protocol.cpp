// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/lsp/lsp_protocol.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "interpreter/support/markup.h"
#include "interpreter/support/text.h"

namespace jaywalk::lsp {
namespace {

constexpr std::string_view kFile = "file://";

// Characters beyond the basic plane take two units; in UTF-8 they begin with 0xF0 or more.
std::uint32_t units_of(char lead) { return static_cast<unsigned char>(lead) >= 0xF0U ? 2 : 1; }

constexpr std::size_t kLongestLine = 1000;

/// Reads a line of a header, without its line break; false at the end of the stream.
bool read_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n') {
      if (line.ends_with('\r')) line.pop_back();
      return true;
    }
    if (line.size() < kLongestLine) line += static_cast<char>(c);
  }
  return !line.empty();
}

std::optional<std::size_t> length_in(std::string_view line) {
  constexpr std::string_view kName = "content-length:";
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (line.size() < kName.size() || !std::equal(kName.begin(), kName.end(), line.begin(),
                                                [&](char a, char b) { return a == lower(b); })) {
    return std::nullopt;
  }
  line.remove_prefix(std::min(line.find_first_not_of(" \t", kName.size()), line.size()));
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), length);
  if (error != std::errc() || end != line.data() + line.size()) return std::nullopt;
  return length;
}

std::uint32_t number_of(const Json& json) {
  constexpr double kMost = 4e9;
  const double number = json.is_number() ? json.get<double>() : 0;
  return number > 0 && number < kMost ? static_cast<std::uint32_t>(number) : 0;
}

}  // namespace

TextPlaces::TextPlaces(std::string_view text) : text_(text), starts_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

std::string_view TextPlaces::line(std::uint32_t number) const {
  const std::size_t end = number + 1 < starts_.size() ? starts_[number + 1] - 1 : text_.size();
  std::string_view line = text_.substr(starts_[number], end - starts_[number]);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::uint32_t TextPlaces::offset(Position position) const {
  if (position.line >= starts_.size()) return static_cast<std::uint32_t>(text_.size());
  const std::string_view text = line(position.line);
  std::uint32_t units = 0;
  std::size_t at = 0;
  while (at < text.size() && units < position.unit) {
    units += units_of(text[at]);
    do ++at;
    while (at < text.size() && !begins_character(text[at]));
  }
  return starts_[position.line] + static_cast<std::uint32_t>(at);
}

Position TextPlaces::position(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
  Position position;
  position.line = static_cast<std::uint32_t>(after - starts_.begin() - 1);
  for (std::size_t i = starts_[position.line]; i < offset; ++i) {
    if (begins_character(text_[i])) position.unit += units_of(text_[i]);
  }
  return position;
}

std::string path_of_uri(std::string_view uri) {
  if (!uri.starts_with(kFile)) return std::string(uri);
  uri.remove_prefix(kFile.size());
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned value = 0;
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() &&
                         std::from_chars(&uri[i + 1], &uri[i + 3], value, 16).ptr == &uri[i + 3];
    path += escaped ? static_cast<char>(value) : uri[i];
    if (escaped) i += 2;
  }
  return path;
}

std::string uri_of_path(std::string_view path) {
  if (path.find("://") != path.npos || path.starts_with("untitled:")) return std::string(path);
  return std::string(kFile) + escaped_uri(path);
}

std::optional<Frame> read_frame(std::istream& in) {
  std::string line;
  std::optional<std::size_t> length;
  bool any = false;
  while (read_line(in, line)) {
    if (line.empty()) {
      if (any) break;
      continue;
    }
    any = true;
    if (const auto found = length_in(line)) length = found;
  }
  if (!any) return std::nullopt;
  Frame frame;
  frame.is_broken = !length || *length > kLongestMessage;
  if (frame.is_broken) return frame;
  frame.content.resize(*length);
  in.read(frame.content.data(), static_cast<std::streamsize>(*length));
  frame.is_broken = static_cast<std::size_t>(in.gcount()) != *length;
  if (frame.is_broken) frame.content.clear();
  return frame;
}

void write_frame(std::ostream& out, std::string_view content) {
  out << "Content-Length: " << content.size() << "\r\n\r\n" << content << std::flush;
}

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
