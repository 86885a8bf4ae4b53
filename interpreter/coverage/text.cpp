// SPDX-License-Identifier: Apache-2.0
// Coverage as a listing.

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/coverage/source_coverage.h"

namespace jaywalk {
namespace {

std::string text_cell(const Share& share) {
  return fmt::format("{:>5}/{:<5}{:>8}", share.covered, share.of, percent(share));
}

std::string row(std::string_view name, const CoverageTotals& totals, std::size_t width) {
  return fmt::format("{:<{}} {} {} {}\n", name, width, text_cell(totals.plans),
                     text_cell(totals.outcomes), text_cell(totals.formulas));
}

void list(std::string& out, const CoveredFile& file) {
  const auto lines = covered_lines(file);
  const std::string_view text = file.source->text();
  const auto count = static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) +
                     (text.empty() || text.ends_with('\n') ? 0U : 1U);
  for (std::uint32_t number = 1; number <= count; ++number) {
    const auto line = lines.find(number);
    std::string times = "-";
    if (line != lines.end()) {
      times = line->second.count == 0 ? "#####" : fmt::format("{}", line->second.count);
    }
    out += fmt::format("{:>11}:{:>5}:{}\n", times, number, file.source->line(number));
    if (line == lines.end()) continue;
    for (const std::string& gap : line->second.gaps) out += fmt::format("{:>17}^ {}\n", "", gap);
  }
}

}  // namespace

std::string coverage_text(const SourceCoverage& coverage) {
  std::size_t width = 5;
  for (const auto& [name, file] : coverage.files) width = std::max(width, name.size());
  std::string out = fmt::format("{:<{}} {:<19} {:<19} {}\n", "file", width, "plans chosen",
                                "outcomes seen", "formulas executed");
  for (const auto& [name, file] : coverage.files) out += row(name, file.totals(), width);
  out += row("total", coverage.totals(), width);
  for (const auto& [name, file] : coverage.files) {
    out += fmt::format("\n{}\n", name);
    list(out, file);
  }
  return out;
}

}  // namespace jaywalk
