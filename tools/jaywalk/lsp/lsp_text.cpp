#include "tools/jaywalk/lsp/lsp_text.h"

#include <algorithm>
#include <charconv>

#include "interpreter/support/markup.h"
#include "interpreter/support/text.h"

namespace jaywalk::lsp {
namespace {

constexpr std::string_view kFile = "file://";

// Characters beyond the basic plane take two units; in UTF-8 they begin with 0xF0 or more.
std::uint32_t units_of(char lead) { return static_cast<unsigned char>(lead) >= 0xF0U ? 2 : 1; }

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

}  // namespace jaywalk::lsp
