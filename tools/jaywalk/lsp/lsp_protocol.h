// SPDX-License-Identifier: Apache-2.0
#pragma once

// A document of an editor, and its places as the protocol counts them: lines and UTF-16 units, both
// from 0.

#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <jaywalk/diagnostics.h>

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

// The outermost layer of the protocol: texts behind a header with their length.

/// Longer messages are refused.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20U;

struct Frame {
  std::string content;
  /// The header was none, or the length too great; there is no content.
  bool is_broken = false;
};

/// The next message; nothing at the end. After a broken one the next header is looked for.
[[nodiscard]] std::optional<Frame> read_frame(std::istream& in);
void write_frame(std::ostream& out, std::string_view content);

// Parts of messages. A message may be anything: missing parts, or parts of another type, are empty.

using Json = nlohmann::json;

[[nodiscard]] const Json& part(const Json& json, const char* name);
[[nodiscard]] std::string text_of(const Json& json);
[[nodiscard]] Position position_of(const Json& json);
/// The URI of the document that a message is about.
[[nodiscard]] std::string document_uri(const Json& parameters);

[[nodiscard]] Json to_json(Position position);
[[nodiscard]] Json to_json(const Range& range);

}  // namespace jaywalk::lsp
