// SPDX-License-Identifier: Apache-2.0
#pragma once

// Turns rows back into objects. Check the database for a failure afterwards.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/results/description.h"
#include "experiment/results/reader.h"
#include "experiment/results/store/database.h"

namespace jaywalk {

void read_tests(Database& database, const ExperimentDescription& description,
                const TestFilter& filter,
                const std::function<Proceed(const StoredTest&)>& callback);
[[nodiscard]] std::optional<StoredTest> read_test(Database& database,
                                                  const ExperimentDescription& description,
                                                  std::int64_t id);
[[nodiscard]] std::vector<AgentScore> read_scores(Database& database, std::int64_t test_id);
[[nodiscard]] std::vector<AssessmentRow> read_assessments(Database& database, std::int64_t test_id);
/// The failures of the agents of the tests with ids from `first` to `last`.
[[nodiscard]] Troubles read_troubles(Database& database, std::int64_t first, std::int64_t last);
[[nodiscard]] std::vector<Actor> read_actors(Database& database, std::int64_t test_id);
/// The names of assertions, in the order in which tests were judged by them.
[[nodiscard]] std::vector<std::string> read_assertion_ids(Database& database);
void read_places(Database& database, std::string_view kind,
                 const std::function<void(std::int64_t test_id, double x_m, double y_m)>& callback);
void read_all_assessments(
    Database& database,
    const std::function<void(std::int64_t test_id, const std::vector<AssessmentRow>&)>& callback);
/// The text of the test's event of that kind; empty if there is none.
[[nodiscard]] std::string read_event(Database& database, std::int64_t test_id,
                                     std::string_view kind);
/// REQUIRES: the store has scenes of the test.
[[nodiscard]] Recording read_recording(Database& database, double tick_s, const StoredTest& test);

}  // namespace jaywalk
