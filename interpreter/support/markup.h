#pragma once

// Text of others within HTML, SVG and XML, and on terminals.

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

/// JSON as it may stand in an element `script`: nothing in it ends the element or begins a comment.
[[nodiscard]] std::string in_script(std::string_view json);

/// Whether line breaks are shown as `\n` or break lines.
enum class LineBreaks { shown, kept };

/// Text without control characters, which could move the cursor or do worse to a terminal: they are
/// written as `\x1b`. Tabs stay.
[[nodiscard]] std::string visible(std::string_view text, LineBreaks breaks = LineBreaks::shown);

/// Lines for a terminal: as visible(), but colours (`ESC [ ... m`) stay, too.
[[nodiscard]] std::string visible_with_colours(std::string_view lines);

}  // namespace jaywalk
