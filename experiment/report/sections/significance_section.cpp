// SPDX-License-Identifier: Apache-2.0
// Which behaviours differ by more than chance, and by how much. Tests of the same number start
// alike whatever the behaviour, so successes are compared test by test.

#include <algorithm>

#include <fmt/format.h>

#include "experiment/compare/measures/significance.h"
#include "experiment/report/html.h"
#include "experiment/report/report.h"
#include "interpreter/support/markup.h"

namespace jaywalk::reporting {
namespace {

constexpr double kLevel = 0.05;
/// With more behaviours than this, only the first is compared with each of the others.
constexpr std::size_t kAllPairs = 10;

struct BehaviourPair {
  std::string first;
  std::string second;
};

/// Two behaviours with one number of agents.
struct Row {
  std::size_t pair = 0;
  std::uint32_t agents = 0;
  PairedOutcomes outcomes;
  double accuracy_p = 1;
  std::optional<RankComparison> ticks;
  std::optional<MeanComparison> score;
};

std::vector<BehaviourPair> pairs_of(const std::vector<std::string>& behaviours) {
  std::vector<BehaviourPair> pairs;
  for (std::size_t i = 0; i < behaviours.size(); ++i) {
    for (std::size_t j = i + 1; j < behaviours.size(); ++j) {
      if (i == 0 || behaviours.size() <= kAllPairs) pairs.push_back({behaviours[i], behaviours[j]});
    }
  }
  return pairs;
}

/// The paired outcomes of tests that ended errored with neither behaviour.
PairedOutcomes paired(const CellFacts& first, const CellFacts& second, std::uint64_t tests) {
  PairedOutcomes outcomes;
  for (std::size_t i = 0; i < std::min(first.succeeded.size(), second.succeeded.size()); ++i) {
    if (first.errored[i] || second.errored[i]) {
      --tests;
      continue;
    }
    outcomes.both += first.succeeded[i] && second.succeeded[i] ? 1 : 0;
    outcomes.first_only += first.succeeded[i] && !second.succeeded[i] ? 1 : 0;
    outcomes.second_only += !first.succeeded[i] && second.succeeded[i] ? 1 : 0;
  }
  outcomes.neither = tests - outcomes.both - outcomes.first_only - outcomes.second_only;
  return outcomes;
}

std::vector<Row> compare(const ReportData& data, const std::vector<BehaviourPair>& pairs) {
  const Comparison& comparison = data.comparison;
  const auto facts_of = [&](const Summary& summary) -> const CellFacts& {
    return data.facts[static_cast<std::size_t>(&summary - comparison.summaries.data())];
  };
  std::vector<Row> rows;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    for (const std::uint32_t agents : agents_of(comparison)) {
      const Summary* first = find_summary(comparison, pairs[pair].first, agents);
      const Summary* second = find_summary(comparison, pairs[pair].second, agents);
      if (first == nullptr || second == nullptr) continue;
      Row row{.pair = pair, .agents = agents};
      row.outcomes = paired(facts_of(*first), facts_of(*second), first->tests);
      row.accuracy_p = mcnemar(row.outcomes);
      row.ticks = compare_ranks(facts_of(*first).ticks, facts_of(*second).ticks);
      row.score = compare_means(first->score, second->score);
      rows.push_back(row);
    }
  }
  // Each measure's tests are a family of their own. What could not be tested does not count.
  const auto correct = [&](auto has, auto p) {
    std::vector<double> values;
    for (Row& row : rows) {
      if (has(row)) values.push_back(p(row));
    }
    const std::vector<double> corrected = holm(values);
    std::size_t next = 0;
    for (Row& row : rows) {
      if (has(row)) p(row) = corrected[next++];
    }
  };
  correct([](const Row&) { return true; }, [](Row& row) -> double& { return row.accuracy_p; });
  correct([](const Row& row) { return row.ticks.has_value(); },
          [](Row& row) -> double& { return row.ticks->p; });
  correct([](const Row& row) { return row.score.has_value(); },
          [](Row& row) -> double& { return row.score->p; });
  return rows;
}

std::string pair_name(const BehaviourPair& pair) {
  return fmt::format("{} − {}", escaped(pair.first), escaped(pair.second));
}

/// `+12.3`, marked if it is significant.
std::string difference_cell(const Row& row) {
  const double points = 100 * row.outcomes.difference();
  const std::string text = points == 0 ? "0.0" : fmt::format("{:+.1f}", points);
  if (row.accuracy_p >= kLevel) return fmt::format("<small>{}</small>", text);
  return fmt::format("<mark class=\"{}\">{}</mark>", points > 0 ? "better" : "worse", text);
}

std::string overview(const ReportData& data, const std::vector<BehaviourPair>& pairs,
                     const std::vector<Row>& rows) {
  Table table;
  table.column("accuracy, points", Align::left);
  const std::vector<std::uint32_t> agents = agents_of(data.comparison);
  for (const std::uint32_t number : agents) table.column(std::to_string(number));
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    std::vector<std::string> cells{pair_name(pairs[pair])};
    for (const std::uint32_t number : agents) {
      const auto row = std::ranges::find_if(
          rows, [&](const Row& each) { return each.pair == pair && each.agents == number; });
      cells.push_back(row == rows.end() ? "–" : difference_cell(*row));
    }
    table.row(std::move(cells));
  }
  return table.html();
}

std::string all_numbers(const std::vector<BehaviourPair>& pairs, const std::vector<Row>& rows) {
  Table table;
  table.columns({"agents", "accuracy, points", "95 % interval", "first only", "second only", "p",
                 "ticks: A₁₂", "p", "score: g", "p"});
  std::size_t last = pairs.size();
  for (const Row& row : rows) {
    if (row.pair != last) {
      last = row.pair;
      table.heading(fmt::format("{} − {}", pairs[last].first, pairs[last].second));
    }
    const ConfidenceInterval interval = difference_interval(row.outcomes);
    table.row({std::to_string(row.agents), difference_cell(row),
               fmt::format("{:+.1f} to {:+.1f}", 100 * interval.low, 100 * interval.high),
               grouped(row.outcomes.first_only), grouped(row.outcomes.second_only),
               p_value(row.accuracy_p), row.ticks ? decimal(row.ticks->a12, 3) : "–",
               row.ticks ? p_value(row.ticks->p) : "–",
               row.score ? fmt::format("{:+.2f}", row.score->g) : "–",
               row.score ? p_value(row.score->p) : "–"});
  }
  return table.html();
}

}  // namespace

std::string section::significance(const ReportData& data) {
  const std::vector<std::string> behaviours = behaviours_of(data.comparison);
  if (behaviours.size() < 2 || data.facts.size() != data.comparison.summaries.size()) return {};
  const std::vector<BehaviourPair> pairs = pairs_of(behaviours);
  const std::vector<Row> rows = compare(data, pairs);
  std::string html = paragraph(fmt::format(
      "Accuracy of the first behaviour less that of the second, in percentage points, by the "
      "number of agents. Coloured: more than chance, p &lt; {} after Holm’s correction for all {} "
      "comparisons (McNemar’s exact test: tests of the same number start alike, so they are "
      "paired). <mark class=\"better\">The first is better</mark>, <mark class=\"worse\">the "
      "second is better</mark>.",
      kLevel, rows.size()));
  if (behaviours.size() > kAllPairs) {
    html += paragraph("The first behaviour is compared with each of the others.");
  }
  html += overview(data, pairs, rows);
  html += details(
      "All numbers, with sizes of effects",
      "<p class=\"note\">Accuracy: difference with its interval (Agresti and Min), tests in which "
      "only the one succeeded, McNemar’s p. Ticks of all tests: Vargha and Delaney’s A₁₂, the "
      "chance that a test of the first takes longer (0.5: none), p by Mann and Whitney. Scores of "
      "successful tests: Hedges’ g, the difference in standard deviations, p by Welch. All p are "
      "corrected by Holm’s method, for each measure by itself.</p>\n" +
          all_numbers(pairs, rows));
  return html;
}

}  // namespace jaywalk::reporting
