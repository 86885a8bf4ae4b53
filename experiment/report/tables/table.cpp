// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "experiment/compare/measures/measures.h"
#include "experiment/compare/published/agreement.h"
#include "experiment/report/tables/tables.h"
#include "interpreter/support/text.h"

namespace jaywalk {
namespace {

enum class Interval95 { shown, hidden };
/// The columns of the published values.
enum class Paper { shown, hidden };
/// The column of the tests that ended errored, which is there if some did.
enum class Errored { shown, hidden };

/// A measure in the table: its value, perhaps its interval, and the paper's value.
struct Column {
  std::string_view measure;
  std::string_view title;
  int width;
  int decimals;
  Interval95 interval;
};

constexpr std::array kColumns = {
    Column{"accuracy", "accuracy %", 10, 1, Interval95::shown},
    Column{"score", "score", 7, 2, Interval95::shown},
    Column{"combined_normalised", "combined_normalised", 19, 3, Interval95::hidden},
    Column{"ticks_all", "ticks", 6, 2, Interval95::hidden},
    Column{"cpu", "CPU µs", 8, 1, Interval95::hidden},
};

constexpr int kAgentsWidth = 6;
constexpr int kErroredWidth = 7;
constexpr int kIntervalWidth = 16;
constexpr int kPaperWidth = 7;

std::string decimal(std::optional<double> value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : "-";
}

std::string interval_text(const Estimate& estimate, int decimals) {
  if (!estimate.low || !estimate.high) return {};
  return fmt::format("{:.{}f} to {:.{}f}", *estimate.low, decimals, *estimate.high, decimals);
}

std::string heading(const PublishedRows& published, Paper paper, Errored errored) {
  std::string line = fmt::format("{:>{}}", "agents", kAgentsWidth);
  if (errored == Errored::shown) line += fmt::format("  {:>{}}", "errored", kErroredWidth);
  for (const Column& column : kColumns) {
    if (!is_shown(published, *find_measure(column.measure))) continue;
    line += fmt::format("  {:>{}}", column.title, column.width);
    if (column.interval == Interval95::shown) {
      line += fmt::format("  {:>{}}", "95 % interval", kIntervalWidth);
    }
    if (paper == Paper::shown) line += fmt::format("{:>{}}", "paper", kPaperWidth);
  }
  return line + '\n';
}

std::string row(const Summary& summary, const PublishedRows& published, Errored errored) {
  std::string line = fmt::format("{:>{}}", summary.agents, kAgentsWidth);
  if (errored == Errored::shown) line += fmt::format("  {:>{}}", summary.errored, kErroredWidth);
  for (const Column& column : kColumns) {
    const Measure& measure = *find_measure(column.measure);
    if (!is_shown(published, measure)) continue;
    const Estimate ours = measure.estimate(summary);
    line += fmt::format("  {:>{}}", decimal(ours.value, column.decimals), column.width);
    if (column.interval == Interval95::shown) {
      line += fmt::format("  {:>{}}", interval_text(ours, column.decimals), kIntervalWidth);
    }
    if (published.behaviours.empty()) continue;
    const auto paper = published_figure(published, measure, summary.behaviour, summary.agents);
    line += fmt::format("{:>{}}", decimal(paper ? paper->value : std::nullopt, column.decimals),
                        kPaperWidth);
  }
  return line + '\n';
}

std::string line(const std::string& name, std::size_t width, const AvCell& cell, bool judged) {
  const auto share = [&](std::uint64_t part, bool known) {
    return known ? fmt::format("{:.2f}", share_pct(part, cell)) : std::string("-");
  };
  const auto impact = cell.mean_impact_mps();
  return fmt::format("{:<{}}  {:>7}  {:>10}  {:>12}  {:>11}  {:>13}  {:>10}\n", name, width,
                     cell.tests, share(cell.successes, true), share(cell.collisions, true),
                     share(cell.avoidable, judged), share(cell.unavoidable, judged),
                     impact ? fmt::format("{:.2f}", *impact) : "-");
}

}  // namespace

std::string render_table(const Comparison& comparison) {
  std::string table;
  const PublishedRows& published = comparison.published;
  const Paper paper = published.behaviours.empty() ? Paper::hidden : Paper::shown;
  const bool some = std::ranges::any_of(comparison.summaries,
                                        [](const Summary& each) { return each.errored > 0; });
  const Errored errored = some ? Errored::shown : Errored::hidden;
  const std::string* behaviour = nullptr;
  for (const Summary& summary : comparison.summaries) {
    if (behaviour == nullptr || *behaviour != summary.behaviour) {
      behaviour = &summary.behaviour;
      if (!table.empty()) table += '\n';
      table +=
          fmt::format("{} ({} of AgentSpeak)\n", *behaviour, counted(summary.code_lines, "line"));
      table += heading(published, paper, errored);
    }
    table += row(summary, published, errored);
  }
  if (table.empty()) return table;
  std::string notes;
  if (some)
    notes += "errored: tests that came to no end of their own; the measures are of the others.\n";
  for (const std::string& note : published_notes(published)) notes += note + '\n';
  if (const std::string note = agreement_note(comparison); !note.empty()) notes += note + '\n';
  return notes.empty() ? table : table + '\n' + notes;
}

std::string render_avs(const AvRanking& ranking) {
  if (ranking.empty()) return {};
  constexpr std::string_view kIndent = "  ";
  std::size_t width = 10;
  for (const std::string& av : ranking.avs) width = std::max(width, av.size() + kIndent.size());
  for (const AvRow& row : ranking.rows) width = std::max(width, row.behaviour.size() + 6);
  std::string text = fmt::format("{:<{}}  {:>7}  {:>10}  {:>12}  {:>11}  {:>13}  {:>10}\n",
                                 "AV models", width, "tests", "accuracy %", "collisions %",
                                 "avoidable %", "unavoidable %", "impact m/s");
  std::size_t place = 0;
  for (const RankedAv& av : ranked(ranking)) {
    if (av.all.tests == 0) continue;
    text += line(fmt::format("{}. {}", ++place, av.name), width, av.all, ranking.judged);
  }
  for (const AvRow& row : ranking.rows) {
    text += fmt::format("{} ({})\n", row.behaviour, row.agents);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      if (row.cells[i].tests == 0) continue;
      text +=
          line(fmt::format("{}{}", kIndent, ranking.avs[i]), width, row.cells[i], ranking.judged);
    }
  }
  std::uint64_t errored = 0;
  for (const RankedAv& av : ranked(ranking)) errored += av.all.errored;
  if (errored > 0)
    text += fmt::format("\nwithout {} that ended errored\n", counted(errored, "test"));
  return text;
}

}  // namespace jaywalk
