#pragma once

// Errors and warnings about the user's input: collected, not thrown, and rendered as
// `file:line:column: error: message`, the line, a caret and a hint.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "interpreter/support/source.h"

namespace jaywalk {

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

/// A value, or why there is none.
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

/// The candidate most like `name` (Damerau-Levenshtein, at most a third of the letters wrong), if
/// any.
[[nodiscard]] std::optional<std::string> closest(std::string_view name,
                                                 std::span<const std::string> candidates);

/// "did you mean 'x'?" or an empty text.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       std::span<const std::string> candidates);

/// Reads a file of UTF-8 text. Errors: missing, a folder, not readable, larger than `max_bytes`,
/// not UTF-8 (with the place of the first bad byte).
[[nodiscard]] Result<SourcePtr> read_source(const std::string& path,
                                            std::size_t max_bytes = std::size_t{64} << 20U);

/// The line of a place and below it the caret, each with a line break. REQUIRES: a source.
[[nodiscard]] std::string excerpt(const SourceSpan& where, Colour colour = Colour::off);

/// The offset of a position; the end of its line, or of the text, if there is no such position.
[[nodiscard]] std::uint32_t offset_of(const Source& source, Source::Position position);

/// The diagnostics with the warnings of that code turned into errors; `hint` is added to theirs.
[[nodiscard]] Diagnostics with_errors(const Diagnostics& diagnostics, std::string_view code,
                                      std::string_view hint);

/// Like read_source(), but invalid UTF-8 is read as U+FFFD, which may stand in comments, strings
/// and quoted atoms; a warning points at the first such byte.
[[nodiscard]] Result<SourcePtr> read_any_encoding(const std::string& path,
                                                  Diagnostics& diagnostics);

}  // namespace jaywalk
