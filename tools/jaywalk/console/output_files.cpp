// SPDX-License-Identifier: Apache-2.0
#include "tools/jaywalk/console/output_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

/// A file that the command reads or writes, and what names it: an option or `the command`.
struct NamedFile {
  std::filesystem::path path;
  std::string by;
};

/// Nothing if writing there replaces no file: standard output, a device, a pipe.
std::optional<std::filesystem::path> file_at(const std::string& path) {
  if (path == kStandardOutput || path.empty()) return std::nullopt;
  const std::string replaced = replaced_file(path);
  if (replaced.empty()) return std::nullopt;
  std::error_code error;
  std::filesystem::path file =
      std::filesystem::weakly_canonical(std::filesystem::absolute(replaced, error), error);
  return error ? std::nullopt : std::optional(std::move(file));
}

/// The files that operands and other options name.
std::vector<NamedFile> files_read(const Arguments& arguments, std::span<const OptionSpec> options) {
  std::vector<NamedFile> files;
  std::error_code ignored;
  const auto add = [&](const std::string& path, const std::string& by) {
    if (!std::filesystem::is_regular_file(path, ignored)) return;
    if (auto file = file_at(path)) files.push_back({std::move(*file), by});
  };
  for (const std::string& operand : arguments.operands()) add(operand, "the command");
  for (const OptionSpec& option : options) {
    if (option.written != Written::no) continue;
    for (const std::string& path : arguments.texts(option.name)) add(path, option.name.dashed());
  }
  return files;
}

/// Reports options that would overwrite a file that the command reads, or that another option
/// writes.
void report_overwriting(const Arguments& arguments, std::span<const OptionSpec> options,
                        Diagnostics& diagnostics) {
  const std::vector<NamedFile> read = files_read(arguments, options);
  std::vector<NamedFile> written;
  const auto naming = [](const std::vector<NamedFile>& files, const std::filesystem::path& path) {
    const auto found = std::ranges::find(files, path, &NamedFile::path);
    return found == files.end() ? nullptr : &*found;
  };
  for (const OptionSpec& option : options) {
    const auto path = option.written == Written::file ? arguments.text(option.name) : std::nullopt;
    const auto file = path ? file_at(*path) : std::nullopt;
    if (!file) continue;
    if (const NamedFile* const other = naming(read, *file)) {
      diagnostics.error(option.name.dashed(),
                        fmt::format("would write over '{}', which {} reads", *path, other->by));
    } else if (const NamedFile* const twice = naming(written, *file)) {
      diagnostics.error(option.name.dashed(),
                        fmt::format("would write over '{}', which {} writes", *path, twice->by));
    }
    written.push_back({*file, option.name.dashed()});
  }
}

}  // namespace

bool write_output(const std::string& path, std::string_view text, Console& console, Links links) {
  return write_output(
      path,
      [text](const TextSink& sink) {
        sink(text);
        return true;
      },
      console, links);
}

bool write_output(const std::string& path, const TextSource& source, Console& console,
                  Links links) {
  if (path == kStandardOutput) {
    return source([&](std::string_view piece) { console.print(piece); });
  }
  console.flush();
  const auto why = write_file(path, source, links);
  if (why && !why->empty()) console.error(fmt::format("cannot write '{}': {}", path, *why));
  if (!why) console.wrote(path);
  return !why;
}

bool prints_table(const Arguments& arguments) {
  return !arguments.has(option::kQuiet) && !arguments.has_value(kStandardOutput);
}

bool can_write_outputs(const Arguments& arguments, std::span<const OptionSpec> options,
                       Console& console) {
  Diagnostics diagnostics;
  for (const OptionSpec& option : options) {
    if (option.written == Written::no) continue;
    for (const std::string& path : arguments.texts(option.name)) {
      if (path == kStandardOutput) continue;
      const auto why =
          option.written == Written::folder ? why_no_folder(path) : why_not_writable(path);
      if (!why) continue;
      diagnostics.error(option.name.dashed(), fmt::format("cannot write '{}': {}", path, *why));
    }
  }
  report_overwriting(arguments, options, diagnostics);
  console.report(diagnostics);
  return !diagnostics.has_errors();
}

bool write_outputs(const Arguments& arguments, std::span<const OutputFile> files,
                   Console& console) {
  bool written = true;
  for (const OutputFile& file : files) {
    const auto path = arguments.text(file.option);
    if (!path) continue;
    if (file.pieces) {
      written = write_output(*path, file.pieces, console) && written;
      continue;
    }
    const std::optional<std::string> text = file.text();
    written = text && write_output(*path, *text, console) && written;
  }
  return written;
}

}  // namespace jaywalk
