// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include <fmt/format.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/export/comparison_files.h"

namespace jaywalk {
namespace {

/// A bar would end the cell.
std::string cell_text(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string estimate_cell(const Estimate& estimate) {
  if (!estimate.value) return "–";
  if (!estimate.low || !estimate.high) return fmt::format("{:.2f}", *estimate.value);
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", *estimate.value, *estimate.low, *estimate.high);
}

}  // namespace

std::string to_markdown(const Comparison& comparison) {
  std::string heading = "| behaviour | agents | tests | successes |";
  std::string rule = "|---|--:|--:|--:|";
  const auto has = [&](const Measure& measure) {
    return !measure.column.empty() && is_shown(comparison.published, measure);
  };
  for (const Measure& measure : measures()) {
    if (!has(measure)) continue;
    heading += fmt::format(" {} |", measure.column);
    rule += "--:|";
  }
  std::string text = heading + '\n' + rule + '\n';
  for (const Summary& summary : comparison.summaries) {
    text += fmt::format("| {} | {} | {} | {} |", cell_text(summary.behaviour), summary.agents,
                        summary.tests, summary.successes);
    for (const Measure& measure : measures()) {
      if (has(measure)) {
        text += fmt::format(" {} |", estimate_cell(measure.estimate(summary)));
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace jaywalk
