// SPDX-License-Identifier: Apache-2.0
#pragma once

// Errors and warnings about the user's input: collected, not thrown, and rendered as
// `file:line:column: error: message`, the line, a caret and a hint. A Diagnostic points at a Span
// of bytes in a Source, the text that the user wrote.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
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

enum class Severity { error, warning, note };
enum class Colour { off, on };

struct Diagnostic {
  Severity severity = Severity::error;
  /// One lower-case line without a final stop, with the found and the expected text.
  std::string message;
  SourceSpan where;
  /// A suggestion ("did you mean ..."); may be empty.
  std::string hint;
  /// The name by which a warning is documented and silenced, "unknown-goal"; empty for errors.
  std::string code;
  /// The file name or option with the error, if there is no source text.
  std::string subject;
};

/// `file:line:column: error: message`, then the line, a caret and the hint; ends with a line break.
[[nodiscard]] std::string render(const Diagnostic& diagnostic, Colour colour = Colour::off);

/// Diagnostics in the order in which they were found, at most kLimit kept.
class Diagnostics {
 public:
  static constexpr std::size_t kLimit = 100;

  void add(Diagnostic diagnostic);
  void error(SourceSpan where, std::string message, std::string hint = {});
  void warning(SourceSpan where, std::string code, std::string message, std::string hint = {});
  /// An error about a file or an option as a whole.
  void error(std::string subject, std::string message, std::string hint = {});
  void append(Diagnostics other);
  /// Puts those about one text into the order of the text. REQUIRES: they concern one text.
  void sort_by_place();

  [[nodiscard]] bool has_errors() const { return errors_ > 0; }
  [[nodiscard]] std::size_t error_count() const { return errors_; }
  [[nodiscard]] std::size_t warning_count() const { return warnings_; }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] std::span<const Diagnostic> items() const { return items_; }
  [[nodiscard]] std::string render(Colour colour = Colour::off) const;

 private:
  std::vector<Diagnostic> items_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
};

/// A value, or why there is none. REQUIRES of value(): ok(); of diagnostics(): not ok().
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Diagnostics diagnostics) : content_(std::move(diagnostics)) {}

  [[nodiscard]] bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }
  [[nodiscard]] T& value() & { return std::get<0>(content_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(content_); }
  [[nodiscard]] T&& value() && { return std::get<0>(std::move(content_)); }
  [[nodiscard]] Diagnostics& diagnostics() { return std::get<1>(content_); }
  [[nodiscard]] const Diagnostics& diagnostics() const { return std::get<1>(content_); }

 private:
  std::variant<T, Diagnostics> content_;
};

}  // namespace jaywalk
