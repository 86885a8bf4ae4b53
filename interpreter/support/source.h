#pragma once

// The text of one file and how byte offsets in it become lines and columns. Everything that the
// user wrote is pointed at by a Span into a Source; read diagnostics.h next.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace jaywalk {

/// A half-open range of byte offsets, [begin, end), in one Source.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend bool operator==(const Span&, const Span&) = default;
};

/// An immutable text with a name. Shared by everything that was made from it.
class Source {
 public:
  /// Line and column, both from 1; the column counts characters (UTF-8 code points).
  struct Position {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
  };

  Source(std::string name, std::string text);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::string_view text(Span span) const;
  [[nodiscard]] Position position(std::uint32_t offset) const;
  /// The text of a line (from 1) without its line break.
  [[nodiscard]] std::string_view line(std::uint32_t number) const;

 private:
  // So many bytes lie between two places before which characters have been counted.
  static constexpr std::size_t kBetweenMarks = 1024;
  [[nodiscard]] std::size_t characters_before(std::uint32_t offset) const;

  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
  std::vector<std::uint32_t> characters_at_marks_;
};

using SourcePtr = std::shared_ptr<const Source>;

/// A place in a text; without a source, the diagnostic concerns no place (a missing file, say).
struct SourceSpan {
  SourcePtr source;
  Span span;
};

}  // namespace jaywalk
