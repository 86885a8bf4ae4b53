// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files that options like --csv ask for.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiment/scenario/files/write_file.h"
#include "tools/jaywalk/console/console.h"
#include "tools/jaywalk/options/arguments.h"

namespace jaywalk {

/// The name that means standard output.
inline constexpr std::string_view kStandardOutput = "-";

/// Whether a command prints its table: not with --quiet, nor where an option takes standard output.
[[nodiscard]] bool prints_table(const Arguments& arguments);

/// Tries the places that options name before anything is done; false after reporting those that
/// cannot be written, and those where something else is read or written.
[[nodiscard]] bool can_write_outputs(const Arguments& arguments,
                                     std::span<const OptionSpec> options, Console& console);

/// Writes a whole file. Flushes the console first, since the file may be /dev/stdout. False after
/// reporting that it cannot be written.
[[nodiscard]] bool write_output(const std::string& path, std::string_view text, Console& console,
                                Links links = Links::followed);

/// Writes a text that is too long for memory, piece by piece. If the source fails, it reports why.
[[nodiscard]] bool write_output(const std::string& path, const TextSource& source, Console& console,
                                Links links = Links::followed);

/// The option that asks for a file, and what goes into it; nothing: why not has been reported.
struct OutputFile {
  OptionName option;
  std::function<std::optional<std::string>()> text;
  /// Instead of `text`, for a text that is too long for memory.
  TextSource pieces = nullptr;
};

/// Writes those that are asked for; false if one of them could not be written.
[[nodiscard]] bool write_outputs(const Arguments& arguments, std::span<const OutputFile> files,
                                 Console& console);

}  // namespace jaywalk
