// SPDX-License-Identifier: Apache-2.0
// `jaywalk fmt`: programs in their canonical layout.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "experiment/scenario/files/write_file.h"
#include "interpreter/syntax/format/formatter.h"
#include "tools/jaywalk/commands/command.h"
#include "tools/jaywalk/options/input_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk::command::fmt_ {
namespace {

enum class Found { same, different, wrong };

enum class Mode { write, check };

constexpr std::array<std::string_view, 1> kEndings{".asl"};

Found format_file(const std::string& path, Mode mode, Console& console) {
  const bool is_input = path == kStandardInput;
  auto source = read_source(is_input ? "/dev/stdin" : path);
  if (!source) {
    console.report(source.diagnostics());
    return Found::wrong;
  }
  const auto formatted = format_agent(source.value());
  if (!formatted) {
    console.report(formatted.diagnostics());
    return Found::wrong;
  }
  const std::string_view before = source.value()->text();
  const std::string& after = formatted.value();
  if (is_input && mode == Mode::write) {
    console.print(after);
    return Found::same;
  }
  if (before == after) return Found::same;
  if (mode == Mode::write) {
    if (const auto problem = write_file(path, after)) {
      console.error(*problem);
      return Found::wrong;
    }
  }
  console.print(::fmt::format("{}\n", path));
  return Found::different;
}

}  // namespace

CommandHelp help() {
  return {.usage = "FILE|FOLDER|-... [OPTIONS]",
          .description =
              "Lays out programs (.asl) in place, those in a folder too, and names those that\n"
              "have changed; - lays out standard input on standard output. Nothing but blanks\n"
              "is added or taken away; comments stay. A plan written on one line stays on one\n"
              "if it fits, others get a line for each formula. A file with mistakes is left as\n"
              "it is.\n",
          .options = {{option::kCheck, "",
                       "write nothing; name the files that would change,\nand exit with 1"}},
          .examples =
              "  jaywalk fmt agent.asl\n"
              "  jaywalk fmt agents --check\n"
              "  jaywalk fmt - <agent.asl\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().empty()) {
    console.error("expected at least one file", "jaywalk fmt --help shows how to write it");
    return ExitCode::usage;
  }
  const Mode mode = arguments.has(option::kCheck) ? Mode::check : Mode::write;
  std::vector<std::string> files;
  bool any_wrong = !expand_folders(arguments.operands(), kEndings, console, files);
  bool any_different = false;
  for (const std::string& path : files) {
    Diagnostics wrong;
    if (path != kStandardInput && input_file(path, kPrograms, wrong) &&
        !path.ends_with(kEndings[0])) {
      wrong.error(path, "expected a program of agents (.asl)");
    }
    if (wrong.has_errors()) {
      console.report(wrong);
      any_wrong = true;
      continue;
    }
    const Found found = format_file(path, mode, console);
    any_wrong = any_wrong || found == Found::wrong;
    any_different = any_different || found == Found::different;
  }
  if (any_wrong) return ExitCode::usage;
  return mode == Mode::check && any_different ? ExitCode::failed : ExitCode::success;
}

}  // namespace jaywalk::command::fmt_
