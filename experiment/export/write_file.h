#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jaywalk {

/// Writes a whole file or nothing: the text goes to a file beside it, which then takes its name.
/// What is not a regular file (/dev/stdout, a pipe) is written to directly. Returns why it could
/// not be done, for people, if so.
[[nodiscard]] std::optional<std::string> write_file(const std::string& path, std::string_view text);

}  // namespace jaywalk
