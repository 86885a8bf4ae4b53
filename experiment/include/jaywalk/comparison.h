// SPDX-License-Identifier: Apache-2.0
#pragma once

// Runs the tests of a scenario: behaviours x numbers of agents x tests, judged, summed up and, if
// wanted, kept in a store. The outcome is a function of scenario and options alone, whatever the
// number of threads.
//
//   const auto report = jaywalk::compare(scenario.value(), {.tests = 100, .store = "runs.gpkg"});
//   for (const jaywalk::ComparisonRow& row : report.value().rows) ... row.measure("accuracy").value

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <jaywalk/judge.h>
#include <jaywalk/measures.h>
#include <jaywalk/scenario.h>

namespace jaywalk {

struct ComparisonOptions {
  /// Nothing: the scenario's.
  std::optional<std::uint64_t> tests;
  std::optional<std::vector<std::uint32_t>> agents;
  std::optional<std::uint64_t> seed;
  /// 1 to 1024.
  unsigned threads = 1;
  /// By what tests are judged; nothing: the scenario's assertions, without metrics.
  std::optional<JudgingRules> rules;
  /// A results store (store.h) that keeps all tests; empty: none.
  std::string store;
  /// A store that exists is continued: only tests that it lacks are run. Else it is an error.
  bool resume = false;
  /// Called some times a second with the tests that are done and that there are; false ends the
  /// run.
  std::function<bool(std::uint64_t done, std::uint64_t total)> progress;
};

/// An assertion's verdicts over the tests of a row.
struct VerdictTally {
  std::string assertion;
  /// In the order of Verdict.
  std::array<std::uint64_t, kVerdictCount> tests{};
};

/// The tests of one behaviour with one number of agents.
struct ComparisonRow {
  std::string behaviour;
  std::uint32_t agents = 0;
  std::uint64_t tests = 0;
  std::uint64_t successes = 0;
  /// Tests that ended errored; measures are of the others.
  std::uint64_t errored = 0;
  /// In the order of measure_list().
  std::vector<Estimate> measures;
  std::vector<VerdictTally> verdicts;

  /// By name; no value if there is no measure of that name.
  [[nodiscard]] Estimate measure(std::string_view name) const;
};

/// How many tests of one behaviour with one number of agents kill a defect of the AV: with the same
/// seed the AV without it breaks no assertion, and with it one that it could have kept.
struct KillTally {
  std::string behaviour;
  std::uint32_t agents = 0;
  /// With its severity: `latency=0.3`.
  std::string defect;
  /// Tests that ended errored are not among them.
  std::uint64_t tests = 0;
  std::uint64_t kills = 0;
  /// In how many tests the AV without the defect is to blame itself; these kill nothing.
  std::uint64_t healthy_failures = 0;
  /// How many tests it takes to kill the defect with a chance of a half, if some test does.
  std::optional<std::uint64_t> first_kill_median;
};

struct ComparisonReport {
  /// In the order of behaviours, then of numbers of agents; those all of whose tests are done.
  std::vector<ComparisonRow> rows;
  /// Of scenarios whose `experiment.defects` names some; those all of whose tests are done.
  std::vector<KillTally> kills;
  /// False if it was ended before all tests were run.
  bool is_complete = true;

  // The files and the page that `jaywalk compare` makes of it, as texts.
  std::string csv;
  std::string json;
};

/// Errors: numbers of agents or tests that the scenario cannot have, a store that cannot be written
/// or holds another experiment, a test that cannot be run.
[[nodiscard]] Result<ComparisonReport> compare(const RunnableScenario& scenario,
                                               const ComparisonOptions& options = {});

}  // namespace jaywalk
