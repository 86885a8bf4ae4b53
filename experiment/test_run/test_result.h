// SPDX-License-Identifier: Apache-2.0
#pragma once

// The result of one test: the values for the measures, and other outcomes to report, failures of
// its agents among them. Read interpreter/agent/drops.h first.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/agent/drops.h"

namespace jaywalk {

/// The values of one test that the measures use.
struct TestResult {
  bool succeeded = false;
  /// It came to no end of its own: an agent looped or stopped the system, a limit was reached, the
  /// AV's controller failed (TestTroubles::error says why). Nothing else of it counts.
  bool errored = false;
  std::uint32_t ticks = 0;
  /// The mean over the test's agents, of costs and rewards.
  double score = 0;
  /// Spent by the agents reasoning, in microseconds.
  double cpu_us = 0;
  /// Wall time of the whole test, in microseconds.
  double wall_us = 0;
};

/// How tests that came to no end of their own are said to have ended.
inline constexpr std::string_view kErrored = "errored";

/// The outcome of one test, beside the values for the measures.
struct TestOutcome {
  /// Ticks of the whole test.
  std::uint32_t ticks = 0;
  /// Until the precondition was met, if it was.
  std::optional<std::uint32_t> precondition_ticks;
  /// Why the test ended: `precondition`, `collision`, `road_end`, `time_limit`, `errored`.
  std::string ended_by;
  /// Speed of the first collision, if there was one, in m/s.
  std::optional<double> impact_mps;

  friend bool operator==(const TestOutcome&, const TestOutcome&) = default;
};

/// An agent of one test has dropped intentions for that reason.
struct AgentDrop {
  /// The number in recordings: agents are numbered from 1, the pedestrians first.
  std::uint32_t actor = 0;
  DropCause cause;
};

/// The troubles of one test.
struct TestTroubles {
  std::uint64_t agents = 0;
  std::uint64_t pedestrians = 0;
  /// Pedestrians none of whose actions was carried out.
  std::uint64_t idle = 0;
  /// In the order of the agents.
  std::vector<AgentDrop> drops;
  /// Why, and where, the test ended errored; empty if it did not.
  std::string error;
};

}  // namespace jaywalk
