// SPDX-License-Identifier: Apache-2.0
#pragma once

// Agents' own tests: plans for goals whose label is annotated with `test`. Each runs in a system of
// its own, on virtual time; what its assertion goals found comes back as a report.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "interpreter/coverage/source_coverage.h"
#include "interpreter/support/diagnostics.h"
#include "interpreter/syntax/load.h"

namespace jaywalk {

struct UnitTest {
  /// The program that it is run with; it may stand in a file that this one includes.
  std::string file;
  /// The label, or the goal's name.
  std::string name;
  /// The goal as it is written, "test_sum" or "test_sum(1)".
  std::string goal;
  /// The plan's trigger.
  SourceSpan where;
};

/// The tests of a program, in the order in which they are written. Adds errors of the program.
[[nodiscard]] std::vector<UnitTest> find_unit_tests(const std::string& path,
                                                    const IncludePath& include_path,
                                                    Diagnostics& diagnostics);

struct UnitTestLimits {
  std::uint64_t seed = 0;
  /// Reasoning cycles of one agent.
  std::uint64_t max_cycles = 1'000'000;
  /// Seconds of the wall clock.
  double timeout_s = 60;
  /// Whether coverage of the program is counted.
  bool coverage = false;
};

struct UnitTestReport {
  enum class Verdict {
    passed,
    failed,         // an assertion failed
    broken,         // the test's goal failed, was not achieved, or reached a limit
    no_assertions,  // it is achieved, but has not asserted anything
  };
  struct Failure {
    /// The assertion's name; empty if it was none that failed.
    std::string assertion;
    /// "assert_equals: expected 3, found 4", with the place of the goal.
    Diagnostic what;
  };

  Verdict verdict = Verdict::passed;
  std::uint64_t assertions = 0;
  std::vector<Failure> failures;
  /// The lines that the agents printed and logged.
  std::vector<std::string> output;
  /// Virtual seconds.
  double seconds = 0;
  /// If it was asked for.
  SourceCoverage coverage;

  [[nodiscard]] bool is_failure() const {
    return verdict == Verdict::failed || verdict == Verdict::broken;
  }
};
using UnitTestVerdict = UnitTestReport::Verdict;

/// May be called from several threads at once. `cancelled` is called from time to time: true ends
/// the test.
[[nodiscard]] UnitTestReport run_unit_test(const UnitTest& test, const IncludePath& include_path,
                                           const UnitTestLimits& limits,
                                           std::function<bool()> cancelled = {});

/// JUnit's XML, a suite for each file. Times are virtual, so that it is the same in every run.
[[nodiscard]] std::string junit_xml(const std::vector<UnitTest>& tests,
                                    const std::vector<UnitTestReport>& reports);

}  // namespace jaywalk
