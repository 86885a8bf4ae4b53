// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loop: a generator is asked for a test input, the SUT executes it, the generator receives its
// fitness, until the budget is spent. Many such searches run in parallel, and none depends on
// another one or on the number of threads. Read generator.h and sut.h first.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/support/diagnostics.h"
#include "search/generator.h"
#include "search/sut.h"

namespace jaywalk::search {

/// A search ends when the first of them is used up. 0: not limited. Tests and virtual time cannot
/// both be unlimited. Tests that the SUT refuses cost nothing.
struct Budget {
  std::uint64_t tests = 0;
  std::uint64_t failures = 0;
  /// The budget of virtual time: for each test the simulated time, the overhead (starting the
  /// simulator, loading the road) and a constant for generating it. Real time would make results
  /// depend on the machine. The test that goes beyond the budget does not count. Without overhead,
  /// simulated time alone counts, as in the SBST tool competition; a search whose tests take no
  /// time at all is given up.
  double virtual_s = 7200;
  double overhead_s = 15;
  double generation_s = 0;
};

/// A generator with its settings, under a name of its own.
struct GeneratorSpec {
  std::string name;
  const GeneratorKind* kind = nullptr;
  std::vector<double> values;
  /// The cost of generating each of its tests, in virtual seconds; none: the budget's.
  std::optional<double> generation_s = std::nullopt;
  /// The SUT that it searches; null: the plan's. So behaviours or controllers are compared, too.
  std::shared_ptr<const SutModel> model = nullptr;
  /// The name of several that differ in the AV's defect alone, and the index of that defect among
  /// those of the SUT. Empty: it is the only one.
  std::string family = {};
  std::size_t defect = 0;

  /// From which the seed of its searches derives.
  [[nodiscard]] const std::string& seed_name() const { return family.empty() ? name : family; }
};

struct SearchPlan {
  std::shared_ptr<const SutModel> model;
  Fitness fitness;
  Budget budget;
  std::vector<GeneratorSpec> generators;
  std::uint32_t repetitions = 1;
  std::uint64_t seed = 0;
  /// REQUIRES: at least 1.
  unsigned threads = 1;

  [[nodiscard]] const SutModel& model_of(const GeneratorSpec& generator) const {
    return generator.model ? *generator.model : *model;
  }
  [[nodiscard]] double generation_s(const GeneratorSpec& generator) const {
    return generator.generation_s.value_or(budget.generation_s);
  }
  [[nodiscard]] std::size_t searches() const { return generators.size() * repetitions; }
};

/// A test and the cost of finding it.
struct TestRow {
  ExecutedTest test;
  std::uint64_t candidates = 0;
  std::uint64_t invalid = 0;
  /// The real time of generating it, for information.
  double generation_s = 0;
  double execution_s = 0;
};

/// One generator, one repetition.
struct SearchRun {
  std::string generator;
  std::uint32_t repetition = 0;
  std::uint64_t seed = 0;
  std::vector<TestRow> tests;
  /// Virtual seconds spent.
  double spent_s = 0;
  bool complete = false;
};

enum class Continue { yes, no };

/// Keeps finished tests while searches run. Called from several threads at once.
class TestLog {
 public:
  TestLog() = default;
  TestLog(const TestLog&) = delete;
  TestLog& operator=(const TestLog&) = delete;
  virtual ~TestLog() = default;

  /// The tests that an earlier process finished; they are not executed again. `search`: the index
  /// of the generator times the repetitions plus the repetition.
  [[nodiscard]] virtual const std::vector<TestRow>& finished(std::size_t search) const = 0;
  /// No if nothing more can be kept: all searches end then.
  [[nodiscard]] virtual Continue add(std::size_t search, std::size_t number,
                                     const TestRow& row) = 0;
};

struct SearchProgress {
  std::uint64_t tests = 0;
  std::uint64_t failures = 0;
  std::uint64_t errors = 0;
  double best_fitness = 0;
  /// The share of all budgets spent, 0 to 1.
  double spent = 0;
};

struct SearchObserver {
  /// Called from one thread some times a second and at the end; may end everything.
  std::function<Continue(const SearchProgress&)> progress;
  /// Called for each test that has no result, from any thread, one at a time. Tests of a search are
  /// numbered from 0.
  std::function<void(const std::string& generator, std::uint32_t repetition, std::size_t test,
                     const std::string& error)>
      error;
  /// Called once for each search that has come to its end, from any thread, several at once; it may
  /// drop the tests, of which there can be very many.
  std::function<void(std::size_t search, SearchRun& run)> finished;
};

struct SearchResults {
  /// In the order of the plan: by generator, then by repetition.
  std::vector<SearchRun> runs;
  /// Why a search could not go on (no valid input, say), if any. Of tests that could not be kept
  /// the log says why.
  Diagnostics trouble;
  bool complete = false;
};

/// `log` may be null.
[[nodiscard]] SearchResults run_searches(const SearchPlan& plan, TestLog* log,
                                         const SearchObserver& observer = {});

}  // namespace jaywalk::search
