// SPDX-License-Identifier: Apache-2.0
#pragma once

// The summary of the tests of one behaviour with one number of agents; every measure
// (compare/measures/measures.h) is computed from it.

#include <cstdint>
#include <span>
#include <string>

#include "experiment/compare/measures/statistics.h"
#include "experiment/test_run/test_result.h"

namespace jaywalk {

struct Summary {
  std::string behaviour;
  std::uint32_t agents = 0;
  std::uint64_t tests = 0;
  std::uint64_t successes = 0;
  /// Tests that ended errored; samples and shares of tests are about the others.
  std::uint64_t errored = 0;
  Sample score;  // of the successful tests
  Sample ticks_success;
  Sample ticks_all;
  Sample cpu_us;
  Sample wall_us;
  /// Lines of AgentSpeak of the behaviour, without blank ones and comments.
  std::uint64_t code_lines = 0;

  /// The number of tests that did not end errored.
  [[nodiscard]] std::uint64_t judged() const { return tests - errored; }
};

/// Sums up tests that are not kept: all of them are added twice, in the order of their numbers.
class SummaryMaker {
 public:
  static constexpr int kPasses = 2;

  void add(const TestResult& test);
  void end_pass();
  /// The names are left to the caller. REQUIRES: both passes have ended.
  [[nodiscard]] Summary summary() const;

 private:
  Summary counts_;
  bool counted_ = false;
  SampleMaker score_, ticks_success_, ticks_all_, cpu_us_, wall_us_;
};

/// Sums up tests, which are in the order of their numbers; the names are left to the caller.
[[nodiscard]] Summary summarise(std::span<const TestResult> tests);

}  // namespace jaywalk
