// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "experiment/library/library.h"
#include "experiment/results/reader.h"
#include "interpreter/support/diagnostics.h"
#include <jaywalk/store.h>

namespace jaywalk {
namespace {

TestLine line_of(const StoredTest& stored, const ExperimentDescription& description) {
  return {.id = stored.id,
          .behaviour = description.behaviours[stored.test.behaviour].name,
          .agents = stored.test.agents,
          .test = stored.test.number,
          .vehicle = description.vehicles[stored.test.vehicle],
          .succeeded = stored.result.succeeded,
          .errored = stored.result.errored,
          .ended_by = stored.outcome.ended_by,
          .ticks = stored.outcome.ticks,
          .score = stored.result.score};
}

Diagnostics no_such_behaviour(const std::string& name,
                              const std::vector<StoredBehaviour>& behaviours) {
  std::vector<std::string> names;
  for (const StoredBehaviour& each : behaviours) names.push_back(each.name);
  Diagnostics diagnostics;
  diagnostics.error("behaviour", fmt::format("the store has no behaviour '{}'", name),
                    did_you_mean(name, names));
  return diagnostics;
}

}  // namespace

ResultsStore::ResultsStore(std::unique_ptr<ResultsReader> reader) : reader_(std::move(reader)) {}
ResultsStore::ResultsStore(ResultsStore&&) noexcept = default;
ResultsStore& ResultsStore::operator=(ResultsStore&&) noexcept = default;
ResultsStore::~ResultsStore() = default;

Result<ResultsStore> ResultsStore::open(const std::string& path) {
  auto reader = ResultsReader::open(path);
  if (!reader) return std::move(reader.diagnostics());
  return ResultsStore(std::move(reader).value());
}

std::uint64_t ResultsStore::count() const { return reader_->count(); }
bool ResultsStore::is_complete() const { return reader_->complete(); }

std::optional<Diagnostics> ResultsStore::for_each_test(
    const TestLines& wanted, const std::function<bool(const TestLine& test)>& callback) const {
  TestFilter filter{
      .agents = wanted.agents, .succeeded = wanted.succeeded, .errored = wanted.errored};
  const auto& behaviours = reader_->description().behaviours;
  if (wanted.behaviour) {
    const auto found = std::ranges::find(behaviours, *wanted.behaviour, &StoredBehaviour::name);
    if (found == behaviours.end()) return no_such_behaviour(*wanted.behaviour, behaviours);
    filter.behaviour = static_cast<std::size_t>(found - behaviours.begin());
  }
  return reader_->for_each_test(filter, [&](const StoredTest& stored) {
    return callback(line_of(stored, reader_->description())) ? Proceed::yes : Proceed::no;
  });
}

Result<TestReport> ResultsStore::test(std::int64_t id) const {
  const auto stored = reader_->test(id);
  if (!stored) return stored.diagnostics();
  const auto error = reader_->error(id);
  if (!error) return error.diagnostics();
  const auto prepared = reader_->prepared();
  if (!prepared) return prepared.diagnostics();
  auto assertions = reader_->assertions();
  if (!assertions) return assertions.diagnostics();
  const auto recording = reader_->recording(id);
  if (!recording) return recording.diagnostics();
  Criteria criteria;
  if (error.value().empty()) {
    criteria.assertions = std::move(assertions).value();
    criteria.metrics = reader_->description().metrics;
  }
  TestReport report =
      report_of(recording.value(), criteria, prepared.value()->scenario().world->ground());
  report.error = error.value();
  report.succeeded = stored.value().result.succeeded;
  report.ended_by = stored.value().outcome.ended_by;
  report.ticks = stored.value().outcome.ticks;
  report.score = stored.value().result.score;
  report.impact_mps = stored.value().outcome.impact_mps;
  return report;
}

Result<ComparisonReport> ResultsStore::comparison() const {
  const auto comparison = reader_->comparison();
  if (!comparison) return comparison.diagnostics();
  return report_of(comparison.value());
}

}  // namespace jaywalk
