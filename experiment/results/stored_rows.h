#pragma once

// Turns rows back into what they were made from. Ask the database afterwards whether all went well.

#include <vector>

#include "experiment/results/database.h"
#include "experiment/results/description.h"
#include "experiment/results/reader.h"

namespace jaywalk {

[[nodiscard]] std::vector<StoredTest> read_tests(Database& database,
                                                 const ExperimentDescription& description,
                                                 const TestFilter& filter);
[[nodiscard]] std::optional<StoredTest> read_test(Database& database,
                                                  const ExperimentDescription& description,
                                                  std::int64_t id);
[[nodiscard]] std::vector<AgentScore> read_scores(Database& database, std::int64_t test_id);
[[nodiscard]] std::vector<Assessment> read_assessments(Database& database, std::int64_t test_id);
/// REQUIRES: the store has scenes of the test.
[[nodiscard]] Recording read_recording(Database& database, double tick_s, std::int64_t test_id);

}  // namespace jaywalk
