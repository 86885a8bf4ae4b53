// SPDX-License-Identifier: Apache-2.0
#pragma once

// Compares models of an automated vehicle (AV): every test is run with each of them, and they rank
// by how often they hit a road user that a careful driver would not have hit. Read experiment.h and
// kills/kills.h first.

#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/test_assessment.h"

namespace jaywalk {

/// Whether a collision was avoidable according to the assertions.
enum class Blame : std::uint8_t {
  unknown,      ///< the test was not judged, or it broke no assertion
  avoidable,    ///< some assertion failed
  unavoidable,  ///< none failed, and one could not have been kept
};
[[nodiscard]] Blame blame_of(const TestAssessment& assessment);
[[nodiscard]] Blame blame_of(std::span<const AssessmentRow> assessments);

/// The tests of a behaviour with one number of agents and one model; or sums of such.
struct AvCell {
  /// The number of tests without the errored ones; 0 until all of the cell's tests are finished.
  std::uint64_t tests = 0;
  std::uint64_t errored = 0;
  /// Tests that met the precondition, and tests with a collision.
  std::uint64_t successes = 0;
  std::uint64_t collisions = 0;
  std::uint64_t avoidable = 0;
  std::uint64_t unavoidable = 0;
  /// Sum of the first impact of each collision, in micrometres per second: whole numbers, so that
  /// the sum does not depend on the order of the tests.
  std::int64_t impact_um_s = 0;

  /// The mean impact speed of the collisions in m/s; nothing if there are none.
  [[nodiscard]] std::optional<double> mean_impact_mps() const;
  AvCell& operator+=(const AvCell& other);
};

/// A part of a cell's tests in percent; 0 if there are no tests.
[[nodiscard]] double share_pct(std::uint64_t part, const AvCell& cell);

struct AvRow {
  std::string behaviour;
  std::uint32_t agents = 0;
  /// In the order of the models.
  std::vector<AvCell> cells;
};

struct AvRanking {
  std::vector<std::string> avs;
  /// In the order of behaviours, then of numbers of agents.
  std::vector<AvRow> rows;
  /// Whether assertions were judged, without which nothing is known to be avoidable.
  bool judged = false;

  [[nodiscard]] bool empty() const { return avs.empty(); }
};

/// A model over all finished rows.
struct RankedAv {
  std::string name;
  AvCell all;
};
/// The best first: by the share of avoidable collisions (of collisions, if nothing was judged),
/// then of collisions, then by mean impact; equals in the ranking's order.
[[nodiscard]] std::vector<RankedAv> ranked(const AvRanking& ranking);

/// Collects results from several threads; the ranking depends on the tests alone. It is empty for
/// plans that compare no models.
class AvTable {
 public:
  /// `expected`: how many tests of each cell there will be (those of a shard, say).
  AvTable(const ExperimentPlan& plan, std::uint64_t expected);

  /// REQUIRES: a test of the plan; each once.
  void add(const TestKey& test, const TestResult& result, std::optional<double> impact_mps,
           Blame blame);
  /// REQUIRES: no thread adds at the same time.
  [[nodiscard]] AvRanking ranking(bool judged) const;
  [[nodiscard]] bool wanted() const { return !cells_.empty(); }

 private:
  ExperimentPlan plan_;
  std::uint64_t expected_;
  std::mutex mutex_;  // guards what follows
  std::vector<AvCell> cells_;
};

}  // namespace jaywalk
