#pragma once

// Text within HTML, SVG and XML.

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

}  // namespace jaywalk
