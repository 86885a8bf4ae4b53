#pragma once

// Runs the tests of `compare`: selects them, judges each and reports it to the listeners.

#include <functional>
#include <memory>
#include <optional>

#include "experiment/compare/avs/av_ranking.h"
#include "experiment/compare/carry_over.h"
#include "experiment/compare/feedback.h"
#include "experiment/compare/first_tests.h"
#include "experiment/compare/kills/kills.h"
#include "experiment/compare/per_test.h"
#include "experiment/report/facts.h"
#include "experiment/results/writer.h"
#include "experiment/test_run/controller_notes.h"
#include "tools/jaywalk/comparison/compare_request.h"
#include "tools/jaywalk/run/trace_output.h"

namespace jaywalk::command::compare {

/// Tables that are filled while tests run, beside the tests' results.
struct Collected {
  explicit Collected(const Request& request)
      : first_tests(request.plan),
        assessments(request.criteria, request.plan),
        kills(request.plan, request.plan.tests),
        avs(request.plan, request.plan.tests),
        troubles(request.plan),
        situations(request.plan) {
    const std::uint64_t generation = request.prepared->scenario().experiment.feedback;
    if (generation > 0) feedback.emplace(request.plan, generation, situations);
    if (request.per_test && !request.store) {
      per_test = std::make_unique<PerTestTable>(request.plan, ids_of(request.criteria));
    }
    if (request.plan.order == TestOrder::chained) carry_over.emplace(request.plan);
  }

  FirstTests first_tests;
  AssessmentTable assessments;
  KillTable kills;
  AvTable avs;
  TroublesTable troubles;
  SituationTable situations;
  ControllerNotes notes;
  /// Null unless a row for each test is asked for and no store keeps the tests.
  std::unique_ptr<PerTestTable> per_test;
  std::optional<CoverageFeedback> feedback;
  std::optional<CarryOver> carry_over;
};

/// Observers of the tests as they are run; null: none.
struct Listeners {
  Collected& collected;
  ResultsWriter* store = nullptr;
  reporting::FactsTable* facts = nullptr;
  TraceFile* trace = nullptr;
  /// Polled in the middle of tests; true abandons them.
  std::function<bool()> interrupted;
};

/// The tests to run: all of the shard, or those that the store does not have yet.
class Selection {
 public:
  Selection(const Request& request, const ResultsWriter* store);

  [[nodiscard]] bool has(const TestKey& test) const {
    return in_shard(test) && (store_ == nullptr || !store_->had(test));
  }
  [[nodiscard]] bool in_shard(const TestKey& test) const { return shard_.has(test.number); }
  /// The number of selected tests.
  [[nodiscard]] std::uint64_t size() const { return wanted_; }

 private:
  const ResultsWriter* store_;
  Shard shard_;
  std::uint64_t wanted_ = 0;
};

/// Runs the selected tests; progress counts these alone.
[[nodiscard]] ExperimentOutcome run_selection(const Request& request, const Selection& selection,
                                              const Listeners& listeners,
                                              const ProgressFunction& progress);

/// Adds what later tests need of the tests that a store to be continued has: whether all of the
/// first ones are errored, what they have covered, and the cells that they have left over. False
/// after reporting why that cannot be read.
[[nodiscard]] bool add_earlier_tests(const Request& request, Collected& collected,
                                     Console& console);

}  // namespace jaywalk::command::compare
