// SPDX-License-Identifier: Apache-2.0
#pragma once

// The results of a comparison as they are shown and written: by report/ as a table or a picture, by
// export/ as files.

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/compare/avs/av_ranking.h"
#include "experiment/compare/kills/kills.h"
#include "experiment/compare/published/published.h"
#include "experiment/compare/summary.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/compare/troubles.h"

namespace jaywalk {

struct Comparison {
  /// The scenario's file, as given by the user.
  std::string scenario;
  std::uint64_t seed = 0;
  std::uint64_t tests = 0;
  /// In the order of behaviours, then of the numbers of agents.
  std::vector<Summary> summaries;
  /// The summaries beside which the paper's figures may be shown.
  PublishedRows published;
  /// The ids of the judged assertions, and the verdicts and metrics of each of the summaries; empty
  /// if none were asked for.
  std::vector<std::string> assertions;
  std::vector<AssessmentSummary> assessments;
  /// The kills of the tests with defective AVs; empty without such tests.
  KillMatrix kills;
  /// How models of the AV rank; empty unless several were compared.
  AvRanking avs;
  /// The failures of the agents of each of the summaries.
  std::vector<Troubles> troubles;
  /// False if the user ended it before all of its tests were run.
  bool complete = true;
};

/// Sets the assessments of the comparison's summaries from the table. `behaviours` are those of the
/// table's plan.
void add_assessments(const Criteria& criteria, const AssessmentTable& assessments,
                     const std::vector<std::string>& behaviours, Comparison& comparison);

}  // namespace jaywalk
