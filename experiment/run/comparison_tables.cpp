// SPDX-License-Identifier: Apache-2.0
#include "experiment/run/comparison_tables.h"

#include "experiment/results/reader.h"

namespace jaywalk {
namespace {

/// The store is of the experiment that the user gives, whose commands may be started.
bool is_store_of(const std::string& path, const ExperimentDescription& description) {
  const auto store = ResultsReader::open(path);
  if (!store.ok()) return false;
  ExperimentDescription stored = store.value()->description();
  stored.tests = description.tests;  // there may be more now
  return difference(stored, description).empty();
}

/// Stored first tests decide about the others of their row as they did when they were run. Errored
/// ones that run again decide anew.
void add_first_tests(const StoreOptions& options, const ResultsReader& store,
                     FirstTests& first_tests, Diagnostics& trouble) {
  const ExperimentPlan plan = plan_of(store.description());
  for (std::uint64_t place = 0; place < plan.cells() * FirstTests::kCount; ++place) {
    const std::uint64_t row = place / FirstTests::kCount % plan.rows();
    const TestKey test{.behaviour = row / plan.agents.size(),
                       .agents = plan.agents[row % plan.agents.size()],
                       .number = place % FirstTests::kCount,
                       .vehicle = place / FirstTests::kCount / plan.rows()};
    if (test.number >= plan.tests) continue;
    const std::int64_t id = test_id(store.description(), test);
    const auto stored = store.test(id);
    const bool errored = stored.ok() && stored.value().result.errored;
    if (!stored.ok() || (errored && options.retry_errors)) continue;  // it is run now
    const auto error = errored ? store.error(id) : std::string();
    if (!error.ok()) return trouble.append(error.diagnostics());
    first_tests.finished(test, error.value());
  }
}

void add_situations(const Ground& ground, const ResultsReader& store, const StoredTest& stored,
                    ComparisonTables& tables, Diagnostics& trouble) {
  if (stored.result.succeeded) {
    const auto recording = store.recording(stored.id);
    if (!recording.ok()) return trouble.append(recording.diagnostics());
    tables.situations->add(stored.test, covered_bins(recording.value(), ground));
  }
  if (tables.feedback) tables.feedback->finished(stored.test);
}

void add_left_over(const ResultsReader& store, const StoredTest& stored, CarryOver& carry_over,
                   Diagnostics& trouble) {
  if (stored.result.errored) return carry_over.finished(stored.test, 0);
  const auto again = store.rerun(stored.id);
  if (!again.ok()) return trouble.append(again.diagnostics());
  carry_over.finished(stored.test, again.value().left_over);
}

/// Whether a test is the next one of the same chain.
bool follows_in_chain(const StoredTest& test, const StoredTest& next) {
  return next.test.behaviour == test.test.behaviour && next.test.agents == test.test.agents &&
         next.test.number == test.test.number + 1;
}

}  // namespace

Diagnostics add_earlier_tests(const ComparisonRequest& request,
                              const ExperimentDescription& description, ComparisonTables& tables) {
  if (!request.store || !request.store->resume) return {};
  const std::string& path = request.store->path;
  if (!is_store_of(path, description)) return {};  // it is made, or refused, later
  const auto store = ResultsReader::open(path, Commands::allowed);
  if (!store.ok()) return store.diagnostics();
  const ResultsReader& reader = *store.value();
  Diagnostics trouble;
  add_first_tests(*request.store, reader, tables.first_tests, trouble);
  if (!tables.situations && !tables.carry_over) return trouble;
  std::optional<StoredTest> last;
  const auto end_chain = [&] {
    // Only the last one of a chain is needed.
    if (tables.carry_over && last) add_left_over(reader, *last, *tables.carry_over, trouble);
  };
  const Ground ground = request.prepared->scenario().world->ground();
  const auto failure = reader.for_each_test({}, [&](const StoredTest& stored) {
    if (tables.situations) add_situations(ground, reader, stored, tables, trouble);
    if (last && !follows_in_chain(*last, stored)) end_chain();
    last = stored;
    return trouble.has_errors() ? Proceed::no : Proceed::yes;
  });
  if (!failure && !trouble.has_errors()) end_chain();
  if (failure) trouble.append(*failure);
  return trouble;
}

}  // namespace jaywalk
