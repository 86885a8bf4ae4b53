// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads a results store, the GeoPackage file in which `compare` keeps tests
// (docs/reference/store.md has its tables). A store holds the texts of its scenario and programs,
// so that any test can be looked at, and run again, on any machine. Nothing is written.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <jaywalk/comparison.h>

namespace jaywalk {

class ResultsReader;

/// A line of the list of tests.
struct TestLine {
  /// The number under which the store keeps it, from 1 in the order of the plan.
  std::int64_t id = 0;
  std::string behaviour;
  std::uint32_t agents = 0;
  std::uint64_t test = 0;  // from 0
  std::string vehicle;
  bool succeeded = false;
  bool errored = false;
  std::string ended_by;
  std::uint32_t ticks = 0;
  double score = 0;
};

/// Which tests are wanted; empty fields: any. The vehicle is the first one.
struct TestLines {
  std::optional<std::string> behaviour;
  std::optional<std::uint32_t> agents;
  std::optional<bool> succeeded;
  std::optional<bool> errored;
};

/// Belongs to one thread; several may read the same file.
class ResultsStore {
 public:
  /// Errors: no file, no store, another version of the tables, damaged, being written.
  [[nodiscard]] static Result<ResultsStore> open(const std::string& path);
  ResultsStore(ResultsStore&&) noexcept;
  ResultsStore& operator=(ResultsStore&&) noexcept;
  ~ResultsStore();

  /// How many tests it has, and whether these are all of the experiment.
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] bool is_complete() const;

  /// Calls back for each test, in the order of ids; false ends that. Errors: no such behaviour, or
  /// something could not be read.
  [[nodiscard]] std::optional<Diagnostics> for_each_test(
      const TestLines& wanted, const std::function<bool(const TestLine& test)>& callback) const;
  /// All that was seen of a test, with the verdicts that the store's assertions give. A test whose
  /// scenes the store has not kept is run again. Errors: there is no such test, its outcome differs
  /// from the stored one, or a command of the store's author would be started.
  [[nodiscard]] Result<TestReport> test(std::int64_t id) const;
  /// The summary of the tests.
  [[nodiscard]] Result<ComparisonReport> comparison() const;

 private:
  explicit ResultsStore(std::unique_ptr<ResultsReader> reader);
  std::unique_ptr<ResultsReader> reader_;
};

}  // namespace jaywalk
