// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cases of a target, one after the other, in processes that may die of them. Read target.h first.

#include <cstdint>
#include <string>

#include "tests/fuzz/target.h"

namespace jaywalk::fuzz {

/// Processor seconds that one case may take.
inline constexpr int kCaseSeconds = 20;
/// Seconds by the clock: a case that waits for longer hangs.
inline constexpr int kCaseClockSeconds = 120;
/// Memory that one case may take.
inline constexpr std::size_t kCaseMegabytes = 3072;

struct CampaignOptions {
  /// Processor seconds, those of started processes too.
  double seconds = 10;
  /// The number of the first case.
  std::uint64_t first = 0;
  /// The number of cases; 0: no limit.
  std::uint64_t cases = 0;
  /// Where reproducers are written to.
  std::string findings = "fuzz-findings";
};

/// How many cases did harm. Each is named on standard output and written, made smaller, to a folder
/// of its own in `findings`, with what was said on standard error.
[[nodiscard]] int run_campaign(const Target& target, const CampaignOptions& options);

/// The case of that number.
[[nodiscard]] Case make_case(const Target& target, std::uint64_t number);

}  // namespace jaywalk::fuzz
