// SPDX-License-Identifier: Apache-2.0
#pragma once

// The verdicts of assertions and the values of metrics for an experiment's tests, and their sums
// for each behaviour and number of agents. Read judge/assertions/assertion.h and
// judge/metrics/metrics.h first.

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/measures/distribution.h"
#include "experiment/judge/assertions/assertion.h"
#include "experiment/judge/metrics/metrics.h"

namespace jaywalk {

/// The assertions and metrics to evaluate on each test.
struct Criteria {
  std::vector<Assertion> assertions;
  bool metrics = false;
  /// Files whose assertions replace the scenario's own.
  std::vector<SourcePtr> files;
};

/// Whether there is anything to evaluate.
[[nodiscard]] inline bool asks(const Criteria& criteria) {
  return criteria.metrics || !criteria.assertions.empty();
}

[[nodiscard]] std::vector<std::string> ids_of(const Criteria& criteria);

struct TestAssessment {
  /// In the order of the assertions.
  std::vector<Judgement> judgements;
  /// In the order of metrics(); empty unless asked for.
  std::vector<std::optional<MetricValue>> metrics;
};

[[nodiscard]] TestAssessment assess(const Criteria& criteria, const Recording& recording,
                                    const Ground& ground);

/// `none`: a metric, which has a value and no verdict.
enum class StoredVerdict { none, vacuous, pass, fail, unavoidable };

/// `none`, `vacuous`, `pass`, `fail`, `unavoidable`: the words of the store's column.
[[nodiscard]] std::string_view name(StoredVerdict verdict);
[[nodiscard]] std::optional<StoredVerdict> parse_stored_verdict(std::string_view text);

/// One row of the table `assessments`. Numbers may be infinite but not NaN.
struct AssessmentRow {
  /// The id of the metric or assertion, `min_distance`; unique in its test together with the actor.
  std::string id;
  std::optional<double> value;
  /// The tick that the value belongs to, or the first one that violates the assertion.
  std::optional<std::uint32_t> tick;
  /// Index into the recording's actors: the other road user, if it concerns one.
  std::optional<std::uint32_t> actor;
  std::optional<double> robustness;
  StoredVerdict verdict = StoredVerdict::none;

  friend bool operator==(const AssessmentRow&, const AssessmentRow&) = default;
};

/// Rows for a store: one for each assertion and for each metric that has a value.
[[nodiscard]] std::vector<AssessmentRow> to_rows(const Criteria& criteria,
                                                 const TestAssessment& assessment);

/// The inverse of to_rows(): judgements in the order of the ids (vacuous if there is no row) and,
/// if there is a value of any, metrics. Stores keep only the first witness.
[[nodiscard]] TestAssessment from_rows(std::span<const AssessmentRow> rows,
                                       std::span<const std::string> assertions);

struct VerdictCounts {
  /// In the order of Verdict.
  std::array<std::uint64_t, kVerdictCount> tests{};

  [[nodiscard]] std::uint64_t of(Verdict verdict) const {
    return tests[static_cast<std::size_t>(verdict)];
  }
  /// The number of tests that met the precondition.
  [[nodiscard]] std::uint64_t exercised() const;
  [[nodiscard]] std::uint64_t all() const;
};

/// The share of tests that met the precondition; 0 if there are none.
[[nodiscard]] double exercised_pct(const VerdictCounts& counts);

/// The sums for one behaviour with one number of agents.
struct AssessmentSummary {
  std::vector<VerdictCounts> verdicts;  // in the order of the assertions
  std::vector<Distribution> metrics;    // in the order of metrics(), if asked for
  /// The robustness of tests that met the precondition, in the order of the assertions.
  std::vector<Distribution> robustness;
};

/// Collects assessments from several threads; the summaries depend on the tests alone.
class AssessmentTable {
 public:
  AssessmentTable(const Criteria& criteria, const ExperimentPlan& plan);

  /// REQUIRES: a test of the plan; each once.
  void add(const TestKey& test, const TestAssessment& assessment);
  /// The summary of the tests that were added. REQUIRES: no thread adds at the same time.
  [[nodiscard]] AssessmentSummary summary(std::size_t behaviour, std::uint32_t agents) const;

 private:
  struct Cell {
    std::vector<VerdictCounts> verdicts;
    bool measured = false;
  };
  [[nodiscard]] std::size_t cell_index(std::size_t behaviour, std::uint32_t agents) const;
  /// The number of the first of a cell's columns: robustness of each assertion, then each metric.
  [[nodiscard]] std::size_t first_column(std::size_t cell) const;

  std::size_t assertions_;
  std::vector<std::uint32_t> agents_;
  mutable std::mutex mutex_;  // guards what follows
  std::vector<Cell> cells_;
  ValueColumns values_;
};

}  // namespace jaywalk
