// SPDX-License-Identifier: Apache-2.0
#pragma once

// Looks for inputs under which a system under test fails: generators are asked for an input, the
// system executes it, the generator receives its fitness, until the budget is spent. A YAML file
// describes a search (docs/reference/search.md), or a program does, with systems and generators of
// its own. Results depend on no thread.
//
//   using jaywalk::search::RunnableSearch;
//   const auto search = RunnableSearch::read("scenarios/search/lane-keeping.yaml");
//   const auto report = search.value().run({.threads = 4, .store = "search.gpkg"});

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <jaywalk/diagnostics.h>
#include <jaywalk/generator.h>
#include <jaywalk/interpreter.h>
#include <jaywalk/system.h>

namespace jaywalk::search {

struct SearchExperiment;

/// Which part of a search's file is used, and what replaces its values: the command's options.
struct SearchChoice {
  /// `dotted.path=value`, in order, as given to `--set`.
  std::vector<std::string> sets;
  /// Names of the file's generators or of kinds: these and no others. Empty: all of the file.
  std::vector<std::string> generators;
  /// Where programs of agents find what they include.
  ProgramFolders folders;
  /// The folder of what is installed with Jaywalk (ScenarioChoice::data_folder).
  std::string data_folder;
};

/// A search that a program describes.
struct SearchDescription {
  std::string name;
  SystemUnderTest system;
  /// The measure that fitness is about, one of the system's. Of values `harmless` and beyond the
  /// fitness is 0, of `worst`, another value, and beyond it is 1; a test fails at `fails_at` or
  /// more, above 0 and up to 1.
  std::string measure;
  double harmless = 0;
  double worst = 1;
  double fails_at = 0.95;
  /// Names of generator_list(), and generators of your own; at least one.
  std::vector<std::string> generators;
  std::vector<CustomGenerator> custom_generators;
  /// A search ends after `tests` tests (0: no limit), or when its virtual time is spent,
  /// simulated seconds and `overhead_s` for each test.
  std::uint64_t tests = 0;
  double virtual_s = 7200;
  double overhead_s = 15;
};

struct SearchProgressNow {
  std::uint64_t tests = 0;
  std::uint64_t failures = 0;
  /// The share of all budgets that is spent, 0 to 1.
  double spent = 0;
};

struct SearchRunOptions {
  /// Nothing: the file's, or 0 and 1.
  std::optional<std::uint64_t> seed;
  std::optional<std::uint32_t> repetitions;
  /// 1 to 1024.
  unsigned threads = 1;
  /// A store that keeps all tests of a search that was read from a file; empty: none.
  std::string store;
  /// A store that exists is continued; else it is an error.
  bool resume = false;
  /// Called some times a second and at the end; false ends everything.
  std::function<bool(const SearchProgressNow& now)> progress;
};

/// A test that was executed.
struct FoundTest {
  /// The numbers that the generator gave, and what they stand for: x and y of each road point, in
  /// metres, or the numbers of a scenario.
  std::vector<double> input;
  std::vector<double> points;
  double fitness = 0;
  bool has_failed = false;
  /// Why it has no result; empty if it has one or was refused.
  std::string error;
  /// Why the system refused it as invalid: it counts as a candidate, not as a test. Else empty.
  std::string refused;
  /// In the order of RunnableSearch::measures.
  std::vector<double> measures;
  double simulated_s = 0;
};

/// One generator, one repetition.
struct SearchRunReport {
  std::string generator;
  std::uint32_t repetition = 0;
  std::vector<FoundTest> tests;
  /// Virtual seconds.
  double spent_s = 0;
  bool is_complete = false;

  [[nodiscard]] std::size_t failures() const;
};

struct SearchReport {
  /// By generator, then by repetition.
  std::vector<SearchRunReport> runs;
  /// Why a search could not go on (no valid input, say).
  Diagnostics trouble;
  bool is_complete = false;
};

/// Immutable and cheap to copy.
class RunnableSearch {
 public:
  /// Errors have their places in the file.
  [[nodiscard]] static Result<RunnableSearch> read(const std::string& path,
                                                   const SearchChoice& choice = {});
  [[nodiscard]] static Result<RunnableSearch> parse(const std::string& name, std::string text,
                                                    const SearchChoice& choice = {});
  /// Errors: no measure or generator of that name, something that is required is missing.
  [[nodiscard]] static Result<RunnableSearch> make(const SearchDescription& description);

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] std::vector<std::string> generators() const;
  [[nodiscard]] std::vector<std::string> measures() const;

  /// Errors: the store cannot be written, or holds another search.
  [[nodiscard]] Result<SearchReport> run(const SearchRunOptions& options = {}) const;

 private:
  struct Parts;
  explicit RunnableSearch(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
  std::shared_ptr<const Parts> parts_;
};

}  // namespace jaywalk::search
