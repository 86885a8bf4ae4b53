// SPDX-License-Identifier: Apache-2.0
#pragma once

// For the project's own readers of texts, beside the public diagnostics: suggestions for names
// that are misspelt, and files of UTF-8 text.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <jaywalk/diagnostics.h>

namespace jaywalk {

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
