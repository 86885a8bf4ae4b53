#include "tools/jaywalk/comparison/comparison_output.h"

#include <array>

#include <fmt/format.h>

#include "experiment/export/csv.h"
#include "experiment/export/json.h"
#include "experiment/report/tables/markdown.h"
#include "experiment/report/tables/troubles_text.h"
#include "experiment/report/tables/verdict_table.h"
#include "tools/jaywalk/console/output_files.h"
#include "tools/jaywalk/options/option_names.h"

namespace jaywalk {
namespace {

enum class Format { table, csv, json, markdown };

Format read_format(const Arguments& arguments, Diagnostics& diagnostics) {
  static const std::array<std::string, 4> kFormats = {"table", "csv", "json", "markdown"};
  return static_cast<Format>(arguments.choice(option::kFormat, kFormats, diagnostics));
}

std::string in_format(Format format, const Comparison& comparison) {
  switch (format) {
    case Format::table:
      return render_tables(comparison);
    case Format::csv:
      return to_csv(comparison);
    case Format::json:
      return to_json(comparison);
    case Format::markdown:
      return to_markdown(comparison);
  }
  return {};
}

}  // namespace

void check_format(const Arguments& arguments, Diagnostics& diagnostics) {
  (void)read_format(arguments, diagnostics);
}

void show_comparison(const Arguments& arguments, const Comparison& comparison, Console& console) {
  Diagnostics ignored;  // were reported before
  const Format format = read_format(arguments, ignored);
  const bool shown = prints_table(arguments);
  if (shown) console.print(in_format(format, comparison));
  const std::string troubles = render_troubles(troubles_of(comparison));
  if (troubles.empty()) return;
  if (shown && format == Format::table) {
    console.print('\n' + troubles);
  } else {
    console.flush();
    console.note(troubles.substr(0, troubles.size() - 1));
  }
}

void warn_of_errored(const Comparison& comparison, Console& console) {
  const std::uint64_t errored = errored_tests(comparison);
  if (errored == 0) return;
  std::uint64_t tests = 0;
  for (const Summary& summary : comparison.summaries) tests += summary.tests;
  console.note(fmt::format("warning: {} of {} tests ended errored; the measures are of the others",
                           errored, tests));
}

bool fails_strictly(const Arguments& arguments, const Comparison& comparison, Console& console) {
  if (!arguments.has(option::kStrict) || !is_troubled(troubles_of(comparison))) return false;
  console.error("--strict: agents dropped intentions or never acted, or tests ended errored");
  return true;
}

}  // namespace jaywalk
