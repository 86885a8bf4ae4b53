// SPDX-License-Identifier: Apache-2.0
#pragma once

// Text of others within HTML, SVG and XML, on terminals and in shells, and which of it may be a
// name.

#include <string>
#include <string_view>

namespace jaywalk {

/// Text as it stands between tags and in quoted attributes: `&`, `<`, `>` and `"` are written as
/// references.
[[nodiscard]] std::string escaped(std::string_view text);

/// The same where XML may hold anything: line feeds and tabs are references, too, for readers take
/// them for blanks otherwise; other control characters, which XML does not allow at all, become
/// `?`.
[[nodiscard]] std::string escaped_xml(std::string_view text);

/// A path within a URI: bytes other than ASCII letters and digits and `-._~/` become `%23`. Without
/// that `#` and `?` would end the path.
[[nodiscard]] std::string escaped_uri(std::string_view path);

/// JSON as it may stand in an element `script`: nothing in it ends the element or begins a comment.
[[nodiscard]] std::string in_script(std::string_view json);

/// Whether line breaks are shown as `\n` or break lines.
enum class LineBreaks { shown, kept };

/// Text without control characters, which could move the cursor or do worse to a terminal: they are
/// written as `\x1b`. Tabs stay.
[[nodiscard]] std::string visible(std::string_view text, LineBreaks breaks = LineBreaks::shown);

/// A word as a shell takes it: within quotes, if it has to be.
[[nodiscard]] std::string shell_quoted(const std::string& word);

/// A name that may become a file's name, an option's value and a column's heading (a behaviour's, a
/// generator's, an assertion's): letters of ASCII, digits, `_` and `-`, at most 100 of them, no `-`
/// at the beginning.
[[nodiscard]] bool is_identifier(std::string_view text);
inline constexpr std::string_view kIdentifierHint =
    "names consist of up to 100 letters, digits, _ and -, and do not begin with -";

/// A name that another program may have given (an actor's, an event's): UTF-8 of at most 200 bytes
/// without control characters, not beginning with a blank or with one of `=+-@`, which make a
/// spreadsheet take it for a formula.
[[nodiscard]] bool is_label(std::string_view text);
inline constexpr std::string_view kLabelHint =
    "names are up to 200 bytes long, have no control characters and do not begin with a blank, =, "
    "+, - or @";

/// Lines for a terminal: as visible(), but colours (`ESC [ ... m`) stay, too.
[[nodiscard]] std::string visible_with_colours(std::string_view lines);

}  // namespace jaywalk
