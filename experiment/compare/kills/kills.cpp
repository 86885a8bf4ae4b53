// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/kills/kills.h"

#include <algorithm>

#include "experiment/test_run/tested_vehicles.h"

namespace jaywalk {
namespace {

/// The chance that none of n tests, drawn at random from the cell's without putting back, kills;
/// for n = 1, 2, …
class NoKill {
 public:
  explicit NoKill(const KillCell& cell) : tests_(cell.tests), kills_(cell.kills) {}

  /// Draws another test and returns the chance with it. REQUIRES: there is one.
  double next() {
    const std::uint64_t left = tests_ - drawn_;
    const std::uint64_t harmless = left > kills_ ? left - kills_ : 0;
    chance_ *= static_cast<double>(harmless) / static_cast<double>(left);
    ++drawn_;
    return chance_;
  }

 private:
  std::uint64_t tests_;
  std::uint64_t kills_;
  std::uint64_t drawn_ = 0;
  double chance_ = 1;
};

}  // namespace

bool blames_the_av(std::span<const Judgement> judgements) {
  return std::ranges::any_of(
      judgements, [](const Judgement& judgement) { return judgement.verdict == Verdict::fail; });
}

bool blames_the_av(const TestAssessment& assessment) {
  return blames_the_av(assessment.judgements);
}

bool blames_the_av(std::span<const AssessmentRow> assessments) {
  return std::ranges::any_of(assessments, [](const AssessmentRow& assessment) {
    return assessment.verdict == StoredVerdict::fail;
  });
}

std::uint64_t KillRow::tests() const {
  std::uint64_t sum = 0;
  for (const KillCell& cell : cells) sum += cell.tests;
  return sum;
}

std::uint64_t KillRow::errored() const {
  std::uint64_t sum = 0;
  for (const KillCell& cell : cells) sum += cell.errored;
  return sum;
}

std::uint64_t KillRow::tests_of_each() const {
  const auto most = std::ranges::max_element(cells, {}, &KillCell::tests);
  return most == cells.end() ? 0 : most->tests;
}

std::uint64_t KillRow::kills() const {
  std::uint64_t sum = 0;
  for (const KillCell& cell : cells) sum += cell.kills;
  return sum;
}

std::size_t KillRow::killed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cells, [](const KillCell& cell) { return cell.kills > 0; }));
}

double kill_pct(const KillRow& row) {
  const std::uint64_t tests = row.tests();
  return tests == 0 ? 0 : 100 * static_cast<double>(row.kills()) / static_cast<double>(tests);
}

std::optional<std::uint64_t> first_kill_median(const KillCell& cell) {
  if (cell.measured) return cell.measured->first_median;
  if (cell.kills == 0) return std::nullopt;
  NoKill none(cell);
  for (std::uint64_t tests = 1; tests <= cell.tests; ++tests) {
    // The median: the first number of tests whose chance of a kill is at least a half.
    if (none.next() <= 0.5) return tests;
  }
  return cell.tests;
}

std::optional<std::uint64_t> first_kill_median(const KillRow& row) {
  std::vector<std::uint64_t> found;
  for (const KillCell& cell : row.cells) {
    if (const auto median = first_kill_median(cell)) found.push_back(*median);
  }
  // The lower one of two in the middle: what half of the defects take at most.
  const std::size_t middle = (row.cells.size() + 1) / 2;
  if (middle == 0 || found.size() < middle) return std::nullopt;
  std::ranges::sort(found);
  return found[middle - 1];
}

double mutation_score(const KillRow& row, std::uint64_t tests) {
  if (row.cells.empty()) return 0;
  double score = 0;
  for (const KillCell& cell : row.cells) {
    if (cell.kills == 0) continue;
    NoKill none(cell);
    double chance = 1;
    for (std::uint64_t i = 0; i < std::min(tests, cell.tests) && chance > 0; ++i)
      chance = none.next();
    score += 1 - chance;
  }
  return score / static_cast<double>(row.cells.size());
}

KillTable::KillTable(const ExperimentPlan& plan, std::uint64_t expected)
    : plan_(plan),
      expected_(expected),
      cells_(plan.vehicles.size() > 1 && !compares_models(plan.vehicles) ? plan.cells() : 0) {}

void KillTable::add(const TestKey& test, bool blamed) {
  add(test, blamed ? Outcome::blamed : Outcome::kept);
}

void KillTable::add_errored(const TestKey& test) { add(test, Outcome::errored); }

void KillTable::add(const TestKey& test, Outcome outcome) {
  if (cells_.empty()) return;
  Cell& cell = cells_[plan_.cell_of(test)];
  // Made by the first of its threads; afterwards each writes to a place of its own.
  std::call_once(cell.started, [&] { cell.tests.resize(plan_.tests); });
  cell.tests[test.number] = outcome;
}

KillCell KillTable::compare(const Cell& healthy, const Cell& defective) const {
  KillCell result;
  if (healthy.tests.empty() || defective.tests.empty()) return result;
  for (std::uint64_t test = 0; test < plan_.tests; ++test) {
    const Outcome twin = healthy.tests[test];
    const Outcome own = defective.tests[test];
    // Compared test by test: the same number starts alike with both vehicles.
    if (twin == Outcome::unknown || own == Outcome::unknown) continue;
    if (twin == Outcome::errored || own == Outcome::errored) {
      ++result.errored;
      continue;
    }
    ++result.tests;
    if (twin != Outcome::kept || own != Outcome::blamed) continue;
    if (++result.kills == 1) result.first = result.tests;
  }
  // A cell of which tests are missing has no figures yet.
  return result.tests + result.errored == expected_ ? result : KillCell{};
}

KillMatrix KillTable::matrix() const {
  KillMatrix matrix;
  if (cells_.empty()) return matrix;
  matrix.defects.assign(plan_.vehicles.begin() + 1, plan_.vehicles.end());
  for (std::size_t place = 0; place < plan_.rows(); ++place) {
    KillRow row{.behaviour = plan_.behaviours[place / plan_.agents.size()],
                .agents = plan_.agents[place % plan_.agents.size()]};
    const Cell& healthy = cells_[place];
    row.healthy_failures =
        static_cast<std::uint64_t>(std::ranges::count(healthy.tests, Outcome::blamed));
    for (std::size_t vehicle = 1; vehicle < plan_.vehicles.size(); ++vehicle) {
      row.cells.push_back(compare(healthy, cells_[vehicle * plan_.rows() + place]));
    }
    matrix.rows.push_back(std::move(row));
  }
  return matrix;
}

}  // namespace jaywalk
