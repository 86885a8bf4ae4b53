// SPDX-License-Identifier: Apache-2.0
#pragma once

// A row for each test of a comparison, for your own calculations: how it ended, when its
// precondition was met, whether there was a collision, the verdicts.

#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/summary.h"
#include "experiment/compare/test_assessment.h"

namespace jaywalk {

/// How such a table is written. Columns: behaviour, agents, vehicle (only if there are several),
/// test, ended_by, ticks, precondition_ticks (empty: not met), collision (0, 1), impact_mps (empty:
/// none), and each assertion's verdict (empty of a test that ended errored).
class PerTestLines {
 public:
  /// `assertions`: their ids, in the order of the verdicts.
  PerTestLines(const ExperimentPlan& plan, std::vector<std::string> assertions);

  [[nodiscard]] std::string header() const;
  [[nodiscard]] std::string line(const TestKey& test, const TestOutcome& outcome,
                                 std::span<const Verdict> verdicts) const;

 private:
  ExperimentPlan plan_;
  std::vector<std::string> assertions_;
};

[[nodiscard]] std::vector<Verdict> verdicts_of(const TestAssessment& assessment);

/// Collects tests from several threads; the table depends on the tests alone.
class PerTestTable {
 public:
  /// `assertions`: their ids, in the order of the verdicts.
  PerTestTable(const ExperimentPlan& plan, std::vector<std::string> assertions);

  /// REQUIRES: a test of the plan, numbered from 0; each once.
  void add(const TestKey& test, const TestOutcome& outcome, const TestAssessment& assessment);

  /// A header line and a line for each test, in the order of the plan. REQUIRES: no thread adds at
  /// the same time.
  [[nodiscard]] std::string csv() const;

 private:
  struct Row {
    TestKey test;
    TestOutcome outcome;
    std::vector<Verdict> verdicts;
  };

  ExperimentPlan plan_;
  PerTestLines lines_;
  std::mutex mutex_;
  std::vector<Row> rows_;
};

}  // namespace jaywalk
