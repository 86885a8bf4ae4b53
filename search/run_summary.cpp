// SPDX-License-Identifier: Apache-2.0
#include "search/run_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "search/failing_stretch.h"
#include "search/sut.h"

namespace jaywalk::search {
namespace {

double mean_fitness(const SearchRun& run, double from) {
  std::vector<double> all;
  for (const TestRow& row : run.tests) {
    if (row.test.outcome.refused.empty()) all.push_back(row.test.fitness);
  }
  const auto first = static_cast<std::size_t>(from * static_cast<double>(all.size()));
  double sum = 0;
  for (std::size_t i = first; i < all.size(); ++i) sum += all[i];
  const std::size_t count = all.size() - first;
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

/// Twice the ranks of the absolute differences, so that shared ranks are whole numbers.
std::vector<std::size_t> doubled_ranks(const std::vector<double>& differences) {
  std::vector<std::size_t> order(differences.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) { return std::fabs(differences[i]); };
  std::ranges::stable_sort(order, {}, size);
  std::vector<std::size_t> ranks(order.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && size(order[end]) == size(order[begin])) ++end;
    // Ranks begin + 1 ... end; their mean, doubled.
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = begin + 1 + end;
    begin = end;
  }
  return ranks;
}

constexpr auto kTested = SummaryColumn::Kind::tested;
constexpr auto kTime = SummaryColumn::Kind::time;

constexpr std::array kColumns = {
    SummaryColumn{"tests", "executed tests", &RunSummary::tests, 1},
    SummaryColumn{"failures", "failing tests", &RunSummary::failures, 2, kTested},
    SummaryColumn{"distinct_half_m", "distinct stretches, 0.5 m", &RunSummary::distinct_half_m, 1},
    SummaryColumn{"distinct_1m", "distinct stretches, 1 m", &RunSummary::distinct_1m, 1, kTested},
    SummaryColumn{"distinct_2m", "distinct stretches, 2 m", &RunSummary::distinct_2m, 1, kTested},
    SummaryColumn{"distinct_4m", "distinct stretches, 4 m", &RunSummary::distinct_4m, 1},
    SummaryColumn{"twins_pct", "with a twin within 1 m (%)", &RunSummary::twins_pct, 1},
    SummaryColumn{"sparseness", "sparseness of failing tests", &RunSummary::sparseness, 2, kTested},
    SummaryColumn{"errors", "tests without a result", &RunSummary::errors, 1},
    SummaryColumn{"fitness_last_80", "mean fitness, final 80 %", &RunSummary::fitness_last_80, 2},
    SummaryColumn{"fitness_last_20", "mean fitness, final 20 %", &RunSummary::fitness_last_20, 2},
    SummaryColumn{"diversity", "diversity of failing tests", &RunSummary::diversity, 2, kTested},
    SummaryColumn{"unwrapped_diversity", "diversity, angles unwrapped",
                  &RunSummary::unwrapped_diversity, 2},
    SummaryColumn{"invalid_pct", "invalid candidates (%)", &RunSummary::invalid_pct, 1},
    SummaryColumn{"tests_to_failure", "tests to the first failure", &RunSummary::tests_to_failure,
                  1},
    SummaryColumn{"failures_per_1000", "failing of 1,000 tests", &RunSummary::failures_per_1000, 1},
    SummaryColumn{"naturalness", "naturalness of all tests", &RunSummary::naturalness, 3},
    SummaryColumn{"situation_bins", "situation bins met", &RunSummary::situation_bins, 1, kTested},
    SummaryColumn{"situation_bins_100", "of them by 100 tests", &RunSummary::situation_bins_100, 1,
                  kTested},
    SummaryColumn{"simulated_s", "simulated s per test", &RunSummary::simulated_s, 2},
    SummaryColumn{"generation_ms", "generation ms per test", &RunSummary::generation_ms, 2, kTime},
    SummaryColumn{"execution_ms", "execution ms per test", &RunSummary::execution_ms, 2, kTime},
};

}  // namespace

std::span<const SummaryColumn> summary_columns() { return kColumns; }

std::vector<double> signature(const ExecutedTest& test, const SearchSpace& space) {
  return test.outcome.signature.empty() ? space.signature(test.input) : test.outcome.signature;
}

namespace {

double mean_naturalness(const SearchRun& run, const SutModel& model) {
  const auto measure = find_measure(model.measures(), "naturalness");
  double sum = 0;
  double count = 0;
  for (const TestRow& row : run.tests) {
    if (!measure || !row.test.outcome.executed()) continue;
    sum += row.test.outcome.measures[*measure];
    count += 1;
  }
  return count > 0 ? sum / count : kUnknown;
}

void count_situations(const SearchRun& run, const SutModel& model, RunSummary& summary) {
  constexpr std::size_t kFirst = 100;
  SituationCoverage coverage;
  for (const TestRow& row : run.tests) {
    const auto bins = situation_bins(row.test.outcome, model.measures());
    if (!bins) return;
    coverage.add(*bins);
  }
  summary.situation_bins = static_cast<double>(coverage.covered());
  summary.situation_bins_100 = static_cast<double>(coverage.covered_after(kFirst));
}

void count_stretches(const SearchRun& run, const SutModel& model, RunSummary& summary) {
  if (!measures_stretches(model)) return;
  std::vector<FailingStretch> stretches;
  for (const TestRow& row : run.tests) {
    if (!row.test.failed) continue;
    std::optional<FailingStretch> stretch = failing_stretch(row.test, model);
    if (stretch) stretches.push_back(std::move(*stretch));
  }
  summary.distinct_half_m = static_cast<double>(distinct(stretches, 0.5));
  summary.distinct_1m = static_cast<double>(distinct(stretches, 1));
  summary.distinct_2m = static_cast<double>(distinct(stretches, 2));
  summary.distinct_4m = static_cast<double>(distinct(stretches, 4));
  summary.sparseness = sparseness(stretches);
  if (!stretches.empty()) summary.twins_pct = 100 * twin_share(stretches, 1);
}

/// Notes the requirements that the test counted last was the first to violate.
void note_violations(const Outcome& outcome, std::span<const std::size_t> requirements,
                     RunSummary& summary) {
  for (std::size_t i = 0; i < requirements.size() && outcome.executed(); ++i) {
    const bool is_first = std::isnan(summary.tests_to_violation[i]);
    if (is_first && outcome.measures[requirements[i]] < 0) {
      summary.tests_to_violation[i] = summary.tests;
    }
  }
}

}  // namespace

RunSummary summarise(const SearchRun& run, const SutModel& model) {
  const SearchSpace& space = model.space();
  RunSummary summary{.naturalness = mean_naturalness(run, model)};
  const std::vector<std::size_t> requirements = requirements_of(model.measures());
  summary.tests_to_violation.assign(requirements.size(), kUnknown);
  std::vector<std::vector<double>> signatures;
  std::vector<std::vector<double>> unwrapped;
  double candidates = 0;
  double invalid = 0;
  for (const TestRow& row : run.tests) {
    candidates += static_cast<double>(row.candidates);
    invalid += static_cast<double>(row.invalid);
    if (!row.test.outcome.refused.empty()) continue;
    summary.tests += 1;
    summary.simulated_s += row.test.outcome.simulated_s;
    summary.generation_ms += 1000 * row.generation_s;
    summary.execution_ms += 1000 * row.execution_s;
    if (!row.test.outcome.executed()) summary.errors += 1;
    note_violations(row.test.outcome, requirements, summary);
    if (!row.test.failed) continue;
    summary.failures += 1;
    if (std::isnan(summary.tests_to_failure)) summary.tests_to_failure = summary.tests;
    signatures.push_back(signature(row.test, space));
    unwrapped.push_back(row.test.outcome.signature.empty()
                            ? space.unwrapped_signature(row.test.input)
                            : row.test.outcome.signature);
  }
  count_stretches(run, model, summary);
  count_situations(run, model, summary);
  summary.fitness_last_80 = mean_fitness(run, 0.2);
  summary.fitness_last_20 = mean_fitness(run, 0.8);
  summary.diversity = median_distance(signatures);
  summary.unwrapped_diversity = median_distance(unwrapped);
  if (candidates > 0) summary.invalid_pct = 100 * invalid / candidates;
  if (summary.tests > 0) {
    summary.failures_per_1000 = 1000 * summary.failures / summary.tests;
    summary.simulated_s /= summary.tests;
    summary.generation_ms /= summary.tests;
    summary.execution_ms /= summary.tests;
  }
  return summary;
}

TestsTo tests_to(std::span<const double> needed, std::span<const double> executed) {
  TestsTo result{.found = 0, .searches = needed.size(), .median = {}};
  std::vector<double> found;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (!std::isnan(needed[i])) {
      found.push_back(needed[i]);
    } else if (result.in_vain == 0 || executed[i] < result.in_vain) {
      result.in_vain = executed[i];
    }
  }
  result.found = found.size();
  // Searches without a find are greater than all; of two in the middle both have to be known.
  if (found.size() <= needed.size() / 2) return result;
  found.resize(needed.size(), std::numeric_limits<double>::infinity());
  result.median = median(std::move(found));
  return result;
}

std::string text_of(const TestsTo& found) {
  return fmt::format(
      "{} of {}, {}", found.found, found.searches,
      found.median ? fmt::format("{:.6g}", *found.median) : fmt::format("> {:.6g}", found.in_vain));
}

MeanAndDeviation mean_and_deviation(std::span<const double> all) {
  std::vector<double> values;
  std::ranges::copy_if(all, std::back_inserter(values),
                       [](double each) { return !std::isnan(each); });
  if (values.empty()) return {kUnknown, kUnknown};
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return {mean, values.size() < 2 ? 0 : std::sqrt(squares / (count - 1))};
}

double wilcoxon_signed_rank(std::span<const double> first, std::span<const double> second) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != second[i]) differences.push_back(first[i] - second[i]);
  }
  if (differences.empty()) return 1;
  const std::vector<std::size_t> ranks = doubled_ranks(differences);
  std::size_t positive = 0;
  std::size_t total = 0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    total += ranks[i];
    if (differences[i] > 0) positive += ranks[i];
  }
  // The probability of each sum if every sign is a toss of a coin.
  std::vector<double> probability(total + 1);
  probability[0] = 1;
  std::size_t reached = 0;
  for (const std::size_t rank : ranks) {
    reached += rank;
    for (std::size_t sum = reached + 1; sum-- > 0;) {
      probability[sum] = (probability[sum] + (sum >= rank ? probability[sum - rank] : 0)) / 2;
    }
  }
  const std::size_t less = std::min(positive, total - positive);
  double tail = 0;
  for (std::size_t sum = 0; sum <= less; ++sum) tail += probability[sum];
  return std::min(1.0, 2 * tail);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const std::size_t middle = values.size() / 2;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(middle);
  std::ranges::nth_element(values, place);
  if (values.size() % 2 == 1) return *place;
  return (*place + *std::max_element(values.begin(), place)) / 2;
}

double euclidean_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

double median_distance(const std::vector<std::vector<double>>& signatures) {
  std::vector<double> distances;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    for (std::size_t j = i + 1; j < signatures.size(); ++j) {
      distances.push_back(euclidean_distance(signatures[i], signatures[j]));
    }
  }
  return median(std::move(distances));
}

std::vector<std::vector<std::size_t>> cluster(
    std::size_t count, const std::function<bool(std::size_t founder, std::size_t other)>& same) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < count; ++i) {
    const auto near = std::ranges::find_if(
        groups, [&](const std::vector<std::size_t>& group) { return same(group.front(), i); });
    if (near == groups.end()) {
      groups.push_back({i});
    } else {
      near->push_back(i);
    }
  }
  std::ranges::stable_sort(groups, std::greater<>{}, &std::vector<std::size_t>::size);
  return groups;
}

}  // namespace jaywalk::search
