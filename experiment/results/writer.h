// SPDX-License-Identifier: Apache-2.0
#pragma once

// Writes the tests of an experiment into a store (docs/reference/store.md has its tables). Any
// number of threads hand in tests; one thread writes them, in one transaction for all tests that
// wait. If the process is killed, every committed test is kept: only tests that were running or
// came in within the last moment are lost.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "experiment/results/description.h"
#include "experiment/results/test_record.h"

namespace jaywalk {

/// Puts the outcome of a test and its recording together. `result` has the values for the measures.
[[nodiscard]] TestRecord make_test_record(const TestKey& test, const TestResult& result,
                                          const TestRun& run, Recording recording);

class ResultsWriter {
 public:
  /// A new store. Errors: the file exists, or its folder does not.
  [[nodiscard]] static Result<std::unique_ptr<ResultsWriter>> create(
      const std::string& path, const ExperimentDescription& description);
  /// Continues a store, perhaps with more tests of each behaviour and number of agents than it was
  /// made for; a new one if there is no file. Errors: a file that is no store, is damaged,
  /// has another version, is in use, or holds another experiment. Such a file is left as it is.
  /// Tests that ended errored are kept, or taken out to be run again.
  enum class ErroredTests { kept, taken_out };
  [[nodiscard]] static Result<std::unique_ptr<ResultsWriter>> resume(
      const std::string& path, const ExperimentDescription& description,
      ErroredTests errored = ErroredTests::kept);

  /// Writes the tests that were handed in, and closes the store as it is.
  ~ResultsWriter();
  ResultsWriter(const ResultsWriter&) = delete;
  ResultsWriter& operator=(const ResultsWriter&) = delete;

  /// The store had the test when it was opened.
  [[nodiscard]] bool had(const TestKey& test) const;
  /// How many it had.
  [[nodiscard]] std::uint64_t had() const;

  /// Takes a test that it had not; waits while too many are waiting to be written. Does nothing
  /// after a failure.
  void add(TestRecord record);

  /// Why nothing more can be written (the disk is full, say); committed tests are kept.
  [[nodiscard]] std::optional<std::string> failure() const;

  /// Writes the remaining tests and makes the store one plain file. Returns why that failed; empty
  /// if it did not. Nothing may be added afterwards.
  [[nodiscard]] std::optional<std::string> finish();

 private:
  class Impl;
  explicit ResultsWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Where the tests of an experiment are kept, and which of them.
struct StoreOptions {
  std::string path;
  /// Empty: that of the store that is continued, or `found`.
  std::optional<StoreLevel> level;
  Shard shard;
  /// Continues the store if it is there; otherwise there must be none.
  bool resume = false;
  /// Tests of a continued store that ended errored are run again.
  bool retry_errors = false;
};

/// A new store of the experiment, or the one to continue; level and shard are those of the options.
/// Errors: as create() and resume().
[[nodiscard]] Result<std::unique_ptr<ResultsWriter>> open_store(const StoreOptions& options,
                                                                ExperimentDescription description);

/// The error about a store that could not be written, for that reason.
[[nodiscard]] Diagnostics unwritten_store(const std::string& path, std::string_view why);

/// Replaces the assessments that a store has of its tests, for `judge --write`.
class AssessmentWriter {
 public:
  [[nodiscard]] static Result<std::unique_ptr<AssessmentWriter>> open(const std::string& path);
  ~AssessmentWriter();
  AssessmentWriter(const AssessmentWriter&) = delete;
  AssessmentWriter& operator=(const AssessmentWriter&) = delete;

  /// Takes note of the files whose assertions the tests are judged by, and whether they are
  /// measured.
  void note_judging(std::span<const SourcePtr> files, bool metrics);
  /// Assessments of the test with other ids stay.
  void replace(std::int64_t test_id, const std::vector<AssessmentRow>& assessments);
  /// Commits all of it, or says why nothing was written.
  [[nodiscard]] std::optional<std::string> finish();

 private:
  class Impl;
  explicit AssessmentWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace jaywalk
