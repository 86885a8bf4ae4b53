#pragma once

// One test as a store takes it and gives it back.

#include <cstdint>
#include <string>
#include <vector>

#include "experiment/compare/assessment.h"
#include "experiment/compare/experiment.h"
#include "experiment/compare/summary.h"
#include "experiment/judge/recording.h"
#include "experiment/trial/trial.h"

namespace jaywalk {

struct AgentScore {
  double cost = 0;
  double reward = 0;
  /// How many of its actions were carried out.
  std::uint32_t actions = 0;

  friend bool operator==(const AgentScore&, const AgentScore&) = default;
};

struct TestRecord {
  TestCase test;
  TestResult result;
  TestOutcome outcome;
  /// Of the agents in their order; the agent i is the recording's actor i + 1.
  std::vector<AgentScore> scores;
  std::vector<Assessment> assessments;
  /// Why agents dropped intentions.
  std::vector<AgentDrop> drops;
  /// Everything that was seen. The store keeps actors and events, and scenes as its level says.
  Recording recording;
};

/// Puts the outcome of a trial and its recording together. `result` is what the measures see.
[[nodiscard]] TestRecord make_test_record(const TestCase& test, const TestResult& result,
                                          const TrialResult& trial, Recording recording);

}  // namespace jaywalk
