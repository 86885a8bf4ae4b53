// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace jaywalk {

/// Takes the next piece of a text.
using TextSink = std::function<void(std::string_view)>;
/// Gives a text piece by piece; false if it gave up half-way.
using TextSource = std::function<bool(const TextSink&)>;

/// The path of a file in a folder whose name others may have given, which cannot lead out of the
/// folder: characters other than letters, digits, `.`, `-` and `_` become `_`, as does a full stop
/// at the beginning. An identifier (markup.h) stays as it is.
[[nodiscard]] std::string output_path(const std::string& folder, std::string_view name);

/// What happens to a link that is at the path already. Only a path that the user has written is
/// followed.
enum class Links { followed, replaced };

/// Writes a whole file or nothing: the text goes to a file beside it, which then takes its name.
/// A path that is not a regular file (/dev/stdout, a pipe) is written to directly where links are
/// followed, else replaced. Returns a message about the failure, if there was one.
[[nodiscard]] std::optional<std::string> write_file(const std::string& path, std::string_view text,
                                                    Links links = Links::followed);

/// Like the other write_file(), for a text that is too long for memory. The reason is empty if the
/// source gave up.
[[nodiscard]] std::optional<std::string> write_file(const std::string& path,
                                                    const TextSource& source,
                                                    Links links = Links::followed);

/// The file that is replaced when a path is written to: a link stays a link, and its target is
/// replaced. Empty: the path is written to directly (not a regular file, or a link in /dev).
[[nodiscard]] std::string replaced_file(const std::string& path);

/// Why write_file would fail there, found out by trying: there is no such folder, it cannot be
/// written to, ... Nothing is left behind.
[[nodiscard]] std::optional<std::string> why_not_writable(const std::string& path);
/// Why a folder of that name, which is made where it is missing, could not be written to.
[[nodiscard]] std::optional<std::string> why_no_folder(const std::string& path);

}  // namespace jaywalk
