#include "tools/jaywalk/output_files.h"

#include <fmt/format.h>

#include "experiment/export/write_file.h"

namespace jaywalk {

bool write_output(const std::string& path, std::string_view text, Console& console) {
  console.flush();
  const auto why = write_file(path, text);
  if (why) console.error(fmt::format("cannot write '{}': {}", path, *why));
  return !why;
}

bool write_outputs(const Arguments& arguments, std::span<const OutputFile> files,
                   Console& console) {
  bool written = true;
  for (const OutputFile& file : files) {
    const auto path = arguments.text(file.option);
    if (!path) continue;
    const std::optional<std::string> text = file.text();
    written = text && write_output(*path, *text, console) && written;
  }
  return written;
}

}  // namespace jaywalk
