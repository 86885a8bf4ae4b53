// SPDX-License-Identifier: Apache-2.0
#pragma once

// One test in the form in which a store takes it and returns it.

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/compare/experiment.h"
#include "experiment/compare/summary.h"
#include "experiment/compare/test_assessment.h"
#include "experiment/judge/recording.h"
#include "experiment/test_run/test_run.h"

namespace jaywalk {

struct AgentScore {
  double cost = 0;
  double reward = 0;
  /// How many of its actions were carried out.
  std::uint32_t actions = 0;

  friend bool operator==(const AgentScore&, const AgentScore&) = default;
};

struct TestRecord {
  TestKey test;
  TestResult result;
  TestOutcome outcome;
  /// The agents' scores in their order; agent i is the recording's actor i + 1.
  std::vector<AgentScore> scores;
  std::vector<AssessmentRow> assessments;
  /// Why agents dropped intentions.
  std::vector<AgentDrop> drops;
  /// Everything that was seen. The store keeps actors and events, and scenes as its level says.
  Recording recording;
};

}  // namespace jaywalk
