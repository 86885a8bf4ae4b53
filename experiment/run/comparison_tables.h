// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tables that are filled while the tests of a comparison run, beside the tests' results.

#include <cstdint>
#include <memory>
#include <optional>

#include "experiment/compare/avs/av_ranking.h"
#include "experiment/compare/carry_over.h"
#include "experiment/compare/feedback.h"
#include "experiment/compare/first_tests.h"
#include "experiment/compare/kills/kills.h"
#include "experiment/compare/per_test.h"
#include "experiment/compare/situation_table.h"
#include "experiment/compare/troubles.h"
#include "experiment/run/run_comparison.h"
#include "experiment/test_run/controller_notes.h"

namespace jaywalk {

struct ComparisonTables {
  /// REQUIRES: the request outlives it.
  explicit ComparisonTables(const ComparisonRequest& request)
      : first_tests(request.plan),
        assessments(request.criteria, request.plan),
        kills(request.plan, request.plan.tests),
        avs(request.plan, request.plan.tests),
        troubles(request.plan) {
    const std::uint64_t generation = request.prepared->scenario().experiment.feedback;
    if (request.situations || generation > 0) situations.emplace(request.plan);
    if (generation > 0) feedback.emplace(request.plan, generation, *situations);
    if (request.per_test && !request.store) {
      per_test = std::make_unique<PerTestTable>(request.plan, ids_of(request.criteria));
    }
    if (request.plan.order == TestOrder::chained) carry_over.emplace(request.plan);
  }

  FirstTests first_tests;
  AssessmentTable assessments;
  KillTable kills;
  AvTable avs;
  TroublesTable troubles;
  ControllerNotes notes;
  /// Empty unless asked for, or needed for feedback.
  std::optional<SituationTable> situations;
  std::optional<CoverageFeedback> feedback;
  std::optional<CarryOver> carry_over;
  std::unique_ptr<PerTestTable> per_test;
};

/// Adds what later tests need of the tests that a store to be continued has: whether all of the
/// first ones are errored, what they have covered, and the cells that they have left over. Errors:
/// that cannot be read.
[[nodiscard]] Diagnostics add_earlier_tests(const ComparisonRequest& request,
                                            const ExperimentDescription& description,
                                            ComparisonTables& tables);

}  // namespace jaywalk
