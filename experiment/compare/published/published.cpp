// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/published/published.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <span>
#include <tuple>

#include "experiment/compare/published/paper_figures.h"

namespace jaywalk {
namespace {

using Key = std::tuple<std::string_view, std::string_view, std::uint32_t>;
using Figures = std::map<Key, Estimate>;

/// The text up to the separator, which is removed from `rest` with it.
std::string_view take(std::string_view& rest, char separator) {
  const auto end = rest.find(separator);
  const std::string_view taken = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return taken;
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

Figures parse(std::string_view text) {
  Figures figures;
  while (!text.empty()) {
    std::string_view line = take(text, '\n');
    if (line.starts_with('#')) continue;
    const std::string_view column = take(line, ',');
    const std::string_view behaviour = take(line, ',');
    const auto agents = number(take(line, ','));
    if (!agents) continue;  // the line with the names of the columns
    Estimate figure;
    figure.value = number(take(line, ','));
    figure.low = number(take(line, ','));
    figure.high = number(take(line, ','));
    figures[{column, behaviour, static_cast<std::uint32_t>(*agents)}] = figure;
  }
  return figures;
}

const Figures& figures() {
  static const Figures kFigures = parse(kPaperFigures);
  return kFigures;
}

// Why a faithful run gives other values; docs/reference/paper.md has by how much.
constexpr std::array<std::string_view, 5> kDiffering = {
    "They come from a program with quirks that this run does not repeat, hence the differences:",
    "- a test's AV begins with what the last test left of its tick: fewer ticks, higher scores;",
    "- random behaviour walks against the AV's direction only: fewer tests succeed;",
    "- a pedestrian alone counts the radius itself as near in elections: 50.0 % for 47.9 %.",
    "Table I of the paper has four misprints. --preset as-published-program repeats the quirks.",
};
constexpr std::array<std::string_view, 1> kRepeated = {
    "This preset repeats the quirks of the program that they come from; Table I has misprints."};

}  // namespace

bool is_shown(const PublishedRows& rows, const Measure& measure) {
  return rows.world || measure.name != "combined_normalised";
}

bool has_published_figures(std::string_view behaviour) {
  return std::ranges::any_of(
      figures(), [&](const auto& each) { return std::get<1>(each.first) == behaviour; });
}

std::optional<Estimate> published_figure(const PublishedRows& rows, const Measure& measure,
                                         std::string_view behaviour, std::uint32_t agents) {
  if (std::ranges::find(rows.behaviours, behaviour) == rows.behaviours.end()) return std::nullopt;
  const auto found = figures().find({measure.column, behaviour, agents});
  if (found == figures().end()) return std::nullopt;
  return found->second;
}

std::vector<std::string> published_notes(const PublishedRows& rows) {
  std::vector<std::string> notes;
  if (!rows.behaviours.empty()) {
    notes.emplace_back(
        "paper: the published values (Chance, Ghobrial, Lemaignan, Pipe and Eder 2020).");
    const bool repeated = rows.quirks == PublishedQuirks::repeated;
    const auto why = repeated ? std::span<const std::string_view>(kRepeated) : kDiffering;
    notes.insert(notes.end(), why.begin(), why.end());
  }
  if (!rows.left_out.empty()) {
    notes.push_back("paper: published values are left out: " + rows.left_out + '.');
  }
  return notes;
}

}  // namespace jaywalk
