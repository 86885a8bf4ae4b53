// SPDX-License-Identifier: Apache-2.0
#pragma once

// The system under test (SUT): executes a test input and returns its measures. A row of suts.def
// and a file of suts/ for each kind. Read test_input.h first.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiment/judge/situations/situations.h"
#include "search/test_input.h"
#include <jaywalk/diagnostics.h>

namespace jaywalk {

struct Scenario;
}
namespace jaywalk::lane {
struct DriveSettings;
}

namespace jaywalk::search {

class RoadSpace;

/// The outcome of one execution.
struct Outcome {
  /// Why the SUT has no result (it crashed, hung, answered nonsense); empty if it has one.
  std::string error;
  /// Time that passed in the simulation.
  double simulated_s = 0;
  /// In the order of the SUT's measures; empty if there is no result.
  std::vector<double> measures;
  /// Numbers whose Euclidean distance says how differently two tests went; empty: how different
  /// their inputs are says it (SearchSpace::signature).
  std::vector<double> signature;
  /// Why the SUT refuses the input, which breaks a constraint that only the SUT knows. Such a test
  /// has no result either, but counts as an invalid candidate instead of as a test. Empty: it does
  /// not.
  std::string refused;

  [[nodiscard]] bool executed() const { return error.empty() && refused.empty(); }
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Why an outcome makes no sense, in the words of its source, which calls the time `time` and has
/// these measures: a time or a measure that is not a number, or absurd. Empty: it makes sense.
[[nodiscard]] std::string why_nonsense(const Outcome& outcome, std::string_view time,
                                       const std::vector<std::string>& measures);

/// One number that a SUT measures of each test.
struct MeasureKind {
  std::string_view name;
  std::string_view meaning;
  /// The defaults of a fitness that is this measure (Fitness).
  double harmless = 0;
  double worst = 1;
  double fails_at = 0.95;
  /// The requirement whose robustness it is: the test violated it if that is below 0. Empty: none.
  std::string_view requirement = {};
};

/// Something that a SUT is set to, in words for people.
struct SutSetting {
  std::string name;
  std::string value;
};

/// Belongs to one search; it may keep a process or a simulation from one test to the next.
class Sut {
 public:
  Sut() = default;
  Sut(const Sut&) = delete;
  Sut& operator=(const Sut&) = delete;
  virtual ~Sut() = default;

  /// `test`: the test's number in its search, from 0, for protocols and messages.
  /// REQUIRES: a valid input of its space.
  [[nodiscard]] virtual Outcome run(const TestInput& input, std::size_t test) = 0;
  /// A test of the same search that an earlier process ran, for measures that depend on the tests
  /// before.
  virtual void remember(const Outcome& /*outcome*/) {}

  /// From now on a test may be given up as soon as that is true: its outcome has an error then, and
  /// is not kept.
  void stop_when(std::function<bool()> stopped) { stopped_ = std::move(stopped); }

 protected:
  /// Empty: nothing stops a test.
  [[nodiscard]] const std::function<bool()>& stopped() const { return stopped_; }

 private:
  std::function<bool()> stopped_;
};

/// A SUT as an experiment describes it: immutable, shared by all searches.
class SutModel {
 public:
  SutModel() = default;
  SutModel(const SutModel&) = delete;
  SutModel& operator=(const SutModel&) = delete;
  virtual ~SutModel() = default;

  [[nodiscard]] virtual const SearchSpace& space() const = 0;
  [[nodiscard]] virtual std::span<const MeasureKind> measures() const = 0;
  [[nodiscard]] virtual std::unique_ptr<Sut> make() const = 0;
  /// The most important ones first.
  [[nodiscard]] virtual std::vector<SutSetting> settings() const = 0;
  /// The same space if it is one of roads, which have pictures and exports; else null.
  [[nodiscard]] virtual const RoadSpace* road_space() const { return nullptr; }
  /// The texts of all files that its tests are made from.
  [[nodiscard]] virtual std::vector<SourcePtr> inputs() const { return {}; }
  /// The scenario whose tests it runs; null if it runs none.
  [[nodiscard]] virtual const Scenario* scenario() const { return nullptr; }
  /// The defects of its AV that the experiment asks for, by name, and the system with one of them
  /// (search_kills.h); empty and null if it has none.
  [[nodiscard]] virtual std::vector<std::string> defects() const { return {}; }
  [[nodiscard]] virtual std::shared_ptr<const SutModel> with_defect(std::size_t /*index*/) const {
    return nullptr;
  }
  /// The words of the program that executes its tests; none if it is no program of the user's.
  [[nodiscard]] virtual std::vector<std::string> command() const { return {}; }
  /// How many pedestrians take part; 0 if none do.
  [[nodiscard]] virtual std::uint32_t agents() const { return 0; }
  /// How the car drives if this program simulates it; else null.
  [[nodiscard]] virtual const lane::DriveSettings* drive() const { return nullptr; }
};

/// The measures that are the robustness of a requirement, by their indices.
[[nodiscard]] std::vector<std::size_t> requirements_of(std::span<const MeasureKind> measures);

/// The index of a measure of that name, if there is one.
[[nodiscard]] std::optional<std::size_t> find_measure(std::span<const MeasureKind> measures,
                                                      std::string_view name);

/// The fitness that a search maximises: one measure of the SUT, scaled so that 0 is harmless and 1
/// the worst.
struct Fitness {
  /// Index into the SUT's measures.
  std::size_t measure = 0;
  /// Values of the measure whose fitness is 0 and 1; beyond them it is 0 and 1 too.
  double harmless = 0;
  double worst = 1;
  /// A test fails if its fitness is at least this.
  double fails_at = 0.95;

  /// 0 if there is no result.
  [[nodiscard]] double of(const Outcome& outcome) const;
  [[nodiscard]] bool fails(double fitness) const { return fitness >= fails_at; }
};

/// A test that was executed.
struct ExecutedTest {
  TestInput input;
  Outcome outcome;
  double fitness = 0;
  bool failed = false;
};

/// The names of measures that say which situations (experiment/judge/situations/situations.h) a
/// test met: `bin_ITEM` for each item, in their order.
[[nodiscard]] std::vector<std::string> situation_measures();

/// Appends a test's measures of these: the number of the bin that it met, from 1; 0: none.
void add_situations(const SituationBins& bins, std::vector<double>& measures);

/// Reads add_situations' measures back; nothing if the SUT does not measure situations. A test
/// without a result met none.
[[nodiscard]] std::optional<SituationBins> situation_bins(const Outcome& outcome,
                                                          std::span<const MeasureKind> measures);

}  // namespace jaywalk::search
