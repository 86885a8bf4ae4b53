#pragma once

// What the tests of one behaviour with one number of agents came to; from it every measure (see
// measures/measures.h) is computed.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiment/statistics.h"

namespace jaywalk {

/// One test, as the measures see it.
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
  /// Of the whole test, in microseconds.
  double wall_us = 0;
};

/// How tests that came to no end of their own are said to have ended.
inline constexpr std::string_view kErrored = "errored";

/// How one test went, beside what the measures see.
struct TestOutcome {
  /// Of the whole test.
  std::uint32_t ticks = 0;
  /// Until the precondition was met, if it was.
  std::optional<std::uint32_t> precondition_ticks;
  /// Why the test ended: `precondition`, `collision`, `road_end`, `time_limit`, `errored`.
  std::string ended_by;
  /// Of the first collision, if there was one, in m/s.
  std::optional<double> impact_mps;

  friend bool operator==(const TestOutcome&, const TestOutcome&) = default;
};

struct Summary {
  std::string behaviour;
  std::uint32_t agents = 0;
  std::uint64_t tests = 0;
  std::uint64_t successes = 0;
  /// Those that ended errored; the samples, and shares of tests, are of the others.
  std::uint64_t errored = 0;
  Sample score;  // of the successful tests
  Sample ticks_success;
  Sample ticks_all;
  Sample cpu_us;
  Sample wall_us;
  /// Lines of AgentSpeak of the behaviour, without blank ones and comments.
  std::uint64_t code_lines = 0;

  /// How many came to an end of their own.
  [[nodiscard]] std::uint64_t judged() const { return tests - errored; }
};

/// Sums up tests that nobody keeps: all of them are added twice, in the order of their numbers.
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
