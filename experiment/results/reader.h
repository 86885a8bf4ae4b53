// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads a store: its experiment, its tests and their recordings. Nothing is written. A reader
// belongs to one thread; several may read the same file.
//
//   Result<std::unique_ptr<ResultsReader>> store = ResultsReader::open("runs.gpkg");
//   for (const StoredTest& test : store.value()->tests().value()) ...

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/compare/comparison.h"
#include "experiment/results/description.h"
#include "experiment/results/test_record.h"
#include "experiment/scenario/files/write_file.h"

namespace jaywalk {

/// A line of the list of tests.
struct StoredTest {
  std::int64_t id = 0;
  TestKey test;
  TestResult result;
  TestOutcome outcome;
  /// How many of its scenes the store has; with none the test is run again when they are asked for.
  std::uint32_t scenes = 0;
};

/// Which tests are wanted; empty fields: any.
struct TestFilter {
  /// Index into the description's vehicles; the tests of the measures unless another is named.
  std::optional<std::size_t> vehicle = 0;
  /// Index into the description's behaviours.
  std::optional<std::size_t> behaviour;
  std::optional<std::uint32_t> agents;
  std::optional<bool> succeeded;
  std::optional<bool> errored;
  /// The most tests; the first ones are taken.
  std::optional<std::uint64_t> limit;
};

/// Whether tests that are run again may start the command that the stored scenario names (a custom
/// AV): the store's author chose it.
enum class Commands { refused, allowed };

class ResultsReader {
 public:
  /// Errors: no file, no store, another version of the store's tables, tables that are not a
  /// store's, damaged. A store that is being written cannot be read.
  [[nodiscard]] static Result<std::unique_ptr<ResultsReader>> open(
      const std::string& path, Commands commands = Commands::refused);
  ~ResultsReader();
  ResultsReader(const ResultsReader&) = delete;
  ResultsReader& operator=(const ResultsReader&) = delete;

  /// From now on reading fails, and tests that are run again are given up, as soon as that is true;
  /// it is called from time to time.
  void stop_when(std::function<bool()> stopped);

  [[nodiscard]] const std::string& path() const;
  [[nodiscard]] const ExperimentDescription& description() const;
  /// How many tests it has; those of its shard are tests_in_shard() x behaviours x agents.
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] bool complete() const;

  /// In the order of their ids, which is that of the plan.
  [[nodiscard]] Result<std::vector<StoredTest>> tests(const TestFilter& filter = {}) const;
  /// Calls back for each test, until the callback has enough, so that there may be millions. The
  /// error is what could not be read.
  [[nodiscard]] std::optional<Diagnostics> for_each_test(
      const TestFilter& filter, const std::function<Proceed(const StoredTest&)>& callback) const;
  /// How many of them there are.
  [[nodiscard]] Result<std::uint64_t> count(const TestFilter& filter) const;
  /// Error: there is no such test.
  [[nodiscard]] Result<StoredTest> test(std::int64_t id) const;
  /// Why the test ended errored; empty if it did not.
  [[nodiscard]] Result<std::string> error(std::int64_t id) const;
  [[nodiscard]] Result<std::vector<AgentScore>> scores(std::int64_t id) const;
  [[nodiscard]] Result<std::vector<AssessmentRow>> assessments(std::int64_t id) const;
  /// The actors of the test; the first is the AV.
  [[nodiscard]] Result<std::vector<Actor>> actors(std::int64_t id) const;

  /// Calls back for each event of that kind which has a place, in the order of the tests. The
  /// error is what could not be read.
  [[nodiscard]] std::optional<Diagnostics> for_each_place(
      std::string_view kind,
      const std::function<void(const TestKey& test, double x_m, double y_m)>& callback) const;
  /// Calls back for each test that has assessments, in the order of the tests.
  [[nodiscard]] std::optional<Diagnostics> for_each_assessed(
      const std::function<void(const TestKey& test, const std::vector<AssessmentRow>& assessments)>&
          callback) const;
  /// The ids of all assertions that any test was judged by.
  [[nodiscard]] Result<std::vector<std::string>> assertion_ids() const;

  /// Everything that was seen of the test, from the store or, where that has no scenes, by running
  /// the test again. Error: it came out otherwise than stored (see rerun).
  [[nodiscard]] Result<Recording> recording(std::int64_t id) const;

  /// The scenario as it was, made ready to run from the texts in the store, not from files; made
  /// once, then kept.
  [[nodiscard]] Result<std::shared_ptr<const PreparedScenario>> prepared() const;
  /// The assertions by which its tests were judged: those of the files of `--assertions`, or else
  /// the scenario's.
  [[nodiscard]] Result<std::vector<Assertion>> assertions() const;
  /// The setup of a test: `run_test(*prepared, setup)` repeats it. Error: it would start a command,
  /// which is refused.
  [[nodiscard]] Result<TestSetup> setup(std::int64_t id) const;
  /// Runs a test again, with the caller's options; a test that ended errored has to do so again,
  /// perhaps with another error. Error: its outcome differs from the stored one, as when another
  /// version of the program wrote the store.
  [[nodiscard]] Result<TestRun> rerun(std::int64_t id, const TestOptions& options = {}) const;

  /// The summary of the tests: rows whose tests (those of the shard) are all there, with what
  /// assertions and metrics say of them, if the store has that.
  [[nodiscard]] Result<Comparison> comparison() const;

 private:
  class Impl;
  [[nodiscard]] Result<Summary> summary_of(std::size_t behaviour, std::uint32_t agents) const;
  [[nodiscard]] std::optional<Diagnostics> add_assessments(Comparison& comparison) const;
  [[nodiscard]] std::optional<Diagnostics> add_avs(Comparison& comparison) const;
  explicit ResultsReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Its tests one by one, as PerTestTable::csv has them, piece by piece.
[[nodiscard]] std::optional<Diagnostics> write_per_test_table(const ResultsReader& store,
                                                              const TextSink& sink);

}  // namespace jaywalk
