#pragma once

// Failures of the agents of one test: dropped intentions, pedestrians that never acted, and why the
// test ended errored. Read interpreter/agent/drops.h first.

#include <cstdint>
#include <string>
#include <vector>

#include "interpreter/agent/drops.h"

namespace jaywalk {

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
