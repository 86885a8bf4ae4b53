#include "tools/jaywalk/console/output_files.h"

#include <fmt/format.h>

#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {

bool write_output(const std::string& path, std::string_view text, Console& console) {
  return write_output(
      path,
      [text](const TextSink& sink) {
        sink(text);
        return true;
      },
      console);
}

bool write_output(const std::string& path, const TextSource& source, Console& console) {
  if (path == kStandardOutput) {
    return source([&](std::string_view piece) { console.print(piece); });
  }
  console.flush();
  const auto why = write_file(path, source);
  if (why && !why->empty()) console.error(fmt::format("cannot write '{}': {}", path, *why));
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
