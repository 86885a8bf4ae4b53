// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/avs/av_ranking.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "experiment/compare/kills/kills.h"
#include "experiment/test_run/tested_vehicles.h"

namespace jaywalk {
namespace {

constexpr double kMicrometres = 1e6;

Blame blame_of(bool failed, bool unavoidable) {
  if (failed) return Blame::avoidable;
  return unavoidable ? Blame::unavoidable : Blame::unknown;
}

}  // namespace

Blame blame_of(const TestAssessment& assessment) {
  return blame_of(blames_the_av(assessment),
                  std::ranges::any_of(assessment.judgements, [](const Judgement& each) {
                    return each.verdict == Verdict::unavoidable;
                  }));
}

Blame blame_of(std::span<const AssessmentRow> assessments) {
  return blame_of(blames_the_av(assessments),
                  std::ranges::any_of(assessments, [](const AssessmentRow& each) {
                    return each.verdict == StoredVerdict::unavoidable;
                  }));
}

std::optional<double> AvCell::mean_impact_mps() const {
  if (collisions == 0) return std::nullopt;
  return static_cast<double>(impact_um_s) / kMicrometres / static_cast<double>(collisions);
}

AvCell& AvCell::operator+=(const AvCell& other) {
  tests += other.tests;
  errored += other.errored;
  successes += other.successes;
  collisions += other.collisions;
  avoidable += other.avoidable;
  unavoidable += other.unavoidable;
  impact_um_s += other.impact_um_s;
  return *this;
}

double share_pct(std::uint64_t part, const AvCell& cell) {
  if (cell.tests == 0) return 0;
  return 100 * static_cast<double>(part) / static_cast<double>(cell.tests);
}

std::vector<RankedAv> ranked(const AvRanking& ranking) {
  std::vector<RankedAv> avs;
  for (std::size_t i = 0; i < ranking.avs.size(); ++i) {
    RankedAv& av = avs.emplace_back(RankedAv{ranking.avs[i], {}});
    for (const AvRow& row : ranking.rows) av.all += row.cells[i];
  }
  std::ranges::stable_sort(avs, {}, [&](const RankedAv& av) {
    const double blamed = share_pct(ranking.judged ? av.all.avoidable : 0, av.all);
    // AVs without tests come last; then by avoidable collisions, then by all collisions.
    return std::tuple(av.all.tests == 0, blamed, share_pct(av.all.collisions, av.all),
                      av.all.mean_impact_mps().value_or(0));
  });
  return avs;
}

AvTable::AvTable(const ExperimentPlan& plan, std::uint64_t expected)
    : plan_(plan), expected_(expected), cells_(compares_models(plan.vehicles) ? plan.cells() : 0) {}

void AvTable::add(const TestKey& test, const TestResult& result, std::optional<double> impact_mps,
                  Blame blame) {
  if (cells_.empty()) return;
  const std::lock_guard lock(mutex_);
  AvCell& cell = cells_[plan_.cell_of(test)];
  if (result.errored) {
    ++cell.errored;
    return;
  }
  ++cell.tests;
  cell.successes += result.succeeded;
  if (!impact_mps) return;
  ++cell.collisions;
  cell.avoidable += blame == Blame::avoidable;
  cell.unavoidable += blame == Blame::unavoidable;
  // Summed as whole numbers, so that the order in which threads add does not matter.
  cell.impact_um_s += std::llround(*impact_mps * kMicrometres);
}

AvRanking AvTable::ranking(bool judged) const {
  AvRanking ranking{.judged = judged};
  if (cells_.empty()) return ranking;
  ranking.avs = plan_.vehicles;
  for (std::size_t place = 0; place < plan_.rows(); ++place) {
    AvRow row{.behaviour = plan_.behaviours[place / plan_.agents.size()],
              .agents = plan_.agents[place % plan_.agents.size()]};
    for (std::size_t av = 0; av < plan_.vehicles.size(); ++av) {
      const AvCell& cell = cells_[av * plan_.rows() + place];
      row.cells.push_back(cell.tests + cell.errored == expected_ ? cell : AvCell{});
    }
    ranking.rows.push_back(std::move(row));
  }
  return ranking;
}

}  // namespace jaywalk
