#pragma once

// Turns the records of tests into rows. One thread at a time.

#include <string>
#include <vector>

#include "experiment/results/description.h"
#include "experiment/results/store/database.h"
#include "experiment/results/store/geometry.h"
#include "experiment/results/store/placement.h"
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

}  // namespace jaywalk
