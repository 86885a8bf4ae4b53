// SPDX-License-Identifier: Apache-2.0
#pragma once

// Turns the records of tests into rows, and keeps such rows for later. One thread at a time.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiment/results/description.h"
#include "experiment/results/store/database.h"
#include "experiment/results/store/geometry.h"
#include "experiment/results/test_record.h"

namespace jaywalk {

class RowWriter {
 public:
  /// Both must outlive it.
  RowWriter(Database& database, const ExperimentDescription& description);

  /// REQUIRES: within a transaction, and that the store has no such test.
  void write(const TestRecord& record);
  void write(std::int64_t test_id, std::span<const AssessmentRow> assessments);

 private:
  void write_actors(std::int64_t test_id, const TestRecord& record);
  void write_scenes(std::int64_t test_id, const Recording& recording);
  void write_events(std::int64_t test_id, const Recording& recording);
  void write_drops(std::int64_t test_id, std::span<const AgentDrop> drops);
  [[nodiscard]] PointBlob point_of(const ActorState& state) const;
  [[nodiscard]] const std::string& time_of(std::size_t tick);

  Database& database_;
  const ExperimentDescription& description_;
  Placement placement_;
  std::vector<std::string> times_;  // of the first ticks
  std::string late_time_;
  Statement test_, actor_, observation_, event_, drop_, assessment_;
};

/// Assessments of any number of tests, kept outside of memory until they can be written into their
/// store, which cannot be written while it is read. A temporary store has them.
class AssessmentSpool {
 public:
  AssessmentSpool();

  /// REQUIRES: ascending ids.
  void add(std::int64_t test_id, const std::vector<AssessmentRow>& assessments) {
    rows_->write(test_id, assessments);
  }
  /// Calls back for each test that has assessments, in their order.
  void for_each(const std::function<void(std::int64_t test_id,
                                         const std::vector<AssessmentRow>& assessments)>& callback);
  /// Why they could not be kept, if so (no space is left for temporary files).
  [[nodiscard]] std::optional<std::string> failure() const { return database_.failure(); }

 private:
  Database database_;
  ExperimentDescription description_;
  std::optional<RowWriter> rows_;  // once there are tables
};

}  // namespace jaywalk
