// SPDX-License-Identifier: Apache-2.0
#pragma once

// Maps of agents' choices by a learned policy, by their place relative to the AV. Read report.h
// first.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "experiment/report/facts.h"
#include "experiment/test_run/prepared_scenario.h"

namespace jaywalk::reporting {

/// The choices of one part of a policy.
struct PolicyMap {
  /// P of learned(P), and the labels of its plans.
  std::string part;
  std::vector<std::string> options;
  /// How often each option was chosen in a square of a cell's side: to the right of the ground's
  /// left edge, and ahead of the AV's middle.
  std::map<Square, std::vector<std::uint64_t>> places;
  std::uint64_t choices = 0;
};

/// Which tests are run: of one behaviour with some agents, from a number on.
struct PolicyMapTests {
  std::size_t behaviour = 0;
  std::uint32_t agents = 1;
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// Runs tests of a behaviour that has a policy and returns a map for each used part of the policy.
/// Returns none, without running a test, if tests would start a program or a simulator, which the
/// author of a stored scenario may have chosen.
[[nodiscard]] std::vector<PolicyMap> policy_maps(const PreparedScenario& prepared,
                                                 const PolicyMapTests& tests);

}  // namespace jaywalk::reporting
