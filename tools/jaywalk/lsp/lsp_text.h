#pragma once

// A document of an editor, and its places as the protocol counts them: lines and UTF-16 units, both
// from 0.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/support/source.h"

namespace jaywalk::lsp {

struct Position {
  std::uint32_t line = 0;
  std::uint32_t unit = 0;
};

struct Range {
  Position begin;
  Position end;
};

class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text);

  /// Places beyond a line's or the text's end are its end.
  [[nodiscard]] std::uint32_t offset(Position position) const;
  [[nodiscard]] Position position(std::uint32_t offset) const;
  [[nodiscard]] Range range(Span span) const { return {position(span.begin), position(span.end)}; }

 private:
  [[nodiscard]] std::string_view line(std::uint32_t number) const;

  std::string_view text_;
  std::vector<std::uint32_t> starts_;
};

/// The file of a `file:` URI, or the URI itself if it is another.
[[nodiscard]] std::string path_of_uri(std::string_view uri);
[[nodiscard]] std::string uri_of_path(std::string_view path);

}  // namespace jaywalk::lsp
