#pragma once

// The tests of `compare` as they are run: which ones, what is found out about each, and who is
// told.

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

/// What is collected while tests run, beside their results.
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
  /// Empty: not wanted.
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
  /// Asked in the middle of tests; true gives them up.
  std::function<bool()> interrupted;
};

/// What is to be run: everything, or what the store wants and does not have.
class Selection {
 public:
  Selection(const Request& request, const ResultsWriter* store);

  [[nodiscard]] bool has(const TestKey& test) const {
    return in_shard(test) && (store_ == nullptr || !store_->had(test));
  }
  [[nodiscard]] bool in_shard(const TestKey& test) const { return shard_.has(test.number); }
  /// How many tests it has.
  [[nodiscard]] std::uint64_t size() const { return wanted_; }

 private:
  const ResultsWriter* store_;
  Shard shard_;
  std::uint64_t wanted_ = 0;
};

/// Runs what is selected; progress reports leave the rest out.
[[nodiscard]] ExperimentOutcome run_selection(const Request& request, const Selection& selection,
                                              const Listeners& listeners,
                                              const ProgressFunction& progress);

/// What later tests need of those that a store to be continued has: whether all of the first ones
/// are errored, what they have covered, and what they have left over. False after reporting why
/// that cannot be read.
[[nodiscard]] bool add_earlier_tests(const Request& request, Collected& collected,
                                     Console& console);

}  // namespace jaywalk::command::compare
