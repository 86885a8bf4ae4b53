// SPDX-License-Identifier: Apache-2.0
#pragma once

// The kill matrix: which behaviours expose which defects of an automated vehicle (AV). A test kills
// a defect if with the same seed and agents the healthy AV breaks no assertion and the defective
// one breaks one that it could have kept. Read experiment.h and test_assessment.h first.

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/test_assessment.h"

namespace jaywalk {

/// Whether some assertion failed. Verdicts `unavoidable` do not count.
[[nodiscard]] bool blames_the_av(std::span<const Judgement> judgements);
[[nodiscard]] bool blames_the_av(const TestAssessment& assessment);
[[nodiscard]] bool blames_the_av(std::span<const AssessmentRow> assessments);

/// The tests of a behaviour with one number of agents and one defect.
struct KillCell {
  /// 0 until all of the cell's tests are finished. Tests that ended errored, with the healthy AV or
  /// the defective one, are left out.
  std::uint64_t tests = 0;
  std::uint64_t errored = 0;
  std::uint64_t kills = 0;
  /// How many tests were run up to the first that kills, that one included.
  std::optional<std::uint64_t> first;
  /// For tests whose order matters (a search learns from them): the median of `first` over its
  /// repetitions; nothing if the median repetition never kills.
  struct Measured {
    std::optional<std::uint64_t> first_median;
  };
  std::optional<Measured> measured = std::nullopt;
};

struct KillRow {
  std::string behaviour;
  std::uint32_t agents = 0;
  /// In how many of its tests the healthy AV itself is to blame; these kill nothing.
  std::uint64_t healthy_failures = 0;
  /// In the order of the defects.
  std::vector<KillCell> cells;
  /// Whether it was read from a file (kills_file.h) and only its kills are known.
  bool kills_alone = false;

  /// With all defects together.
  [[nodiscard]] std::uint64_t tests() const;
  /// With each of those whose tests are finished.
  [[nodiscard]] std::uint64_t tests_of_each() const;
  [[nodiscard]] std::uint64_t kills() const;
  [[nodiscard]] std::uint64_t errored() const;
  /// How many defects some test of it kills.
  [[nodiscard]] std::size_t killed() const;
};

struct KillMatrix {
  /// `latency=0.3`; or `given`, the AV as the scenario describes it beside its healthy twin.
  std::vector<std::string> defects;
  /// In the order of behaviours, then of numbers of agents.
  std::vector<KillRow> rows;

  [[nodiscard]] bool empty() const { return defects.empty(); }
};

/// The kills in percent of the tests with all defects; 0 if there are no tests.
[[nodiscard]] double kill_pct(const KillRow& row);

/// How many tests it takes to kill the defect with a chance of at least a half: the median over all
/// orders in which these tests could have been run, or over a search's repetitions. Nothing if none
/// of them kills.
[[nodiscard]] std::optional<std::uint64_t> first_kill_median(const KillCell& cell);
/// The median of that over the defects, where one that is never killed takes longer than any.
/// Nothing if that is the median.
[[nodiscard]] std::optional<std::uint64_t> first_kill_median(const KillRow& row);

/// The share of defects, from 0 to 1, that `tests` of the row's tests are expected to kill: the
/// mean over all choices of tests. A defect with fewer tests counts with all of its tests.
[[nodiscard]] double mutation_score(const KillRow& row, std::uint64_t tests);

/// The defects that no row kills, as indices.
[[nodiscard]] std::vector<std::size_t> survivors(const KillMatrix& matrix);
/// The row with the greatest share of kills, the first of equals; nothing if no row kills it.
[[nodiscard]] std::optional<std::size_t> best_killer(const KillMatrix& matrix, std::size_t defect);
/// The fewest rows that together kill every defect that some row kills, as ascending indices; of
/// several such teams the one with most kills, then the first.
[[nodiscard]] std::vector<std::size_t> smallest_team(const KillMatrix& matrix);

/// Collects results from several threads; the matrix depends on the tests alone.
class KillTable {
 public:
  /// `expected`: how many tests of each cell there will be (those of a shard, say).
  KillTable(const ExperimentPlan& plan, std::uint64_t expected);

  /// REQUIRES: a test of the plan, numbered from 0; each once.
  void add(const TestKey& test, bool blamed);
  /// Adds a test that ended errored. REQUIRES: a test of the plan; each once.
  void add_errored(const TestKey& test);
  /// REQUIRES: no thread adds at the same time.
  [[nodiscard]] KillMatrix matrix() const;

 private:
  enum class Outcome : std::uint8_t { unknown, kept, blamed, errored };
  struct Cell {
    std::once_flag started;
    std::vector<Outcome> tests;
  };
  void add(const TestKey& test, Outcome outcome);
  [[nodiscard]] KillCell compare(const Cell& healthy, const Cell& defective) const;

  ExperimentPlan plan_;
  std::uint64_t expected_;
  std::vector<Cell> cells_;
};

}  // namespace jaywalk
