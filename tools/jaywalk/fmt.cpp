// `jaywalk fmt`: programs in their canonical layout.

#include <fmt/format.h>

#include "experiment/export/write_file.h"
#include "interpreter/syntax/formatter.h"
#include "tools/jaywalk/command.h"
#include "tools/jaywalk/line_diff.h"

namespace jaywalk::command::fmt_ {
namespace {

enum class Found { same, different, wrong };

struct Mode {
  bool check = false;
  bool diff = false;
};

Found format_file(const std::string& path, const Mode& mode, Console& console) {
  auto source = read_source(path);
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
  if (before == after) return Found::same;
  if (mode.diff) console.print(line_diff(before, after, path, path + " (formatted)"));
  if (mode.check && !mode.diff) console.print(::fmt::format("{}\n", path));
  if (mode.check || mode.diff) return Found::different;
  if (const auto problem = write_file(path, after)) {
    console.error(*problem);
    return Found::wrong;
  }
  console.print(::fmt::format("{}\n", path));
  return Found::different;
}

}  // namespace

CommandHelp help() {
  return {.usage = "FILE... [OPTIONS]",
          .description =
              "Lays out programs (.asl) in place and names those that have changed. Nothing but\n"
              "blanks is added or taken away; comments stay. A plan written on one line stays\n"
              "on one if it fits, others get a line for each formula. A file with mistakes is\n"
              "left as it is.\n",
          .options = {{"check", "",
                       "write nothing; name the files that would change,\nand exit with 1"},
                      {"diff", "", "write nothing; show what would change"}},
          .examples =
              "  jaywalk fmt agent.asl\n"
              "  jaywalk fmt agents/*.asl --check --diff\n"};
}

ExitCode execute(const Arguments& arguments, Console& console) {
  if (arguments.operands().empty()) {
    console.error("expected at least one file", "jaywalk fmt --help shows how to write it");
    return ExitCode::usage;
  }
  const Mode mode{.check = arguments.has("check"), .diff = arguments.has("diff")};
  bool any_wrong = false;
  bool any_different = false;
  for (const std::string& path : arguments.operands()) {
    if (!path.ends_with(".asl")) {
      console.error(::fmt::format("expected a file .asl, found '{}'", path));
      any_wrong = true;
      continue;
    }
    const Found found = format_file(path, mode, console);
    any_wrong = any_wrong || found == Found::wrong;
    any_different = any_different || found == Found::different;
  }
  if (any_wrong) return ExitCode::usage;
  return mode.check && any_different ? ExitCode::failed : ExitCode::success;
}

}  // namespace jaywalk::command::fmt_
